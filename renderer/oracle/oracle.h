#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "oracle/sample_footprint.h"
#include "oracle/sample_index.h"
#include "oracle/visibility_mean.h"
#include "plan/frame_plan.h"
#include "plan/map_line.h"

namespace timeshade {

/// What the oracle says of one camera sample.
struct OracleAnswer {
    bool hit = false;     ///< the sample sees something
    bool tested = false;  ///< it faces the light and lies inside the light's cone
    bool lit = false;     ///< ground truth of design section 1; meaningless unless tested
    /// A float's rounding could have decided otherwise, where it moves points by 1e-6 of their coordinates: the segment
    /// meets no triangle clearly, but passes that near to an edge, or meets a plane that near to the end of the
    /// segment or to the clearance of the receiver; or the receiver's facing or the cone's border is that near to a
    /// change. `answer` knows it only of the samples that it has resolved exactly.
    bool marginal = false;
    float time = 0.0f;         ///< u
    glm::dvec3 position{0.0};  ///< world space less the plan's origin
};

/// What the light sees through a place of its map at a time.
struct SeenByLight {
    std::uint32_t triangle = NO_TRIANGLE;
    double depth = 0.0;  ///< distance from the light's plane along its axis; meaningless without a triangle
};

/// The independent ray tracer that knows the true `lit` of a camera sample. No OpenGL; it shares nothing with a
/// technique but scene, motion and plan. A receiver p of triangle T at time u is shadowed iff the segment from p to
/// the light meets a triangle other than T, in its position at u, whose plane is farther from p than 2^-21 of T's
/// largest coordinate. Triangles are closed (edges count); one in a common plane with the segment is not met. A
/// directional light's segment is as long as its map is deep (plan.light.block.farDistance), which takes it past all of
/// the scene. The vertices are those of plan.texels (floats, taken as exact), the times those of the shared sample
/// pattern. Embree answers in bulk with linear motion blur; `resolve` decides in double precision.
class Oracle {
  public:
    /// Builds the acceleration structures. Keeps its own copy of what it needs of the plan.
    explicit Oracle(const FramePlan& plan);
    ~Oracle();
    Oracle(const Oracle&) = delete;
    Oracle& operator=(const Oracle&) = delete;

    /// Answers of all camera samples of the plan, whose triangles are given as [stratum][row from the bottom][column]
    /// (NO_TRIANGLE where nothing is seen), in the same order. Embree, packets of eight, all cores; hits near an edge
    /// or near an end of the segment are resolved exactly. `plan` is the one of construction or one made from it by
    /// planAtInstant.
    std::vector<OracleAnswer> answer(const FramePlan& plan, std::span<const std::uint32_t> triangles) const;

    /// The same as `answer`, but every sample resolved exactly: slower by some four times, and nowhere in doubt.
    std::vector<OracleAnswer> resolveAll(const FramePlan& plan, std::span<const std::uint32_t> triangles) const;

    /// Which triangle each camera sample sees, in the same order, by Embree with the camera's culling rule (one-sided
    /// triangles are not seen from behind).
    std::vector<std::uint32_t> tracePrimaries(const FramePlan& plan) const;

    /// One sample, decided in double precision, and by exact arithmetic where double could be wrong.
    OracleAnswer resolve(const FramePlan& plan, SampleIndex sample, std::uint32_t triangle) const;

    /// The triangle that one sample sees, in double precision; `marginal` tells whether a float's rounding could have
    /// chosen another (within 1e-6 relative of an edge, or two triangles at one depth within 1e-6).
    struct ResolvedPrimary {
        std::uint32_t triangle = NO_TRIANGLE;
        bool marginal = false;
    };
    ResolvedPrimary resolvePrimary(const FramePlan& plan, SampleIndex sample) const;

    /// What the light sees through each of columns x rows places of a plane of x along a line of its map and u: the
    /// triangle that is nearest to it beyond the map's near distance, from either side, in double precision; of two at
    /// one depth that with the lower number. The places are the centres of equal cells, [row][column], u from 0 in the
    /// first row to 1 in the last. All cores.
    std::vector<SeenByLight> seenAlong(const FramePlan& plan, const MapLine& line, std::uint32_t columns,
                                       std::uint32_t rows) const;
    /// The same through one place of the map at one time.
    SeenByLight seenByLight(const FramePlan& plan, const glm::dvec2& place, double u) const;

    /// Where the point of a triangle's plane that is at `position` at time `at` is at time u: barycentrics fixed.
    glm::dvec3 followed(std::uint32_t triangle, const glm::dvec3& position, double at, double u) const;

    /// The converged visibility of each pixel of the rows firstRow .. firstRow + rows - 1: its mean over the whole
    /// shutter and the pixel's area, over whatever is seen there, [row][column]. `rays` camera rays a pixel, one in
    /// each stratum of the shutter, their places in the pixel spread by the shared sample pattern; each that meets a
    /// surface which faces the light inside its cone adds one shadow ray, which counts by the shutter's response at its
    /// time (plan.block.response). Means of two seeds are independent. All cores, the same numbers every time.
    std::vector<VisibilityMean> pixelMeans(const FramePlan& plan, std::uint32_t firstRow, std::uint32_t rows,
                                           std::uint32_t rays, std::uint32_t seed) const;

    /// The mean over each of the footprints, in their order, of `rays` rays that are spread likewise over its time and,
    /// where it has one, its area, and weighted likewise. No mean where the sample sees nothing. `plan` gives the
    /// samples: the one of construction, or one made from it by planAtInstant.
    std::vector<VisibilityMean> footprintMeans(const FramePlan& plan, std::span<const SampleFootprint> footprints,
                                               std::uint32_t rays, std::uint32_t seed) const;

    struct Implementation;  ///< for the oracle's own sources

  private:
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace timeshade
