#include "techniques/history/exposed_instant.h"

#include "shared/shutter_response.shared.h"

namespace timeshade {

double exposedInstant(const shared::FrameBlock& block, double share) {
    if (block.response == SHUTTER_BOX) return share;
    double low = 0.0, high = 1.0;
    for (int halving = 0; halving < 24; ++halving) {
        const double middle = 0.5 * (low + high);
        const float exposed = shared::shutterExposure(block.response, block.responseWidth, static_cast<float>(middle));
        (static_cast<double>(exposed) < share ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace timeshade
