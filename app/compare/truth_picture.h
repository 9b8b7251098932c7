#pragma once

#include <functional>
#include <optional>

#include "frame/frame_renderer.h"
#include "measure/reference.h"

namespace timeshade {

/// How the ground truth of a request is made as a picture: for window, pictures and videos the same, so that they find
/// it in the cache of each other. The plan has the most samples, because those of a technique may be too few for all of
/// its motion steps.
FramePlan truthPlan(FramePlanner& planner, FrameRequest request);
ReferenceOptions truthOptions(View view);
/// As it is shown: visibility is a share of light, without exposure and tone map.
DisplayImage truthShown(const LinearImage& truth, View view, const DisplayLook& look);

/// The ground truth of a request. `progress` is called before every batch of samples; where it returns false, the work
/// is cancelled and nothing is returned.
std::optional<LinearImage> drawTruth(FrameRenderer& renderer, FramePlanner& planner, const FrameRequest& request,
                                     View view, const std::function<bool(int done, int all)>& progress);

}  // namespace timeshade
