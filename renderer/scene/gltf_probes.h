#pragma once

#include <string>
#include <vector>

#include "scene/clip_clock.h"
#include "scene/gltf_instances.h"
#include "scene/inner_motion.h"

namespace timeshade::gltf {

/// A few vertices of an instance that moves, deformed as the whole instance is.
struct Probe {
    std::uint32_t thing = 0;              ///< index into ProbeList::things
    Instance instance;                    ///< of the scene; its geometry is replaced by `geometry`
    Geometry geometry;                    ///< of these vertices alone
    std::vector<std::uint32_t> vertices;  ///< of the scene's list of vertices
};

struct ProbeList {
    std::vector<Probe> probes;
    std::vector<std::string> things;  ///< names of nodes
};

/// Of every instance that moves: the extremes of its vertices; if it has a skin, those of the vertices that each joint
/// moves most; and the vertex that each morph target moves most.
ProbeList probesOf(const Model& model, const Stage& stage);

/// Their places at the inner instants of a shutter; openSeconds <= closeSeconds.
InnerMotion innerMotionOf(const ProbeList& list, const Stage& stage, const NodeMotion& motion, const ClipClock& clock,
                          double openSeconds, double closeSeconds);

}  // namespace timeshade::gltf
