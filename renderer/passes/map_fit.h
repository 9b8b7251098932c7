#pragma once

#include <string>

#include <glm/glm.hpp>

#include "plan/frame_plan.h"

namespace timeshade {

/// What an ordinary shadow map covers.
enum class MapFit {
    Light,   ///< all that the light reaches
    Seen,    ///< what the camera can see of it
    Warped,  ///< that, with more texels for what is near the camera: light space perspective (Wimmer, Scherzer,
             ///< Purgathofer 2004)
};

/// How the map's grid lies on what it covers.
struct MapGrid {
    double angle = 0.0;     ///< turned by so much, radians
    glm::dvec2 shift{0.0};  ///< moved by so much of its width and height, each by at most half a texel
};

struct FittedMap {
    /// The homography from (s, t, 1) of the light's map plane to the map, for passes/shadow_map.h. Its weight is at
    /// least 1 inside the map (where there is no warp, it is 1).
    glm::dmat3 mapFromPlane{1.0};
    double warp = 0.0;      ///< how much of its published strength the warp has; 0: none
    std::string shortfall;  ///< why it covers more, or is warped less, than was asked for; empty where it does not
};

/// Fits a map to what the camera sees at any time of the shutter, from the light at any time of it. Whatever is to be
/// covered stays inside: a spot's cone is round and so fits a turned square; a directional light's square shrinks to
/// fit, by 1 / (cos + sin) of the angle, 0.79 in the mean. Warped: the weaker the more light and camera look along one
/// line, and not at all where they do (duelling frusta); and only as strong as leaves every corner of the map before
/// the warp's horizon. The light's whole reach where the camera sees nothing of it, or the light moves amid what the
/// camera sees.
FittedMap fitMap(const FramePlan& plan, MapFit fit, const MapGrid& grid);

}  // namespace timeshade
