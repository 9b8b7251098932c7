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
    int staticFrames = 0;                       ///< frames since the camera came to rest
    bool cameraStopped = false;                 ///< the frame before was the last of a movement of the camera
    int unmovedFrames = 0;                      ///< frames since anything moved at all, or since there was no past
    std::vector<std::uint32_t> dynamicCasters;  ///< triangles that moved, in ascending order
};

/// Remembers what the frame before looked like, and finds out what has changed since. A change of size, samples, map,
/// seed, shutter, scene, camera bookmark or settings, a step back in time or one of more than eight frames begins anew.
class HistoryState {
  public:
    FrameTransition follow(const FramePlan& plan, const std::vector<double>& settings);
    void forget() { past_.reset(); }

    /// The frame before; only where the sequel has a past.
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
    /// The frame that the last sequel followed; null where it had none.
    const Past* before() const { return before_ ? &*before_ : nullptr; }

  private:
    std::optional<Past> past_, before_;
};

}  // namespace timeshade
