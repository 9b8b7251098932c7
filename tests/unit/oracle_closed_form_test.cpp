// The oracle's definition of a shadow against exact answers: for a point under the light, the share of the shutter in
// which it is lit, with the instants at which that changes found by bisection.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "oracle/resolve_shadow.h"
#include "shared/frame_blocks.shared.h"

namespace timeshade::oracle {
namespace {

/// Of every receiver here, in world units.
constexpr double clearance = 1e-5;

struct Triangle {
    glm::vec3 open[3], close[3];
};

using Path = std::function<glm::dvec3(double)>;

Path at(glm::dvec3 a) {
    return [a](double) { return a; };
}
Path along(glm::dvec3 a, glm::dvec3 b) {
    return [a, b](double u) { return a + (b - a) * u; };
}

struct Quad {
    glm::vec3 open, close;
    float left = -0.5f, right = 0.5f, low = -0.4f, high = 0.6f;
};

std::vector<Triangle> quads(const std::vector<Quad>& list) {
    std::vector<Triangle> triangles;
    for (const Quad& q : list) {
        const glm::vec3 c[4] = {
            {q.left, q.low, 0.0f}, {q.right, q.low, 0.0f}, {q.right, q.high, 0.0f}, {q.left, q.high, 0.0f}};
        for (const glm::uvec3 i : {glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3)})
            triangles.push_back({{q.open + c[i.x], q.open + c[i.y], q.open + c[i.z]},
                                 {q.close + c[i.x], q.close + c[i.y], q.close + c[i.z]}});
    }
    return triangles;
}

/// The quad Q(c) of set-up "C", its centre going from c0 to c1.
Quad sliding(float c0, float c1, float z = 5.0f) { return {{c0, 0.0f, z}, {c1, 0.0f, z}}; }
Quad rising(float z0, float z1) { return {{0.0f, 0.0f, z0}, {0.0f, 0.0f, z1}}; }

std::vector<glm::vec4> pack(const std::vector<Triangle>& triangles) {
    std::vector<glm::vec4> texels(triangles.size() * TRIANGLE_POSITION_TEXELS, glm::vec4(0.0f));
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int i = 0; i < 18; ++i) {
            const auto& end = i < 9 ? triangles[t].open : triangles[t].close;
            texels[t * TRIANGLE_POSITION_TEXELS + static_cast<std::size_t>(i / 4)][i % 4] = end[i % 9 / 3][i % 3];
        }
    return texels;
}

/// Share of the shutter in which the point is lit. `steps` must be fine enough to see every interval once.
double litShare(const std::vector<Triangle>& casters, const Path& receiver, const Path& light,
                std::uint32_t own = NO_TRIANGLE, int steps = 32768) {
    const std::vector<glm::vec4> texels = pack(casters);
    const MovingTriangles triangles(texels);
    const SweptBvh bvh(triangles);
    const auto lit = [&](double u) {
        return resolveShadow(bvh, triangles, receiver(u), light(u), clearance, own, u).lit;
    };
    double sum = 0.0, u = 0.0;
    bool before = lit(0.0);
    for (int i = 1; i <= steps; ++i) {
        const double next = static_cast<double>(i) / steps;
        const bool after = lit(next);
        double low = u, high = next;
        while (before != after && high - low > 1e-13) {
            const double middle = 0.5 * (low + high);
            (lit(middle) == before ? low : high) = middle;
        }
        const double change = before != after ? 0.5 * (low + high) : next;
        sum += (before ? change - u : 0.0) + (after ? next - change : 0.0);
        u = next;
        before = after;
    }
    return sum;
}

constexpr double tolerance = 1e-9;
const Path origin = at({0.0, 0.0, 0.0});
const Path lamp = at({0.0, 0.0, 10.0});

/// When a coordinate that goes from a to b (floats) passes x.
double crossing(float a, float b, double x = 0.0) {
    return (x - static_cast<double>(a)) / (static_cast<double>(b) - static_cast<double>(a));
}

