#include "cases/closed_form_cases.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/set_up_c.h"
#include "core/error.h"
#include "shared/facing.shared.h"

namespace timeshade {

namespace {

using glm::dvec3;

/// Collects the rows.
class Catalogue {
  public:
    ClosedFormCase& add(int row, std::string name, double exact, int ends, std::string motion, std::string breaks) {
        ClosedFormCase c;
        c.row = row;
        c.name = std::move(name);
        c.exact = exact;
        c.ends = ends;
        c.motion = std::move(motion);
        c.breaks = std::move(breaks);
        cases_.push_back(std::move(c));
        return cases_.back();
    }
    ClosedFormCase& numeric(int row, std::string name, double exact, std::string motion, std::string breaks,
                            double (*evaluate)()) {
        ClosedFormCase& c = add(row, std::move(name), exact, 0, std::move(motion), std::move(breaks));
        c.kind = ClosedFormCase::Kind::Numeric;
        c.evaluate = evaluate;
        return c;
    }
    std::vector<ClosedFormCase> take() { return std::move(cases_); }

  private:
    std::vector<ClosedFormCase> cases_;
};

MovingCorners inPlane(double z, const glm::dvec2 (&open)[3], const glm::dvec2 (&close)[3]) {
    MovingCorners t{};
    for (int i = 0; i < 3; ++i) {
        t.open[i] = dvec3(open[i], z);
        t.close[i] = dvec3(close[i], z);
    }
    return t;
}

/// Share of the shutter during which the dot product of two vectors that change linearly is positive.
double facingShare(glm::vec3 normalOpen, glm::vec3 normalClose, glm::vec3 lightOpen, glm::vec3 lightClose) {
    const glm::vec3 b = shared::facingCoefficients(normalOpen, normalClose, lightOpen, lightClose);
    const glm::vec4 lit = shared::positiveIntervals(b.x, b.y, b.z);
    return static_cast<double>(lit.y - lit.x + lit.w - lit.z);
}

void addSlidingQuads(Catalogue& all) {
    SetUpC()
        .slidingQuad(-1.25, 1.25)
        .finish(all.add(1, "quad_sweeps_point", 0.6, 2, "c = -1.25 + 2.5u; dark [.3, .7]",
                        "nothing: the baseline; TSM's noise"));
    SetUpC()
        .slidingQuad(-1.25, 0.0)
        .finish(all.add(2, "quad_enters", 0.6, 1, "c = -1.25 + 1.25u; dark [.6, 1]",
                        "one instant for all: the share of case 1 at other times"));
    SetUpC()
        .slidingQuad(0.0, 0.0)
        .light({-4.0, 0.0, 10.0}, {4.0, 0.0, 10.0})
        .finish(all.add(3, "light_slides", 0.75, 2, "Q(0) static, light x -4 to 4; dark [.375, .625]",
                        "one light matrix for the whole shutter"));
    SetUpC()
        .slidingQuad(0.0, 0.0)
        .receiver({-4.0, 0.0, 0.0}, {4.0, 0.0, 0.0})
        .finish(all.add(4, "receiver_slides", 0.75, 2, "Q(0) static, receiver x -4 to 4; dark [.375, .625]",
                        "few samples along a moving receiver"));
    SetUpC()
        .slidingQuad(0.0, 0.0)
        .light({-2.0, 0.0, 10.0}, {2.0, 0.0, 10.0})
        .receiver({-2.0, 0.0, 0.0}, {2.0, 0.0, 0.0})
        .finish(all.add(5, "light_and_receiver_slide", 0.75, 2, "light and receiver x -2 to 2; dark [.375, .625]",
                        "motions that cancel: static in the map, moving in the world"));
    SetUpC()
        .slidingQuad(0.0, 3.0)
        .light({0.0, 0.0, 10.0}, {3.0, 0.0, 10.0})
        .receiver({0.0, 0.0, 0.0}, {3.0, 0.0, 0.0})
        .finish(all.add(6, "all_comoving", 0.0, 0, "quad, light and receiver + (3, 0, 0)",
                        "cancellation: must be exactly dark"));
}

void addMotionAlongTheLight(Catalogue& all) {
    SetUpC()
        .risingQuad(9.0, 1.0)
        .receiver({0.0, 0.0, 4.0}, {0.0, 0.0, 4.0})
        .point(1e-4)
        .cameraHeight(2e-4)
        .finish(all.add(7, "occluder_passes_receiver", 0.375, 1, "quad z 9 to 1, receiver z 4; dark while z > 4",
                        "mismatched times, VSM's depths"));
    SetUpC()
        .slidingQuad(0.0, 0.0)
        .receiver({0.0, 0.0, 9.0}, {0.0, 0.0, 1.0})
        .point(1e-4)
        .cameraHeight(2e-4)
        .finish(all.add(8, "receiver_passes_occluder", 0.5, 1, "receiver z 9 to 1, Q at 5; dark [.5, 1]",
                        "a constant depth per interval"));
    SetUpC()
        .risingQuad(1.0, 9.0)
        .receiver({0.0, 0.1, 1.0}, {0.0, 0.1, 9.0})
        .cameraHeight(0.5)
        .column(0.7)
        .receiverIsCaster()
        .finish(
            all.add(9, "approaching_self", 1.0, 0, "receiver on Q, z 1 to 9", "TSM's self-shadow: 1/2 (1 - bN/v)^2"));
}

void addSeveralIntervals(Catalogue& all) {
    SetUpC().slidingQuad(-1.0, 4.0).slidingQuad(-3.5, 1.5).finish(
        all.add(10, "two_disjoint", 0.6, 4, "c = -1 + 5u and -3.5 + 5u; dark [.1, .3] and [.6, .8]",
                "products of layers: .64"));
    SetUpC()
        .slidingQuad(-1.0, 4.0)
        .slidingQuad(-1.5, 3.5, 6.0)
        .finish(all.add(11, "two_overlap", 0.7, 2, "c = -1 + 5u at z 5, -1.5 + 5u at z 6; dark [.1, .4]",
                        "products .64, sums .6"));
    SetUpC()
        .slidingQuad(-1.25, 1.25)
        .narrowReceiver(1e-3, 5e-3)
        .point(1e-6)
        .cameraHeight(1e-3)
        .finish(all.add(12, "visible_only_while_dark", 0.0, 0, "case 1; the camera sees the receiver in [.3, .7] only",
                        "shadow averaged apart from what is seen: .6"));
}

void addTurningTriangles(Catalogue& all) {
    // The segment from (x, y, 0) to the light passes z = 5 at (x, y) / 2.
    SetUpC()
        .triangle(inPlane(5.0, {{-1.0, -1.0}, {1.0, -1.0}, {0.0, 1.0}}, {{-1.0, 1.5}, {1.0, 1.5}, {0.0, -2.0}}))
        .receiver({0.0, 0.2, 0.0}, {0.0, 0.2, 0.0})
        .point(1e-3)
        .finish(all.add(13, "flip_triangle", 0.14, 2, "flips over at u = 4/11; dark [0, .3] and [.44, 1]",
                        "first and last: 0; covered at both ends, not between"));
    const double h = 0.5 * std::sqrt(3.0);
    SetUpC()
        .triangle(inPlane(5.0, {{1.0, 0.0}, {-0.5, h}, {-0.5, -h}}, {{-1.0, 0.0}, {0.5, -h}, {0.5, h}}))
        .receiver({0.4, 0.2, 0.0}, {0.4, 0.2, 0.0})
        .point(1e-3)
        .finish(all.add(14, "invert_triangle", 0.3 + 0.05 * std::sqrt(3.0), 2,
                        "point-mirrored through its centre; dark [0, .3134] and [.7, 1]",
                        "first and last: 0; ranges paired by depth"));
    SetUpC()
        .triangle({{{-1.0, 0.0, 4.0}, {0.0, 0.0, 6.0}, {1.0, 0.0, 4.0}},
                   {{-1.0, 0.0, 5.0}, {0.0, 0.0, 7.0}, {1.0, 0.0, 5.0}}})
        .point(1e-3)
        .finish(all.add(15, "edge_on", 1.0, 0, "a triangle edge-on to the light, z + 1",
                        "no volume: 0/0 in the hit distance"));
    SetUpC()
        .triangle(inPlane(5.0, {{-0.1, -0.1}, {0.1, -0.1}, {0.0, 0.1}}, {{-2.0, -2.0}, {2.0, -2.0}, {0.0, 2.0}}))
        .receiver({1.4, -1.4, 0.0}, {1.4, -1.4, 0.0})
        .point(1e-3)
        .finish(all.add(16, "vertex_path", 6.0 / 19.0, 1, "a vertex passes over the segment; dark [6/19, 1]",
                        "ties: an unpaired crossing"));
}

void addThinAndFarCasters(Catalogue& all) {
    ClosedFormCase& wire =
        all.add(17, "thin_wire_fast", 0.9995, 2, "width .001, c = -1 + 2u", "TSM below 2000 strata sees it by chance");
    wire.fleeting = true;
    SetUpC().slidingQuad(-1.0, 1.0, 5.0, 0.0005).finish(wire);
    ClosedFormCase& speck = all.add(18, "subtexel_static", 0.0, 0, "a static triangle of size .001 over the receiver",
                                    "maps sampled at texel centres: 1");
    speck.fleeting = true;
    const glm::dvec2 m(0.0113, 0.0071),
        corners[3] = {m + glm::dvec2(-5e-4, -5e-4), m + glm::dvec2(5e-4, -5e-4), m + glm::dvec2(0.0, 5e-4)};
    SetUpC()
        .triangle(inPlane(5.0, corners, corners))
        .receiver({2.0 * m, 0.0}, {2.0 * m, 0.0})
        .point(2e-4)
        .finish(speck);
    SetUpC().risingQuad(9.5, 11.0).finish(all.add(19, "past_the_light", 2.0 / 3.0, 1,
                                                  "Q(0), z 9.5 to 11; dark while z < 10",
                                                  "w <= 0; a near plane at .1 loses to .7333"));
    MovingQuad still = slidingQuad({0.875, 0.0, 5.0}, {0.875, 0.0, 5.0}, 0.375, -0.4, 0.6);
    SetUpC()
        .quad(still)
        .light({0.0, 0.0, 10.0}, {0.0, 0.0, 20.0})
        .receiver({2.0, 0.0, 0.0}, {2.0, 0.0, 0.0})
        .column(1.2)  // 1.4 would reach beyond the quad's end at y = -.4, as the light rises
        .finish(all.add(20, "light_recedes", 2.0 / 3.0, 1,
                        "light z 10 to 20, x in [.5, 1.25] static, receiver x 2; dark [0, 1/3]",
                        "a linear path in light space: .5"));
    SetUpC()
        .risingQuad(8.0, -10.0)
        .receiver({0.0, 0.0, -1.0}, {0.0, 0.0, -1.0})
        .point(1e-4)
        .cameraHeight(2e-4)
        .finish(all.add(21, "ndc_range_lerp", 0.5, 1, "quad at distance 2 to 20, receiver at 11",
                        "interpolated NDC depth: .0909"));
}

void addNumericCases(Catalogue& all) {
    all.numeric(22, "turning_receiver", 0.5, "normal (0, 0, 1) to (0, 0, -1), static light, no caster",
                "normalising the normal that vanishes half-way", [] {
                    return facingShare({0, 0, 1}, {0, 0, -1}, {0, 0, 10}, {0, 0, 10});
                });
    all.numeric(23, "facing_double_root", 1.0, "normal and light both flip: f = (1 - 2u)^2", "a discriminant of 0", [] {
        return facingShare({0, 0, 1}, {0, 0, -1}, {0, 0, 1}, {0, 0, -1});
    });
    // f = a u^2 - .5 u + .2 with a = 1e-8; its Bernstein coefficients are f(0), f(0) + f'(0) / 2 and f(1).
    all.numeric(24, "facing_tiny_a", 0.4, "f = 1e-8 u^2 - .5 u + .2", "the textbook formula: 1.49", [] {
        const glm::vec4 lit = shared::positiveIntervals(0.2f, -0.05f, static_cast<float>(1e-8 - 0.3));
        return static_cast<double>(lit.y - lit.x);
    });
}

void addManyCasters(Catalogue& all) {
    ClosedFormCase& comb =
        all.add(25, "many_slivers", 0.5, 2000, "1000 quads; dark [i/1000, i/1000 + .0005]", "lists that overflow");
    comb.fleeting = true;
    SetUpC slivers;
    for (int i = 0; i < 1000; ++i) {
        const double c = -10.0 * i / 1000.0 - 0.0025;  // moves by 10: over the receiver at i / 1000
        slivers.slidingQuad(c, c + 10.0, 5.0, 0.0025);
    }
    slivers.finish(comb);
    SetUpC()
        .slidingQuad(-1.25, 1.25)
        .slidingQuad(-1.25, 1.25)
        .slidingQuad(-1.25, 1.25)
        .finish(all.add(26, "triplicate", 0.6, 2, "case 1, three times the same", "ties, double counting"));

    SetUpC cube;
    const auto face = [](const dvec3& o, const dvec3& a, const dvec3& b) {
        MovingQuad q{{o, o + a, o + a + b, o + b}, {}};
        for (int i = 0; i < 4; ++i) q.close[i] = q.open[i] + dvec3(1.0, 0.0, 0.0);
        return q;
    };
    const dvec3 x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0), low(-0.5);
    cube.quad(face(low, y, x))
        .quad(face(low, x, z))
        .quad(face(low + x, y, z))
        .quad(face(low + x + y, -x, z))
        .quad(face(low + y, -y, z));
    cube.quad(face(low + z, x, y)).receiver({0.0, 0.0, 0.5}, {1.0, 0.0, 0.5}).point(0.2).receiverIsCaster();
    cube.finish(all.add(27, "cube_top", 1.0, 0, "unit cube + (1, 0, 0), receiver on the top's diagonal",
                        "excluding only the receiver's own triangle: 24.7 % false near the diagonal"));
}

void addContactAndLimits(Catalogue& all) {
    SetUpC()
        .slidingQuad(0.0, 0.0, 1e-3)
        .point(1e-4)
        .cameraHeight(5e-4)
        .finish(all.add(28, "contact", 0.0, 0, "a static quad .001 above the receiver", "any bias above the gap"));
    SetUpC().slidingQuad(0.0, 0.0).finish(
        all.add(29, "static_all", 0.0, 0, "nothing moves", "motion vectors of length 0, first = last"));
    SetUpC()
        .slidingQuad(-1.25, 1.25)
        .slidingQuad(1.25, -1.25)
        .finish(all.add(30, "opposite_motion", 0.6, 2, "c = -1.25 + 2.5u and 1.25 - 2.5u", "a mean motion of 0"));
    SetUpC()
        .slidingQuad(0.0, 1.0, 9.0)
        .slidingQuad(-1.0, 0.0, 1.0)
        .point(1e-3)
        .cameraHeight(0.5)
        .finish(all.add(31, "vsm_bleed", 0.0, 2, "casters at distance 1 and 9, half of the time each",
                        "variance shadow maps: .39"));
    ClosedFormCase& bullet = all.add(32, "bullet", 0.9999, 2, "c = -5000 + 10000u", "times in floats, sub-steps");
    bullet.fleeting = true;
    SetUpC().slidingQuad(-5000.0, 5000.0).finish(bullet);
    SetUpC()
        .slidingQuad(-1.23, 1.23)
        .offset(dvec3(1e4))
        .finish(all.add(33, "far_world", 1.0 - 1.0 / 2.46, 2, "c = -1.23 + 2.46u, all + (1e4, 1e4, 1e4)",
                        "absolute coordinates in floats"));
    SetUpC().slidingQuad(-1.5, 2.5).finish(all.add(34, "bucket_border", 0.75, 2, "c = -1.5 + 4u; dark [.25, .5]",
                                                   "rounding at the borders of time buckets"));
    all.add(35, "history_nan", 1.0, 0,
            "a NaN in the history, a camera cut: the next frame must equal a frame without history",
            "reuse of earlier frames")
        .kind = ClosedFormCase::Kind::Sequence;
}

std::vector<ClosedFormCase> makeCases() {
    Catalogue all;
    addSlidingQuads(all);
    addMotionAlongTheLight(all);
    addSeveralIntervals(all);
    addTurningTriangles(all);
    addThinAndFarCasters(all);
    addNumericCases(all);
    addManyCasters(all);
    addContactAndLimits(all);
    return all.take();
}

}  // namespace

FrameRequest ClosedFormCase::request(int samplesPerPixel, const MapSize& mapSize, std::uint32_t seed) const {
    return ProceduralScene::request(width, height, samplesPerPixel, mapSize, seed);
}

ClosedFormCase contactCase(double gap) {
    ClosedFormCase c;
    c.name = "contact";
    SetUpC().slidingQuad(0.0, 0.0, gap).point(0.1 * gap).cameraHeight(0.5 * gap).finish(c);
    return c;
}

std::shared_ptr<ProceduralScene> sweptPointScene(double shift) {
    ClosedFormCase c;
    c.name = "quad_sweeps_point";
    SetUpC().slidingQuad(-1.25 + shift, 1.25 + shift).finish(c);
    return c.scene;
}

const std::vector<ClosedFormCase>& closedFormCases() {
    static const std::vector<ClosedFormCase> cases = makeCases();
    return cases;
}

const ClosedFormCase& closedFormCase(std::string_view name) {
    std::string known;
    for (const ClosedFormCase& c : closedFormCases()) {
        if (c.name == name) return c;
        known += (known.empty() ? "" : ", ") + c.name;
    }
    throw UsageError(fmt::format("case '{}': no such case; expected one of {}", name, known));
}

}  // namespace timeshade
