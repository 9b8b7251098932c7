#pragma once

#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "scene/animation.h"
#include "scene/gltf_model.h"

namespace timeshade::gltf {

/// The transforms of all nodes at one instant.
struct Pose {
    std::vector<glm::dmat4> worldFromNode;
    std::vector<std::vector<double>> morphWeights;  ///< per node; empty if its mesh has no morph targets
};

/// The node hierarchy of a file and the clip that animates it; at rest without a clip.
class NodeMotion {
  public:
    NodeMotion(const Model& model, Clip clip, std::vector<std::string>& notes);

    const Clip& clip() const { return clip_; }
    /// Whether the node's world transform or its morph weights are animated.
    bool moves(int node) const { return moves_[static_cast<std::size_t>(node)]; }
    bool morphs(int node) const;
    const Pose& rest() const { return rest_; }

    /// The pose at a clip time (not wrapped). Throws Error if a transform overflows.
    Pose at(const ClipInstant& instant) const;
    /// The transform of one node, for cameras and lights.
    glm::dmat4 worldFromNode(int node, const ClipInstant& instant) const;

    /// The largest total rotation, in degrees, of any of the given nodes along a sequence of instants.
    double largestTurnDegrees(const std::vector<int>& nodes, const std::vector<ClipInstant>& instants) const;

  private:
    struct Entry {
        int parent = -1;
        LocalTransform local;
        glm::dmat4 matrix{1.0};  ///< parentFromNode at rest
        std::size_t firstTrack = 0;
        std::size_t endTrack = 0;
    };
    void readEntries(const Model& model, std::vector<std::string>& notes);
    void restPose(const Model& model);
    glm::dmat4 parentFromNode(const Entry& entry, const ClipInstant& instant) const;

    Clip clip_;  ///< tracks in the order of their nodes
    std::vector<Entry> nodes_;
    std::vector<int> parentsFirst_;
    std::vector<char> moves_;
    std::vector<int> movingParentsFirst_;
    Pose rest_;
};

/// The rotation of a transform: its axes made orthonormal and right-handed. Identity if an axis has length 0. Of a
/// mirroring transform the x axis is the one that is negated: a camera below it looks the same way and stays upright.
glm::dmat3 rotationOf(const glm::dmat4& transform);

}  // namespace timeshade::gltf