TEST(OracleClosedForm, SlidingQuads) {
    EXPECT_NEAR(litShare(quads({sliding(-1.25f, 1.25f)}), origin, lamp), 0.6, tolerance);                      // 1
    EXPECT_NEAR(litShare(quads({sliding(-1.25f, 0.0f)}), origin, lamp), 0.6, tolerance);                       // 2
    EXPECT_NEAR(litShare(quads({sliding(-1.0f, 4.0f), sliding(-3.5f, 1.5f)}), origin, lamp), 0.6, tolerance);  // 10
    EXPECT_NEAR(litShare(quads({sliding(-1.0f, 4.0f), sliding(-1.5f, 3.5f, 6.0f)}), origin, lamp), 0.7,
                tolerance);                                                                                        // 11
    EXPECT_NEAR(litShare(quads(std::vector<Quad>(3, sliding(-1.25f, 1.25f))), origin, lamp), 0.6, tolerance);      // 26
    EXPECT_NEAR(litShare(quads({sliding(0.0f, 0.0f)}), origin, lamp), 0.0, tolerance);                             // 29
    EXPECT_NEAR(litShare(quads({sliding(-1.25f, 1.25f), sliding(1.25f, -1.25f)}), origin, lamp), 0.6, tolerance);  // 30
    EXPECT_NEAR(litShare(quads({sliding(-5000.0f, 5000.0f)}), origin, lamp), 0.9999, tolerance);                   // 32
    EXPECT_NEAR(litShare(quads({sliding(-1.5f, 2.5f)}), origin, lamp), 0.75, tolerance);                           // 34
}

TEST(OracleClosedForm, MovingLightAndReceiver) {
    const std::vector<Triangle> still = quads({sliding(0.0f, 0.0f)});
    const Path lightSlides = along({-4.0, 0.0, 10.0}, {4.0, 0.0, 10.0});
    EXPECT_NEAR(litShare(still, origin, lightSlides), 0.75, tolerance);                             // 3
    EXPECT_NEAR(litShare(still, along({-4.0, 0.0, 0.0}, {4.0, 0.0, 0.0}), lamp), 0.75, tolerance);  // 4
    const Path half = along({-2.0, 0.0, 0.0}, {2.0, 0.0, 0.0}), halfAbove = along({-2.0, 0.0, 10.0}, {2.0, 0.0, 10.0});
    EXPECT_NEAR(litShare(still, half, halfAbove), 0.75, tolerance);  // 5
    EXPECT_EQ(
        litShare(quads({sliding(0.0f, 3.0f)}), along({}, {3.0, 0.0, 0.0}), along({0.0, 0.0, 10.0}, {3.0, 0.0, 10.0})),
        0.0);  // 6
    Quad aside = sliding(0.0f, 0.0f);
    aside.left = 0.5f;
    aside.right = 1.25f;
    EXPECT_NEAR(litShare(quads({aside}), at({2.0, 0.0, 0.0}), along({0.0, 0.0, 10.0}, {0.0, 0.0, 20.0})), 2.0 / 3.0,
                tolerance);  // 20
}

TEST(OracleClosedForm, PassingTheReceiverAndTheLight) {
    // The caster counts from the clearance on: what that takes off is part of the exact answer.
    EXPECT_NEAR(litShare(quads({rising(9.0f, 1.0f)}), at({0.0, 0.0, 4.0}), lamp), 0.375 + clearance / 8.0,
                tolerance);  // 7
    EXPECT_NEAR(litShare(quads({rising(5.0f, 5.0f)}), along({0.0, 0.0, 9.0}, {0.0, 0.0, 1.0}), lamp),
                (4.0 + clearance) / 8.0, tolerance);                                          // 8
    EXPECT_NEAR(litShare(quads({rising(9.5f, 11.0f)}), origin, lamp), 2.0 / 3.0, tolerance);  // 19
    const double reached = (9.0 - clearance) / 18.0;
    EXPECT_NEAR(litShare(quads({rising(8.0f, -10.0f)}), at({0.0, 0.0, -1.0}), lamp), 1.0 - reached, tolerance);  // 21
    // 28: a caster is seen down to the clearance, and not nearer.
    EXPECT_EQ(litShare(quads({rising(1e-3f, 1e-3f)}), origin, lamp), 0.0);
    EXPECT_EQ(litShare(quads({rising(1.01e-5f, 1.01e-5f)}), origin, lamp), 0.0);
    EXPECT_EQ(litShare(quads({rising(0.99e-5f, 0.99e-5f)}), origin, lamp), 1.0);
}

