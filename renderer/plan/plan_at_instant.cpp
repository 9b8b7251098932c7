// One render of a frame that is accumulated from many.

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "plan/frame_plan.h"
#include "plan/own_samples.h"
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
    FramePlan instant = pieceOf(plan, m, renders);
    const auto steps = static_cast<float>(std::max<std::size_t>(1, plan.pieces.size()));
    keepNoSamples(instant);
    // In its piece: whole steps are a power of two, so that this is exact.
    const float u = instantOf(m, renders) * steps;
    instant.block.timeBase = plan.pieces.empty() ? u : u - std::min(std::floor(u), steps - 1.0f);
    instant.block.timeScale = 0.0f;
    instant.block.strata = instant.block.wholeStrata = 1;
    instant.block.firstStratum = 0;
    instant.block.seed = shared::hashWords({plan.block.seed, static_cast<std::uint32_t>(m), 0x51ed27u}).x;
    instant.block.weight = weightOf(plan.block, m, renders);
    instant.request.samplesPerPixel = 1;
    return instant;
}

}  // namespace timeshade
