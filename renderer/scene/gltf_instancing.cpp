#include "scene/gltf_instancing.h"

#include <cmath>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include "core/error.h"
#include "scene/gltf_accessors.h"
#include "scene/gltf_geometry.h"

namespace timeshade::gltf {

namespace {

// Of an instance beside the node: in the poses that are worked out, in the stage and its probes, as measured.
constexpr std::uint64_t bytesBeside = 800;

struct Attribute {
    const char* name;
    int accessor;
    int components;
    Integers integers;
};

/// How many instances a node has: as many as each of its attributes has elements. 0 where it has no attribute.
std::uint64_t countOf(const Model& model, const std::vector<Attribute>& attributes, const std::string& what) {
    const Attribute* first = nullptr;
    for (const Attribute& attribute : attributes) {
        if (attribute.accessor < 0) continue;
        if (static_cast<std::size_t>(attribute.accessor) >= model.accessors.size())
            throw Error(fmt::format("{} {} is accessor {}, there are {}", what, attribute.name, attribute.accessor,
                                    model.accessors.size()));
        const auto elements = [&](const Attribute& a) { return model.accessors[std::size_t(a.accessor)].count; };
        if (first == nullptr)
            first = &attribute;
        else if (elements(attribute) != elements(*first))
            throw Error(fmt::format("{} {} has {} elements, {} has {}; expected as many", what, attribute.name,
                                    elements(attribute), first->name, elements(*first)));
    }
    return first == nullptr ? 0 : model.accessors[std::size_t(first->accessor)].count;
}

std::vector<LocalTransform> readTransforms(const Model& model, const std::vector<Attribute>& attributes,
                                           std::size_t count, const std::string& what) {
    std::vector<LocalTransform> transforms(count);
    const auto read = [&](const Attribute& a, const auto& set) {
        if (a.accessor < 0) return;
        const std::vector<float> numbers =
            readFloats(model, a.accessor, a.components, a.integers, fmt::format("{} {}", what, a.name));
        for (std::size_t i = 0; i < count; ++i)
            set(transforms[i], &numbers[i * static_cast<std::size_t>(a.components)], i);
    };
    read(attributes[0],
         [](LocalTransform& t, const float* at, std::size_t) { t.translation = glm::dvec3(glm::make_vec3(at)); });
    read(attributes[1], [&](LocalTransform& t, const float* at, std::size_t i) {
        const glm::dquat q(static_cast<double>(at[3]), static_cast<double>(at[0]), static_cast<double>(at[1]),
                           static_cast<double>(at[2]));
        const double length = glm::length(q);
        if (!(length > 1e-6 && std::isfinite(length)))
            throw Error(fmt::format("{} ROTATION: that of instance {} is no rotation", what, i));
        t.rotation = q / length;
    });
    read(attributes[2],
         [](LocalTransform& t, const float* at, std::size_t) { t.scale = glm::dvec3(glm::make_vec3(at)); });
    return transforms;
}

/// Weights of morph targets that an animation drives are those of all instances.
void shareWeights(Model& model, int node, int firstChild, int count) {
    for (Animation& animation : model.animations) {
        const std::vector<AnimationChannel> channels = animation.channels;
        for (const AnimationChannel& channel : channels) {
            if (channel.node != node || channel.path != TargetPath::Weights) continue;
            model.memory->take(static_cast<std::uint64_t>(count), bytesBeside, "animated weights of its instances");
            for (int i = 0; i < count; ++i) {
                animation.channels.push_back(channel);
                animation.channels.back().node = firstChild + i;
            }
        }
    }
}

}  // namespace

void expandInstances(Model& model, std::size_t mostTriangles) {
    std::uint64_t triangles = 0;
    const std::size_t nodes = model.nodes.size();
    for (std::size_t n = 0; n < nodes; ++n) {
        if (!model.nodes[n].instancing || model.nodes[n].mesh < 0 || !model.nodes[n].inScene) continue;
        const std::string what = fmt::format("node {} instances", n);
        const Instancing& from = *model.nodes[n].instancing;
        const std::vector<Attribute> attributes{{"TRANSLATION", from.translation, 3, Integers::Forbidden},
                                                {"ROTATION", from.rotation, 4, Integers::Normalized},
                                                {"SCALE", from.scale, 3, Integers::Forbidden}};
        const std::uint64_t count = countOf(model, attributes, what);
        if (count == 0) continue;
        if (model.nodes[n].skin >= 0) {
            model.notes.push_back(fmt::format("node {} has a skin and {} instances; one is drawn", n, count));
            continue;
        }
        std::uint64_t each = 0;
        for (const Primitive& primitive : model.meshes[static_cast<std::size_t>(model.nodes[n].mesh)].primitives)
            each += mostTrianglesOf(model, primitive);
        if (count > mostTriangles || each * count > mostTriangles - triangles)
            throw Error(fmt::format("{}: {} of {} triangles each; the limit is {} triangles over all instances", what,
                                    count, each, mostTriangles));
        triangles += each * count;
        model.memory->take(count, sizeof(Node) + sizeof(LocalTransform) + bytesBeside, what);
        const std::vector<LocalTransform> transforms =
            readTransforms(model, attributes, static_cast<std::size_t>(count), what);
        const int firstChild = static_cast<int>(model.nodes.size());
        for (const LocalTransform& transform : transforms) {
            Node child;
            child.name = model.nodes[n].name;
            child.parent = static_cast<int>(n);
            child.local = transform;
            child.mesh = model.nodes[n].mesh;
            child.weights = model.nodes[n].weights;
            child.inScene = true;
            const int number = static_cast<int>(model.nodes.size());
            model.nodes[n].children.push_back(number);
            model.parentsFirst.push_back(number);
            model.nodes.push_back(std::move(child));
        }
        model.nodes[n].mesh = -1;
        shareWeights(model, static_cast<int>(n), firstChild, static_cast<int>(count));
    }
}

}  // namespace timeshade::gltf
