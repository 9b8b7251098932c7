#pragma once

#include <functional>
#include <string>

#include "frame/frame_renderer.h"
#include "measure/reference_cache.h"

namespace timeshade {

/// A converged picture of a frame: many stratified camera samples per pixel, each with the oracle's truth.
struct ReferenceOptions {
    int samplesPerPixel = 256;  ///< rounded up to whole batches of maximumSamplesPerPixel
    View view = View::Final;    ///< Visibility: the lit share alone
    std::function<void(int, int)> progress;  ///< batches done, of how many
};

/// Draws the reference, or takes it from the cache. The key holds everything that the picture depends on: mesh, light,
/// camera, materials, size, samples, shading version.
LinearImage referenceImage(FrameRenderer& renderer, const FramePlan& plan, const ReferenceOptions& options, ReferenceCache& cache);

/// The cache key: two frames with one key have one reference.
std::string referenceKey(const FramePlan& plan, const ReferenceOptions& options);

} // namespace timeshade
