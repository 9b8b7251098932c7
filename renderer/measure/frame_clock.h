#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "measure/frame_state.h"

namespace timeshade {

struct ClockedFrame {
    FrameState state = FrameState::Steady;
    std::vector<gl::PassTimer::Reading> readings;
    double planMilliseconds = 0.0;   ///< of the processor, before the device is told anything
    double wholeMilliseconds = 0.0;  ///< by the clock on the wall, from the plan to the device having done all
    std::uint64_t waits = 0;         ///< how often the processor waited for the device within the frame (gl/waits.h)
    std::uint64_t uploaded = 0;      ///< bytes that it handed to the device (gl/uploads.h)
};

/// The readings by name, parts ("build/collect") too, and their sum without the parts as "total". Milliseconds.
std::map<std::string, double> stepsOf(const std::vector<gl::PassTimer::Reading>& readings);

/// Times frames of one scene in the states that are named above. No timed frame compiles a program: where one did, the
/// technique is warmed up and all of them are drawn and timed again.
class FrameClock {
  public:
    /// `techniqueView`: one of the technique's own instead of `view`, or empty.
    /// `counts` read later: as in the window; buffers then have more room than a frame needs.
    FrameClock(FrameRenderer& renderer, FramePlanner& planner, View view, std::string techniqueView = {},
               gl::LateCounts::Reading counts = gl::LateCounts::Reading::AtOnce)
        : renderer_(renderer),
          planner_(planner),
          view_(view),
          techniqueView_(std::move(techniqueView)),
          counts_(counts) {}

    /// To be called once for every technique, size and sample count, before its first frame is timed: compiles. Draws
    /// the very frames that time() will draw, since a driver compiles for states that other frames need not have.
    void warmUp(Technique& technique, const FrameRequest& request, int steadyFrames);

    /// Times the requested frame with nothing cached (Cold), then the frame before the steady ones (Filling), then
    /// `steadyFrames` frames of which the requested one is the last (Steady). A technique with a history is warmed up
    /// as it says before its steady frames, has no Filling frame, and at most as many steady ones as it draws frames
    /// for its warm-up, and one. Brute force fills and uses its caches within every frame: no Filling frame either.
    /// Afterwards the renderer holds the requested frame, as any other command would draw it.
    std::vector<ClockedFrame> time(Technique& technique, const FrameRequest& request, int steadyFrames);

  private:
    std::vector<ClockedFrame> timeOnce(Technique& technique, const FrameRequest& request, int steadyFrames);
    ClockedFrame draw(Technique& technique, FrameRequest request, double frame, FrameState state);
    ClockedFrame drawOnce(Technique& technique, const FrameRequest& request, FrameState state);

    FrameRenderer& renderer_;
    FramePlanner& planner_;
    View view_;
    std::string techniqueView_;
    gl::LateCounts::Reading counts_;
    bool compiled_ = false;  ///< a timed frame did
};

}  // namespace timeshade
