#include "measure/frame_state.h"

namespace timeshade {

std::string nameOf(FrameState state) {
    switch (state) {
    case FrameState::Cold: return "cold";
    case FrameState::Filling: return "filling";
    case FrameState::Steady: break;
    }
    return "steady";
}

std::optional<FrameState> frameStateNamed(const std::string& name) {
    for (const FrameState state : {FrameState::Cold, FrameState::Filling, FrameState::Steady})
        if (nameOf(state) == name) return state;
    return std::nullopt;
}

}  // namespace timeshade
