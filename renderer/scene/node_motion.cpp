#include "scene/node_motion.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade::gltf {

namespace {

void requireFinite(const glm::dmat4& matrix, std::size_t node, double clipSeconds) {
    constexpr double limit = 1e30;  // products of such positions are finite in double
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(matrix[column][row]) <= limit))
                throw Error(fmt::format("the transform of node {} overflows at {} s", node, clipSeconds));
}

glm::dquat unit(const glm::dquat& rotation) {
    const double length = glm::length(rotation);
    return length > 1e-12 ? rotation / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

bool mirrors(const glm::dmat4& matrix) { return glm::determinant(glm::dmat3(matrix)) < 0.0; }

/// Translation, rotation and scale of a matrix; shear is lost.
LocalTransform decomposed(const glm::dmat4& matrix) {
    LocalTransform local;
    local.translation = glm::dvec3(matrix[3]);
    local.rotation = glm::quat_cast(rotationOf(matrix));
    for (int axis = 0; axis < 3; ++axis) local.scale[axis] = glm::length(glm::dvec3(matrix[axis]));
    if (mirrors(matrix)) local.scale.x = -local.scale.x;  // as rotationOf() has it
    return local;
}

double angleBetween(const glm::dmat3& from, const glm::dmat3& to) {
    const glm::dmat3 turn = to * glm::transpose(from);
    const glm::dvec3 skew(turn[1][2] - turn[2][1], turn[2][0] - turn[0][2], turn[0][1] - turn[1][0]);
    return std::atan2(glm::length(skew), turn[0][0] + turn[1][1] + turn[2][2] - 1.0);  // accurate for small angles too
}

}  // namespace

glm::dmat3 rotationOf(const glm::dmat4& transform) {
    const bool mirrored = mirrors(transform);
    const glm::dvec3 z(transform[2]), beside(transform[mirrored ? 1 : 0]);
    const double lengthZ = glm::length(z);
    if (!(lengthZ > 0.0)) return glm::dmat3(1.0);
    const glm::dvec3 back = z / lengthZ;
    const glm::dvec3 across = beside - back * glm::dot(beside, back);
    const double length = glm::length(across);
    if (!(length > 1e-9 * glm::length(beside))) return glm::dmat3(1.0);
    const glm::dvec3 kept = across / length;
    return mirrored ? glm::dmat3(glm::cross(kept, back), kept, back) : glm::dmat3(kept, glm::cross(back, kept), back);
}

NodeMotion::NodeMotion(const Model& model, Clip clip, std::vector<std::string>& notes)
    : clip_(std::move(clip)), parentsFirst_(model.parentsFirst) {
    readEntries(model, notes);
    restPose(model);
}

void NodeMotion::readEntries(const Model& model, std::vector<std::string>& notes) {
    std::stable_sort(clip_.tracks.begin(), clip_.tracks.end(),
                     [](const Track& a, const Track& b) { return a.node < b.node; });
    std::size_t track = 0;
    std::size_t decomposedNodes = 0;
    for (const Node& node : model.nodes) {
        Entry entry{node.parent, node.local, glm::dmat4(1.0), track, track};
        while (track < clip_.tracks.size() && clip_.tracks[track].node == static_cast<int>(nodes_.size())) ++track;
        entry.endTrack = track;
        entry.local.rotation = unit(entry.local.rotation);
        entry.matrix = node.matrix ? *node.matrix : entry.local.matrix();
        if (node.matrix && entry.endTrack > entry.firstTrack) {
            entry.local = decomposed(*node.matrix);
            ++decomposedNodes;
        }
        nodes_.push_back(entry);
    }
    if (decomposedNodes > 0)
        notes.push_back(fmt::format("{} animated nodes are given as matrices; shear in them is lost", decomposedNodes));
}