TEST(OracleClosedForm, ReceiversDoNotShadowThemselves) {
    // 9: a quad that rises to the light, seen inside a triangle and exactly on its diagonal.
    const std::vector<Triangle> quad = quads({rising(1.0f, 9.0f)});
    for (const std::uint32_t own : {0u, 1u}) {
        EXPECT_EQ(litShare(quad, along({0.2, 0.1, 1.0}, {0.2, 0.1, 9.0}), lamp, own), 1.0);
        EXPECT_EQ(litShare(quad, along({0.0, 0.1, 1.0}, {0.0, 0.1, 9.0}), lamp, own), 1.0);
    }
    // 27: the top of a cube that moves under the light, along its diagonal.
    std::vector<Triangle> cube = quads({{{0.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 1.0f}, -0.5f, 0.5f, -0.5f, 0.5f},
                                        {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, -0.5f, 0.5f, -0.5f, 0.5f}});
    for (const float x : {-0.5f, 0.5f}) {
        const glm::vec3 c[4] = {{x, -0.5f, 0.0f}, {x, 0.5f, 0.0f}, {x, 0.5f, 1.0f}, {x, -0.5f, 1.0f}},
                        move(1.0f, 0.0f, 0.0f);
        cube.push_back({{c[0], c[1], c[2]}, {c[0] + move, c[1] + move, c[2] + move}});
        cube.push_back({{c[0], c[2], c[3]}, {c[0] + move, c[2] + move, c[3] + move}});
    }
    for (int i = 1; i < 20; ++i) {
        const double place = i / 20.0 - 0.5;
        EXPECT_EQ(litShare(cube, along({place, place, 1.0}, {place + 1.0, place, 1.0}), lamp, 0, 4096), 1.0);
    }
}

TEST(OracleClosedForm, TurningTriangles) {
    const auto triangle = [](glm::vec2 a0, glm::vec2 a1, glm::vec2 a2, glm::vec2 b0, glm::vec2 b1, glm::vec2 b2) {
        const auto raised = [](glm::vec2 v) { return glm::vec3(v, 5.0f); };
        return std::vector<Triangle>{{{raised(a0), raised(a1), raised(a2)}, {raised(b0), raised(b1), raised(b2)}}};
    };
    // 13: flat at u = 4/11 and then over the point again.
    EXPECT_NEAR(litShare(triangle({-1, -1}, {1, -1}, {0, 1}, {-1, 1.5}, {1, 1.5}, {0, -2}), at({0.0, 0.2, 0.0}), lamp),
                0.14, tolerance);
    // 14: shrinks to a point and grows inside out; h is the float that stands for half the root of three.
    const float h = static_cast<float>(std::sqrt(0.75));
    const double exact14 = 0.7 - 0.5 * (1.0 - 0.2 - 0.15 / static_cast<double>(h));
    EXPECT_NEAR(exact14, 0.3 + 0.05 * std::sqrt(3.0), 1e-7);
    EXPECT_NEAR(
        litShare(triangle({1, 0}, {-0.5f, h}, {-0.5f, -h}, {-1, 0}, {0.5f, -h}, {0.5f, h}), at({0.4, 0.2, 0.0}), lamp),
        exact14, tolerance);
    // 16: a corner's path leads over the point.
    EXPECT_NEAR(litShare(triangle({-0.1f, -0.1f}, {0.1f, -0.1f}, {0, 0.1f}, {-2, -2}, {2, -2}, {0, 2}),
                         at({1.4, -1.4, 0.0}), lamp),
                crossing(0.1f, 2.0f, 0.7), tolerance);
    EXPECT_NEAR(crossing(0.1f, 2.0f, 0.7), 6.0 / 19.0, 1e-7);
    // 15: edge-on all the time.
    const std::vector<Triangle> edgeOn{{{{-1, 0, 4}, {0, 0, 6}, {1, 0, 4}}, {{-1, 0, 5}, {0, 0, 7}, {1, 0, 5}}}};
    EXPECT_EQ(litShare(edgeOn, origin, lamp), 1.0);
}

