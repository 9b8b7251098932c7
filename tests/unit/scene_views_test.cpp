#include <cmath>

#include <gtest/gtest.h>

#include "core/one_line.h"
#include "scene/clip_clock.h"
#include "scene/fitted_views.h"

namespace timeshade {
namespace {

void expectOrthonormal(const glm::dmat3& axes) {
    const glm::dmat3 product = glm::transpose(axes) * axes;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) EXPECT_NEAR(product[c][r], c == r ? 1.0 : 0.0, 1e-12);
    EXPECT_NEAR(glm::determinant(axes), 1.0, 1e-12);
}

TEST(LookAt, KeepsUpUpright) {
    const CameraPose pose = lookAt({1, 2, 3}, {4, 5, -6}, {0, 1, 0}, 0.5, 0.1);
    expectOrthonormal(pose.axes);
    EXPECT_LE(glm::length(pose.axes[2] - glm::normalize(glm::dvec3(-3, -3, 9))), 1e-12);
    EXPECT_NEAR(pose.axes[0].y, 0.0, 1e-12);
    EXPECT_GT(pose.axes[1].y, 0.0);
}

TEST(LookAt, SurvivesEveryDegenerateView) {
    for (const glm::dvec3& target :
         {glm::dvec3(0, 5, 0), glm::dvec3(0, -5, 0), glm::dvec3(0), glm::dvec3(1e-13, -1, 0), glm::dvec3(0, 0, 3)})
        for (const glm::dvec3& up : {glm::dvec3(0, 1, 0), glm::dvec3(0), glm::dvec3(0, 0, 1), glm::dvec3(0, 1e-200, 0)})
            expectOrthonormal(lookAt(glm::dvec3(0), target, up, 0.5, 0.1).axes);
}

TEST(FittedViews, ShowAndLightTheWholeBounds) {
    for (const double size : {0.08, 1.0, 300.0})
        for (const glm::dvec3& shape : {glm::dvec3(1, 1, 1), glm::dvec3(10, 0, 1), glm::dvec3(0.1, 5, 0.1)}) {
            Bounds bounds;
            bounds.add(glm::dvec3(7.0) * size);
            bounds.add((glm::dvec3(7.0) + shape) * size);
            const CameraPose camera = fittedCamera(bounds);
            const LightPose light = fittedLight(bounds);
            expectOrthonormal(camera.axes);
            expectOrthonormal(light.axes);
            EXPECT_GT(light.position.y, bounds.high.y);
            for (int i = 0; i < 8; ++i) {
                const glm::dvec3 corner(i & 1 ? bounds.low.x : bounds.high.x, i & 2 ? bounds.low.y : bounds.high.y,
                                        i & 4 ? bounds.low.z : bounds.high.z);
                const glm::dvec3 seen = glm::transpose(camera.axes) * (corner - camera.eye);
                const double slope = std::tan(0.5 * camera.verticalFieldOfView);
                EXPECT_LE(std::abs(seen.y), slope * -seen.z);
                EXPECT_LE(std::abs(seen.x), slope * -seen.z * 4.0 / 3.0);
                EXPECT_GT(-seen.z, camera.nearDistance);
                const glm::dvec3 lit = glm::transpose(light.axes) * (corner - light.position);
                EXPECT_LE(std::atan2(std::hypot(lit.x, lit.y), -lit.z), light.outerConeAngle);
            }
        }
}

TEST(ClipClock, WrapsAnyTime) {
    const ClipClock clock(2.0, true);
    EXPECT_DOUBLE_EQ(clock.clipTime(5.0), 1.0);
    EXPECT_DOUBLE_EQ(clock.clipTime(-0.5), 1.5);
    EXPECT_DOUBLE_EQ(clock.clipTime(2.0), 0.0);
    EXPECT_DOUBLE_EQ(clock.clipTime(-1e-300), 0.0);
    EXPECT_DOUBLE_EQ(ClipClock(0.0, true).clipTime(3.0), 0.0);
    EXPECT_NEAR(clock.during(1.9, 2.3, 0.5), 0.1, 1e-12);
}

TEST(ClipClock, HoldsWhatDoesNotLoop) {
    const ClipClock clock(2.0, false);
    EXPECT_DOUBLE_EQ(clock.during(1.9, 2.3, 1.0), 2.0);
    EXPECT_DOUBLE_EQ(clock.during(21.9, 22.3, 1.0), 2.0);
    EXPECT_DOUBLE_EQ(clock.during(-0.1, 0.1, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(clock.during(-0.1, 0.1, 1.0), 0.1);
    EXPECT_DOUBLE_EQ(clock.clipTime(-7.0), 0.0);
    EXPECT_DOUBLE_EQ(clock.clipTime(2.5), 2.0);
}

TEST(OneLine, CutsAndCleans) {
    EXPECT_EQ(oneLine("a\nb\tc\n"), "a b c");
    EXPECT_EQ(oneLine("abcdef", 5), "ab...");
    EXPECT_EQ(oneLine("ab\xc3\xa4xyz", 6), "ab...");  // not in the middle of a character
}

TEST(OneLine, TheLastOneIsThatWithWords) {
    EXPECT_EQ(lastLine("first\nsecond\tword\r\n \n", 40), "second word");
    EXPECT_EQ(lastLine("alone", 40), "alone");
    EXPECT_EQ(lastLine("first\nabcdef", 5), "ab...");
    EXPECT_EQ(lastLine(" \n\r\n", 40), "");
    EXPECT_EQ(lastLine("", 40), "");
}

}  // namespace
}  // namespace timeshade
