#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "plan/frame_plan.h"

namespace timeshade {

/// What a position of the image sees during a part of the shutter.
struct SeenSegment {
    std::uint32_t triangle = NO_TRIANGLE;  ///< NO_TRIANGLE: the background
    double u0 = 0.0, u1 = 1.0;
};

/// A segment, and for how long its receiver is lit. The receiver is the point that the position's ray sees: it moves
/// over its triangle.
struct LitSegment {
    SeenSegment seen;
    /// While the receiver faces the light inside its cone, and of that while it is lit. Shares of the exposure: of the
    /// time u where the shutter's response is a box, else weighted by it. 0 for the background.
    double tested = 0.0, lit = 0.0;
};

/// The true list of what a position (pixels from the lower left corner, without a time) sees when, in double precision
/// and beyond, from code of its own: docs/numerics.md, "Interval samples of the camera". No OpenGL, no Embree.
class SegmentOracle {
  public:
    /// Keeps its own copy of what it needs of the plan.
    /// Throws Error for a scene with a material that is cut out by its alpha.
    explicit SegmentOracle(const FramePlan& plan);
    ~SegmentOracle();
    SegmentOracle(const SegmentOracle&) = delete;
    SegmentOracle& operator=(const SegmentOracle&) = delete;

    /// A partition of [0, 1] in ascending order: u0 of the first is 0, u1 of the last is 1, each u1 is the next one's
    /// u0, and neighbours differ in their triangles. At each instant the triangle is that of Oracle's camera rays: the
    /// nearest beyond the near distance, one-sided ones from their front only, edges included, and of several at one
    /// depth the one with the lowest number. Which triangle is seen between two changes is decided without rounding,
    /// the times of changes are off by some 1e-15 where edges move, and by less than it takes to move the edge by 2^-40
    /// of its distance where they hardly do. What is seen for less than 2^-40 counts as what is seen before it.
    ///
    /// `aside` moves the position by so many pixels, less than a float could tell.
    std::vector<SeenSegment> seenBy(const FramePlan& plan, glm::vec2 place, glm::dvec2 aside = glm::dvec2(0.0)) const;
    /// The same for each of the places, on all cores.
    std::vector<std::vector<SeenSegment>> seenByAll(const FramePlan& plan, std::span<const glm::vec2> places) const;

    /// The lit time of each segment of a place: the union of the times at which any other triangle shadows the
    /// receiver, as docs/numerics.md, "Definition of shadow", has it, on the receiver's true way. Ends of shadows are
    /// off by some 1e-12 where edges move. Between two of them the oracle's own test of an instant decides; no way is
    /// replaced by chords. The segments may be those of seenBy or another list: of each, the receiver is where the
    /// position's ray meets the plane of its triangle.
    std::vector<LitSegment> litOver(const FramePlan& plan, glm::vec2 place,
                                    std::span<const SeenSegment> segments) const;
    /// seenBy and litOver for each of the places, on all cores.
    std::vector<std::vector<LitSegment>> litByAll(const FramePlan& plan, std::span<const glm::vec2> places) const;

    /// Why two triangles (or one and the background) may be taken for each other at an instant, by the rounding of a
    /// float: 1e-6 of the coordinates.
    enum class Doubt {
        None,
        EdgeOn,    ///< one of them is seen edge-on: it is no thicker than that
        DepthTie,  ///< both are at one depth, or one is at the near distance
    };
    Doubt doubtBetween(const FramePlan& plan, glm::vec2 place, double u, std::uint32_t a, std::uint32_t b) const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace timeshade
