#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

#include "shared/hash.shared.h"

namespace timeshade {

/// Numbers that provoke rounding errors: random ones from a counter, fast enough for millions. The same on every
/// machine.
class AwkwardNumbers {
  public:
    explicit AwkwardNumbers(std::uint32_t seed) : seed_(shared::hashWord(seed)) {}

    std::uint32_t word() {
        if (used_ == 3) {
            words_ = shared::hashWords({counter_++, seed_, 0x51ed270bu});
            used_ = 0;
        }
        return words_[static_cast<glm::length_t>(used_++)];
    }
    std::uint32_t below(std::uint32_t n) {
        return static_cast<std::uint32_t>((static_cast<std::uint64_t>(word()) * n) >> 32);
    }
    bool oneIn(std::uint32_t n) { return below(n) == 0; }
    /// In [0, 1), of 24 bits.
    float unit() { return shared::unitInterval(word()); }
    float between(float low, float high) { return low + (high - low) * unit(); }
    /// Mostly of the size 1; now and then a small whole number, so that differences cancel, or 0.
    float coordinate() {
        const std::uint32_t kind = below(16);
        if (kind == 0) return 0.0f;
        if (kind < 4) return static_cast<float>(static_cast<int>(below(9)) - 4);
        if (kind == 4) return between(-2.0f, 2.0f) * std::exp2(static_cast<float>(static_cast<int>(below(41)) - 20));
        return between(-2.0f, 2.0f);
    }
    glm::vec3 point() {
        const float x = coordinate(), y = coordinate(), z = coordinate();
        return {x, y, z};
    }
    /// Nearly, or exactly, the given number: some units in the last place away.
    float near(float x) {
        const int steps = static_cast<int>(below(7)) - 3;
        float moved = x;
        for (int i = 0; i < std::abs(steps); ++i) moved = std::nextafter(moved, steps > 0 ? 1e30f : -1e30f);
        return moved;
    }
    glm::vec3 near(const glm::vec3& p) {
        const float x = near(p.x), y = near(p.y), z = near(p.z);
        return {x, y, z};
    }
    /// Any bits at all that are no NaN and no infinity: denormal, huge, tiny.
    float anyFinite() {
        for (;;) {
            const float x = std::bit_cast<float>(word());
            if (std::isfinite(x)) return x;
        }
    }

  private:
    std::uint32_t seed_, counter_ = 0;
    glm::uvec3 words_{0};
    int used_ = 3;
};

/// A segment from the origin and a triangle, as a receiver sees them.
struct SegmentAndTriangle {
    glm::vec3 toLight, v[3];
};

/// Half of them random; the rest through an edge or a corner, in the triangle's plane, with a triangle that is thin,
/// far, tiny or a point, with a receiver on the triangle, and with the whole scaled.
inline SegmentAndTriangle awkwardSegmentAndTriangle(AwkwardNumbers& numbers) {
    SegmentAndTriangle s;
    s.toLight = numbers.point();
    for (glm::vec3& v : s.v) v = numbers.point();
    switch (numbers.below(12)) {
    case 0: {  // towards a point of an edge
        const float t = numbers.unit();
        s.toLight = (s.v[0] * (1.0f - t) + s.v[1] * t) * numbers.between(1.0f, 3.0f);
        break;
    }
    case 1: s.toLight = numbers.near(s.v[numbers.below(3)]) * 2.0f; break;  // towards a corner
    case 2: {                                                               // the plane nearly holds the segment
        const glm::vec3 inPlane = s.v[0] * numbers.between(-1.0f, 2.0f) + s.v[1] * numbers.between(-1.0f, 2.0f);
        s.toLight = numbers.near(inPlane);
        s.v[2] = numbers.near(s.v[0] * numbers.between(-1.0f, 2.0f) + s.v[1] * numbers.between(-1.0f, 2.0f));
        break;
    }
    case 3: s.v[2] = numbers.near(s.v[0] * 0.5f + s.v[1] * 0.5f); break;  // without area, nearly
    case 4:
        s.v[1] = numbers.near(s.v[0]);
        s.v[2] = numbers.near(s.v[0]);
        break;  // a point, nearly
    case 5: {   // the receiver lies on the triangle, nearly
        const glm::vec3 on = s.v[0] * 0.25f + s.v[1] * 0.5f + s.v[2] * 0.25f;
        for (glm::vec3& v : s.v) v = v - on;
        break;
    }
    default: {  // through the triangle's inside
        const float a = numbers.unit(), b = numbers.unit() * (1.0f - a);
        if (numbers.oneIn(2))
            s.toLight = (s.v[0] * a + s.v[1] * b + s.v[2] * (1.0f - a - b)) * numbers.between(0.5f, 3.0f);
        break;
    }
    }
    if (numbers.oneIn(8)) {
        const float scale = std::exp2(static_cast<float>(static_cast<int>(numbers.below(25)) - 12));
        s.toLight *= scale;
        for (glm::vec3& v : s.v) v *= scale;
    }
    return s;
}

}  // namespace timeshade
