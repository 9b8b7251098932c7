// The instants at which a held history draws its map, where the shutter does not respond alike to all.
#include <gtest/gtest.h>

#include "shared/shutter_response.shared.h"
#include "techniques/history/exposed_instant.h"

namespace timeshade {
namespace {

TEST(ExposedInstant, InvertsTheExposure) {
    shared::FrameBlock block{};
    for (const std::uint32_t response : {SHUTTER_TENT, SHUTTER_GAUSSIAN})
        for (const float width : {0.05f, 1.0f / 6.0f, 2.0f}) {
            block.response = response;
            block.responseWidth = width;
            for (int i = 1; i < 256; ++i) {
                const double share = i / 256.0;
                const auto u = static_cast<float>(exposedInstant(block, share));
                ASSERT_NEAR(static_cast<double>(shared::shutterExposure(response, width, u)), share, 3e-6);
            }
        }
}

TEST(ExposedInstant, IsTheShareItselfOfABox) {
    for (int i = 0; i <= 256; ++i) ASSERT_EQ(exposedInstant({}, i / 256.0), i / 256.0);
}

}  // namespace
}  // namespace timeshade
