#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "measure/reference_cache.h"

namespace timeshade {

/// A converged picture of a frame: many stratified camera samples per pixel, each with the oracle's truth, weighted by
/// the shutter's response.
struct ReferenceOptions {
    int samplesPerPixel = 256;               ///< rounded up to whole batches of maximumSamplesPerPixel
    View view = View::Final;                 ///< Visibility: the lit share alone
    std::function<void(int, int)> progress;  ///< batches done, of how many
};

class ReferenceTechnique;

/// Makes a reference a batch at a time, so that a window stays alive meanwhile. The cache must outlive it.
class ReferenceBuilder {
  public:
    ReferenceBuilder(FramePlan plan, const ReferenceOptions& options, const ReferenceCache& cache);
    ~ReferenceBuilder();
    ReferenceBuilder(const ReferenceBuilder&) = delete;
    ReferenceBuilder& operator=(const ReferenceBuilder&) = delete;

    bool complete() const { return !image_.rgb.empty(); }
    int batchesDone() const { return done_; }
    int batches() const { return batches_; }
    /// Samples per pixel of the whole picture.
    int samplesPerPixel() const { return batches_ * maximumSamplesPerPixel; }
    /// Looks into the cache the first time and draws one batch after that. True when the picture is complete.
    bool step(FrameRenderer& renderer);
    /// The picture, once it is complete.
    const LinearImage& image() const { return image_; }
    /// The mean of the batches done, of which there must be one, or the picture.
    LinearImage soFar() const;

  private:
    void add(const FramePlan& drawn, const LinearImage& batch);
    void finish();

    FramePlan plan_;
    View view_;
    const ReferenceCache& cache_;
    std::unique_ptr<ReferenceTechnique> truth_;
    std::string key_;
    int batches_, done_ = 0;
    bool soughtInCache_ = false;
    std::vector<double> sum_;      ///< of each value over the batches, times its pixel's weights
    std::vector<double> weights_;  ///< of each pixel's samples together; empty where all count alike
    LinearImage image_;
};

/// Draws the reference, or takes it from the cache. The key holds everything that the picture depends on: mesh, light,
/// camera, materials, size, samples, shading version.
LinearImage referenceImage(FrameRenderer& renderer, const FramePlan& plan, const ReferenceOptions& options,
                           ReferenceCache& cache);

/// The cache key: two frames with one key have one reference.
std::string referenceKey(const FramePlan& plan, const ReferenceOptions& options);

}  // namespace timeshade
