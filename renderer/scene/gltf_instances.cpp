#include "scene/gltf_instances.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include "core/error.h"
#include "scene/gltf_accessors.h"

namespace timeshade::gltf {

namespace {

std::vector<SkinBinding> readSkins(const Model& model) {
    std::vector<SkinBinding> skins;
    for (const Skin& skin : model.skins) {
        // Bindings, and the joints' matrices of a pose.
        model.memory->take(skin.joints.size(), sizeof(int) + sizeof(glm::dmat4) + sizeof(glm::dmat4x3),
                           fmt::format("skin {} joints", skins.size()));
        SkinBinding binding{skin.joints, std::vector<glm::dmat4>(skin.joints.size(), glm::dmat4(1.0))};
        if (skin.inverseBindMatrices >= 0) {
            const std::string what = fmt::format("skin {} inverse bind matrices", skins.size());
            const std::vector<float> numbers =
                readFloats(model, skin.inverseBindMatrices, 16, Integers::Forbidden, what);
            for (std::size_t j = 0; j < skin.joints.size(); ++j)
                binding.jointFromMesh[j] = glm::dmat4(glm::make_mat4(&numbers[16 * j]));
            for (std::size_t i = 3; i < numbers.size(); i += 4) {
                const float expected = i % 16 == 15 ? 1.0f : 0.0f;
                if (!(std::abs(numbers[i] - expected) <= 1e-4f))  // products of float matrices are rounded
                    throw Error(fmt::format("{}: the last row of matrix {} is not 0 0 0 1", what, i / 16));
            }
            for (const float number : numbers)
                if (!(number >= -1e18f && number <= 1e18f))
                    throw Error(fmt::format("{} hold the number {}", what, number));
        }
        skins.push_back(std::move(binding));
    }
    return skins;
}

/// Properties of a skin, computed once, since files may use a skin many times.
struct SkinFacts {
    bool mirrored = false;
    bool moves = false;
    bool used = false;
};

/// Whether the majority of a skin's joints mirror in a pose.
bool mirrors(const SkinBinding& skin, const Pose& pose) {
    int balance = 0;
    for (const glm::dmat4x3& joint : jointMatrices(skin, pose))
        balance += glm::dot(joint[0], glm::cross(joint[1], joint[2])) < 0.0 ? 1 : -1;
    return balance > 0;
}

bool mirrors(const Pose& pose, int node) {
    return glm::determinant(glm::dmat3(pose.worldFromNode[static_cast<std::size_t>(node)])) < 0.0;
}

std::vector<SkinFacts> factsOf(const std::vector<SkinBinding>& skins, const NodeMotion& motion) {
    std::vector<SkinFacts> facts;
    for (const SkinBinding& skin : skins) {
        const bool moves =
            std::any_of(skin.joints.begin(), skin.joints.end(), [&](int joint) { return motion.moves(joint); });
        facts.push_back({mirrors(skin, motion.rest()), moves, false});
    }
    return facts;
}

glm::u32vec3 turnedRound(const glm::u32vec3& triangle) { return {triangle.x, triangle.z, triangle.y}; }

/// Appends a list with one value a vertex that may be empty, to one that stays empty as long as all are.
void append(std::vector<glm::vec4>& list, const std::vector<glm::vec4>& values, std::size_t first, float otherwise) {
    if (values.empty()) return;
    list.resize(first, glm::vec4(otherwise));
    list.insert(list.end(), values.begin(), values.end());
}

void appendTopology(MeshTopology& topology, std::vector<char>& used, const Instance& instance, std::uint32_t material,
                    std::uint32_t number) {
    const Geometry& geometry = *instance.geometry;
    const auto first = static_cast<std::uint32_t>(instance.firstVertex);
    topology.textureCoordinates.insert(topology.textureCoordinates.end(), geometry.textureCoordinates.begin(),
                                       geometry.textureCoordinates.end());
    append(topology.moreCoordinates, geometry.moreCoordinates, instance.firstVertex, 0.0f);
    append(topology.colours, geometry.colours, instance.firstVertex, 1.0f);
    used.resize(used.size() + geometry.positions.size(), 0);
    for (const glm::u32vec3& triangle : geometry.triangles) {
        const glm::u32vec3 placed = (instance.mirrored ? turnedRound(triangle) : triangle) + first;
        topology.triangles.push_back(placed);
        topology.triangleMaterials.push_back(material);
        topology.triangleInstances.push_back(number);
        for (int corner = 0; corner < 3; ++corner) used[placed[corner]] = 1;
    }
    topology.vertexCount += geometry.positions.size();
}

std::vector<int> turningNodes(const Stage& stage, const std::vector<SkinFacts>& facts, const NodeMotion& motion) {
    std::vector<int> nodes;
    for (const Instance& instance : stage.instances)
        if (instance.skin < 0) nodes.push_back(instance.node);
    for (std::size_t s = 0; s < facts.size(); ++s)
        if (facts[s].used) nodes.insert(nodes.end(), stage.skins[s].joints.begin(), stage.skins[s].joints.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    std::erase_if(nodes, [&](int node) { return !motion.moves(node); });
    return nodes;
}

}  // namespace

Stage buildStage(const Model& model, const NodeMotion& motion, std::vector<std::vector<Geometry>> geometries,
                 std::uint32_t defaultMaterial, std::vector<std::string>& notes) {
    Stage stage;
    stage.geometries = std::move(geometries);
    stage.skins = readSkins(model);
    std::vector<SkinFacts> facts = factsOf(stage.skins, motion);
    auto topology = std::make_shared<MeshTopology>();
    std::size_t flipped = 0;
    std::uint32_t number = 0;  // all primitives of a node are one instance for the rest of the program
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const Node& node = model.nodes[n];
        if (!node.inScene || node.mesh < 0 || stage.geometries[static_cast<std::size_t>(node.mesh)].empty()) continue;
        bool anyFlipped = false;
        for (const Geometry& geometry : stage.geometries[static_cast<std::size_t>(node.mesh)]) {
            const int index = static_cast<int>(n);
            Instance instance{&geometry, index, geometry.jointSets.empty() ? -1 : node.skin, topology->vertexCount,
                              false,     false};
            SkinFacts* skin = instance.skin < 0 ? nullptr : &facts[static_cast<std::size_t>(instance.skin)];
            if (skin != nullptr) skin->used = true;
            instance.moves = motion.morphs(index) || motion.moves(index) || (skin != nullptr && skin->moves);
            instance.mirrored = skin != nullptr ? skin->mirrored : mirrors(motion.rest(), index);
            anyFlipped = anyFlipped || instance.mirrored;
            const std::uint32_t material =
                geometry.material < 0 ? defaultMaterial : static_cast<std::uint32_t>(geometry.material);
            appendTopology(*topology, stage.used, instance, material, number);
            stage.instances.push_back(instance);
        }
        flipped += anyFlipped ? 1 : 0;
        ++number;
    }
    if (topology->triangles.empty()) throw Error("has no triangles to show");
    if (flipped > 0) notes.push_back(fmt::format("{} mirrored instances have their triangles turned round", flipped));
    if (!topology->moreCoordinates.empty()) topology->moreCoordinates.resize(topology->vertexCount, glm::vec4(0.0f));
    if (!topology->colours.empty()) topology->colours.resize(topology->vertexCount, glm::vec4(1.0f));
    topology->instanceCount = number;
    stage.topology = std::move(topology);
    stage.turningNodes = turningNodes(stage, facts, motion);
    stage.mayMirror = std::any_of(motion.clip().tracks.begin(), motion.clip().tracks.end(),
                                  [](const Track& track) { return track.path == TargetPath::Scale; });
    return stage;
}

std::vector<char> mirroredInstances(const Stage& stage, const Pose& pose) {
    std::vector<int> skins(stage.skins.size(), -1);  // instances share skins
    std::vector<char> mirrored;
    for (const Instance& instance : stage.instances) {
        if (!instance.moves) {
            mirrored.push_back(instance.mirrored);
        } else if (instance.skin < 0) {
            mirrored.push_back(mirrors(pose, instance.node));
        } else {
            int& known = skins[static_cast<std::size_t>(instance.skin)];
            if (known < 0) known = mirrors(stage.skins[static_cast<std::size_t>(instance.skin)], pose);
            mirrored.push_back(known > 0);
        }
    }
    return mirrored;
}

std::shared_ptr<const MeshTopology> topologyMirrored(const Stage& stage, const std::vector<char>& mirrored) {
    const auto differs = [&](std::size_t i) { return (mirrored[i] != 0) != stage.instances[i].mirrored; };
    std::shared_ptr<MeshTopology> changed;
    std::size_t first = 0;
    for (std::size_t i = 0; i < stage.instances.size(); ++i) {
        const std::size_t end = first + stage.instances[i].geometry->triangles.size();
        if (differs(i)) {
            if (!changed) changed = std::make_shared<MeshTopology>(*stage.topology);
            for (std::size_t id = first; id < end; ++id) changed->triangles[id] = turnedRound(changed->triangles[id]);
        }
        first = end;
    }
    return changed ? changed : stage.topology;
}

}  // namespace timeshade::gltf
