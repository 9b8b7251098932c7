#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "plan/frame_plan.h"

namespace timeshade {

/// What a frame is to the one drawn before it.
struct FrameTransition {
    bool hasPast = false;  ///< what was known may be used, as far as it can be found again
    bool moved = false;    ///< the camera, or something in the scene
    bool cameraMoved = false;
    bool held = false;  ///< the very same moment again
    std::uint32_t index =
        0;  ///< number of the map's rasterisation: grows with the frame's number and every repetition of it
    int heldFrames = 0;                         ///< how often the moment has been drawn before
    int staticFrames = 0;                       ///< frames since the camera stopped
    bool cameraStopped = false;                 ///< the previous frame was the last in which the camera moved
    int unmovedFrames = 0;                      ///< frames since anything moved at all, or since there was no past
    std::vector<std::uint32_t> dynamicCasters;  ///< triangles that moved, in ascending order
};

/// Stores the previous frame and determines what has changed since. The history starts again after a change of size,
/// samples, map, seed, shutter and its response, scene, camera bookmark or settings, a step back in time, or one of
/// more than eight frames.
class HistoryState {
  public:
    FrameTransition follow(const FramePlan& plan, const std::vector<double>& settings);
    void forget() { past_.reset(); }

    /// The previous frame; only if the transition has a past.
    struct Past {
        FrameRequest request;
        std::shared_ptr<const MeshTopology> topology;
        std::shared_ptr<const MeshTexels> texels;
        ViewPlan camera;
        LightPose lightOpen, lightClose;
        std::vector<double> settings;
        int heldFrames = 0, staticFrames = 0, unmovedFrames = 0;
        bool cameraMoved = false;
    };
    /// The frame before the last one that was followed; null if it had none.
    const Past* before() const { return before_ ? &*before_ : nullptr; }

  private:
    std::optional<Past> past_, before_;
};

}  // namespace timeshade
