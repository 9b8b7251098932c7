#pragma once

#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "options/picture_options.h"
#include "scene/scene.h"

namespace timeshade {

struct ComparedShot {
    DisplayImage picture;
    std::string manifests;      ///< JSON: an object {"compare": [of the first, of the second]}
    double milliseconds = 0.0;  ///< of what techniques have drawn
};

/// What a picture says of a side that no technique has drawn, as JSON: the ground truth with its samples per pixel, or
/// a file.
std::string manifestOfSide(const std::string& name, int samples, int width, int height);

/// The picture that --compare asks for, of one frame.
ComparedShot drawCompared(FrameRenderer& renderer, FramePlanner& planner, const FrameRequest& request,
                          const PictureOptions& options, const Scene& scene, const std::string& backEnd);

}  // namespace timeshade