void NodeMotion::restPose(const Model& model) {
    rest_.worldFromNode.resize(nodes_.size());
    rest_.morphWeights.resize(nodes_.size());
    moves_.assign(nodes_.size(), 0);
    for (const int index : parentsFirst_) {
        const auto i = static_cast<std::size_t>(index);
        const Entry& entry = nodes_[i];
        const bool child = entry.parent >= 0;
        rest_.worldFromNode[i] =
            child ? rest_.worldFromNode[static_cast<std::size_t>(entry.parent)] * entry.matrix : entry.matrix;
        requireFinite(rest_.worldFromNode[i], i, 0.0);
        bool driven = child && moves_[static_cast<std::size_t>(entry.parent)];
        for (std::size_t t = entry.firstTrack; t < entry.endTrack; ++t)
            driven = driven || clip_.tracks[t].path != TargetPath::Weights;
        moves_[i] = driven;
        if (driven) movingParentsFirst_.push_back(index);

        const Node& node = model.nodes[i];
        if (node.mesh < 0) continue;
        const Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
        const std::size_t targets = mesh.primitives.empty() ? 0 : mesh.primitives.front().targets.size();
        rest_.morphWeights[i] = node.weights.empty() ? mesh.weights : node.weights;
        if (!rest_.morphWeights[i].empty() && rest_.morphWeights[i].size() != targets)
            throw Error(
                fmt::format("node {} has {} morph weights for {} targets", i, rest_.morphWeights[i].size(), targets));
        rest_.morphWeights[i].resize(targets, 0.0);
    }
}

bool NodeMotion::morphs(int node) const {
    const Entry& entry = nodes_[static_cast<std::size_t>(node)];
    for (std::size_t t = entry.firstTrack; t < entry.endTrack; ++t)
        if (clip_.tracks[t].path == TargetPath::Weights) return true;
    return false;
}

glm::dmat4 NodeMotion::parentFromNode(const Entry& entry, const ClipInstant& instant) const {
    LocalTransform local = entry.local;
    bool driven = false;
    for (std::size_t t = entry.firstTrack; t < entry.endTrack; ++t) {
        const Track& track = clip_.tracks[t];
        if (track.path == TargetPath::Weights) continue;
        double value[4];
        track.sample(instant, value);
        driven = true;
        if (track.path == TargetPath::Translation) local.translation = {value[0], value[1], value[2]};
        if (track.path == TargetPath::Scale) local.scale = {value[0], value[1], value[2]};
        if (track.path == TargetPath::Rotation) local.rotation = glm::dquat(value[3], value[0], value[1], value[2]);
    }
    return driven ? local.matrix() : entry.matrix;
}

Pose NodeMotion::at(const ClipInstant& instant) const {
    Pose pose = rest_;
    for (const int index : movingParentsFirst_) {
        const auto i = static_cast<std::size_t>(index);
        const Entry& entry = nodes_[i];
        const glm::dmat4 local = parentFromNode(entry, instant);
        pose.worldFromNode[i] =
            entry.parent >= 0 ? pose.worldFromNode[static_cast<std::size_t>(entry.parent)] * local : local;
        requireFinite(pose.worldFromNode[i], i, instant.seconds);
    }
    for (const Track& track : clip_.tracks)
        if (track.path == TargetPath::Weights)
            track.sample(instant, pose.morphWeights[static_cast<std::size_t>(track.node)].data());
    return pose;
}

glm::dmat4 NodeMotion::worldFromNode(int node, const ClipInstant& instant) const {
    glm::dmat4 matrix(1.0);
    for (int index = node; index >= 0; index = nodes_[static_cast<std::size_t>(index)].parent)
        matrix = parentFromNode(nodes_[static_cast<std::size_t>(index)], instant) * matrix;
    requireFinite(matrix, static_cast<std::size_t>(node), instant.seconds);
    return matrix;
}

double NodeMotion::largestTurnDegrees(const std::vector<int>& nodes, const std::vector<ClipInstant>& instants) const {
    if (nodes.empty()) return 0.0;
    std::vector<double> turns(nodes.size(), 0.0);
    std::vector<glm::dmat3> before(nodes.size());
    for (std::size_t step = 0; step < instants.size(); ++step) {
        const Pose pose = at(instants[step]);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const glm::dmat3 rotation = rotationOf(pose.worldFromNode[static_cast<std::size_t>(nodes[i])]);
            if (step > 0) turns[i] += angleBetween(before[i], rotation);
            before[i] = rotation;
        }
    }
    return *std::max_element(turns.begin(), turns.end()) * 57.29577951308232;
}

}  // namespace timeshade::gltf
