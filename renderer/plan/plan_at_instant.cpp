// One render of a frame that is accumulated from many.

#include "core/check.h"
#include "plan/frame_plan.h"
#include "shared/hash.shared.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {

namespace {

float instantOf(int m, int renders) { return (static_cast<float>(m) + 0.5f) / static_cast<float>(renders); }

float weightOf(const shared::FrameBlock& block, int m, int renders) {
    if (block.response == SHUTTER_BOX) return 1.0f / static_cast<float>(renders);
    const auto weight = [&](int i) {
        return static_cast<double>(shared::shutterWeight(block.response, block.responseWidth, instantOf(i, renders)));
    };
    double sum = 0.0;
    for (int i = 0; i < renders; ++i) sum += weight(i);
    return static_cast<float>(weight(m) / sum);
}

}  // namespace

FramePlan planAtInstant(const FramePlan& plan, int m, int renders) {
    CHECK_GE(m, 0);
    CHECK_LT(m, renders);
    FramePlan instant = plan;
    // Its samples differ from the frame's, so nothing cached for those may be used.
    instant.versions.samples = instant.versions.lit = 0;
    instant.block.timeBase = instantOf(m, renders);
    instant.block.timeScale = 0.0f;
    instant.block.strata = 1;
    instant.block.seed = shared::hashWords({plan.block.seed, static_cast<std::uint32_t>(m), 0x51ed27u}).x;
    instant.block.weight = weightOf(plan.block, m, renders);
    instant.request.samplesPerPixel = 1;
    return instant;
}

}  // namespace timeshade