TEST(OracleClosedForm, ThinSmallAndMany) {
    Quad wire = sliding(-1.0f, 1.0f);  // 17
    wire.left = -0.0005f;
    wire.right = 0.0005f;
    const double exactWire =
        1.0 - (crossing(-1.0f + wire.left, 1.0f + wire.left) - crossing(-1.0f + wire.right, 1.0f + wire.right));
    EXPECT_NEAR(exactWire, 0.9995, 1e-7);
    EXPECT_NEAR(litShare(quads({wire}), origin, lamp), exactWire, tolerance);

    const glm::vec3 corner(0.0113f, 0.0071f, 5.0f);  // 18
    const std::vector<Triangle> speck{{{corner, corner + glm::vec3(1e-3f, 0, 0), corner + glm::vec3(0, 1e-3f, 0)},
                                       {corner, corner + glm::vec3(1e-3f, 0, 0), corner + glm::vec3(0, 1e-3f, 0)}}};
    EXPECT_EQ(litShare(speck, at({2.0 * 0.0116, 2.0 * 0.0074, 0.0}), lamp), 0.0);

    std::vector<Quad> comb;  // 25: a thousand slivers that pass one after the other
    double exactComb = 1.0;
    for (int i = 0; i < 1000; ++i) {
        Quad sliver{{0.0f, 0.0f, 5.0f}, {-1.0f, 0.0f, 5.0f}};
        sliver.left = static_cast<float>(i) / 1000.0f;
        sliver.right = sliver.left + 0.0005f;
        exactComb -= crossing(sliver.right, sliver.right - 1.0f) - crossing(sliver.left, sliver.left - 1.0f);
        comb.push_back(sliver);
    }
    EXPECT_NEAR(exactComb, 0.5, 1e-5);
    EXPECT_NEAR(litShare(quads(comb), origin, lamp), exactComb, tolerance);

    // 33: a coordinate without an exact float, relative to an origin far away.
    const Quad far = sliding(-1.23f, 1.23f);
    const double begins = crossing(-1.23f + 0.5f, 1.23f + 0.5f), ends = crossing(-1.23f - 0.5f, 1.23f - 0.5f);
    EXPECT_NEAR(1.0 - (ends - begins), 0.5934959, 1e-6);
    EXPECT_NEAR(litShare(quads({far}), origin, lamp), 1.0 - (ends - begins), tolerance);
}

TEST(OracleClosedForm, OneCertainCasterSettlesTheMatter) {
    const auto marginal = [](const std::vector<Quad>& list) {
        const std::vector<glm::vec4> texels = pack(quads(list));
        const MovingTriangles triangles(texels);
        return resolveShadow(SweptBvh(triangles), triangles, {0.1, 0.0, 0.0}, {0.1, 0.0, 10.0}, clearance, NO_TRIANGLE,
                             0.5)
            .marginal;
    };
    const Quad certain = sliding(0.0f, 0.0f), touching = sliding(0.6f, 0.6f, 6.0f),
               touchingBelow = sliding(0.6f, 0.6f, 4.0f);
    EXPECT_FALSE(marginal({certain}));
    EXPECT_TRUE(marginal({touching}));
    EXPECT_FALSE(marginal({touching, certain}));
    EXPECT_FALSE(marginal({touchingBelow, certain}));
}

/// No answer needed: the same shadow in another guise.
TEST(OracleClosedForm, SameShadowInAnotherGuise) {
    const Triangle t{{{-1.1f, -0.7f, 4.0f}, {0.9f, -1.2f, 5.5f}, {0.3f, 1.4f, 6.0f}},
                     {{0.4f, 1.2f, 6.5f}, {-1.3f, 0.2f, 3.0f}, {1.0f, -1.0f, 5.0f}}};
    const Path p = along({-2.8, 0.2, 0.0}, {0.6, -0.1, 0.3}), l = along({0.5, 0.0, 10.0}, {-0.5, 0.7, 9.0});
    const double share = litShare({t}, p, l);
    EXPECT_GT(share, 0.05);
    EXPECT_LT(share, 0.95);
    const Triangle turned{{t.open[1], t.open[2], t.open[0]}, {t.close[1], t.close[2], t.close[0]}};
    const Triangle flipped{{t.open[1], t.open[0], t.open[2]}, {t.close[1], t.close[0], t.close[2]}};
    EXPECT_NEAR(litShare({turned}, p, l), share, tolerance);
    EXPECT_NEAR(litShare({flipped}, p, l), share, tolerance);
    const Triangle reversed{{t.close[0], t.close[1], t.close[2]}, {t.open[0], t.open[1], t.open[2]}};
    EXPECT_NEAR(litShare(
                    {reversed}, [&](double u) { return p(1.0 - u); }, [&](double u) { return l(1.0 - u); }),
                share, tolerance);
    Triangle large = t;
    for (int v = 0; v < 3; ++v) {
        large.open[v] *= 1024.0f;
        large.close[v] *= 1024.0f;
    }
    EXPECT_NEAR(litShare(
                    {large}, [&](double u) { return 1024.0 * p(u); }, [&](double u) { return 1024.0 * l(u); }),
                share, tolerance);
    EXPECT_LE(litShare({t, quads({sliding(-1.0f, 1.0f)})[0]}, p, l),
              share + tolerance);  // another caster never adds light
}

}  // namespace
}  // namespace timeshade::oracle
