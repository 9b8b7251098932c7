#pragma once

#include <optional>
#include <vector>

#include "frame/frame_renderer.h"
#include "oracle/oracle.h"

namespace timeshade {

/// A receiver somewhere on its way through the light's map.
struct EpipolarPlace {
    double x = 0.0;      ///< along the line; may lie outside [0, 1]
    double u = 0.0;      ///< time in the shutter
    double depth = 0.0;  ///< distance from the light's plane along its axis
};

/// A camera sample of the pixel that is looked at, with its receiver as a point of its triangle.
struct EpipolarSample {
    EpipolarPlace place;              ///< at the sample's own time
    std::vector<EpipolarPlace> path;  ///< over the whole shutter, from u = 0 to 1
    double uFrom = 0.0, uTo = 0.0;    ///< over what the technique's value averages; equal: an instant
    double texelsOff = 0.0;           ///< how far from the line `place` is, in texels
    bool tested = false;              ///< faces the light inside its cone; else the two values below say nothing
    double lit = 1.0;                 ///< the technique's
    bool truth = true;                ///< the oracle's, at the sample's own time
};

/// A light space epipolar image (Andersson et al. 2015, figures 2 to 4): what lies along one line of the light's map
/// at each time in the shutter, in truth and as a technique stored it.
struct EpipolarView {
    MapLine line;
    glm::ivec2 mapSize{0};
    std::uint32_t columns = 0, rows = 0;
    std::vector<SeenByLight> truth;        ///< as of Oracle::seenAlong: [row, from u = 0 on][column]
    std::vector<std::uint32_t> instances;  ///< of each triangle of the mesh
    StoredAlongLine stored;                ///< in an order that depends on what was stored alone
    std::vector<EpipolarSample> samples;   ///< of the pixel that is looked at; those that see something
};

/// The line through the receiver of a pixel's first sample that sees something, for a view of that pixel: along the
/// motion in the map of what the light sees there at the centre of the shutter, else of the receiver itself, else along
/// a row; as long as shows that motion with something around it, inside the map. Nothing where no sample of the pixel
/// sees anything inside the light's map. x and y from the lower left.
std::optional<MapLine> lineThroughPixel(const Oracle& oracle, const FramePlan& plan, glm::uvec2 pixel);

/// Draws the frame with the technique, and collects what it stored along the line and, of the pixel if there is one,
/// the samples. `oracle` is that of the plan.
EpipolarView epipolarView(FrameRenderer& renderer, const Oracle& oracle, const FramePlan& plan, Technique& technique,
                          const MapLine& line, std::optional<glm::uvec2> pixel);

}  // namespace timeshade
