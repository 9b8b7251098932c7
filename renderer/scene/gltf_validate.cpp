#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"
#include "scene/gltf_model.h"

namespace timeshade::gltf {

namespace {

/// Larger than any realistic scene in any unit; products of a few such numbers are finite in double.
constexpr double largestNumber = 1e18;

void requireIndex(int index, std::size_t size, const std::string& where, const char* what) {
    if (index < 0 || static_cast<std::size_t>(index) >= size)
        throw Error(fmt::format("{} refers to {} {}, the file has {}", where, what, index, size));
}

void allowIndex(int index, std::size_t size, const std::string& where, const char* what) {
    if (index != -1) requireIndex(index, size, where, what);
}

/// The last byte of `count` elements, `stride` apart; saturates on overflow of 64 bits.
std::uint64_t extent(std::uint64_t offset, std::uint64_t count, std::uint64_t stride, std::uint64_t elementSize) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    if (count == 0) return offset;
    if (stride != 0 && (count - 1) > (most - elementSize) / stride) return most;
    const std::uint64_t span = (count - 1) * stride + elementSize;
    return offset > most - span ? most : offset + span;
}

void requireWithin(const View& view, std::uint64_t offset, std::uint64_t count, std::uint64_t stride,
                   std::uint64_t elementSize, const std::string& where) {
    const std::uint64_t end = extent(offset, count, stride, elementSize);
    if (end > view.length)
        throw Error(fmt::format("{} needs {} bytes of its buffer view, which has {}", where, end, view.length));
}

void checkViews(const Model& model) {
    for (std::size_t i = 0; i < model.views.size(); ++i) {
        const View& view = model.views[i];
        const std::string where = fmt::format("bufferView {}", i);
        requireIndex(view.buffer, model.buffers.size(), where, "buffer");
        const std::uint64_t length = model.bufferLengths[static_cast<std::size_t>(view.buffer)];
        if (view.offset > length || view.length > length - view.offset)
            throw Error(fmt::format("{} spans bytes {} to {} of a buffer of {} bytes", where, view.offset,
                                    static_cast<double>(view.offset) + static_cast<double>(view.length), length));
        if (view.length == 0) throw Error(fmt::format("{} has no bytes", where));
    }
}

void checkSparse(const Model& model, const Accessor& accessor, std::uint64_t elementSize, const std::string& where) {
    const SparseValues& sparse = *accessor.sparse;
    requireIndex(sparse.indexView, model.views.size(), where + " (sparse)", "bufferView");
    requireIndex(sparse.valueView, model.views.size(), where + " (sparse)", "bufferView");
    if (sparse.count > accessor.count)
        throw Error(fmt::format("{} has {} sparse values for {} elements", where, sparse.count, accessor.count));
    if (sparse.indexType != Component::UnsignedByte && sparse.indexType != Component::UnsignedShort &&
        sparse.indexType != Component::UnsignedInt)
        throw Error(fmt::format("{} has sparse indices that are not unsigned integers", where));
    const std::uint64_t indexSize = byteSize(sparse.indexType);
    requireWithin(model.views[static_cast<std::size_t>(sparse.indexView)], sparse.indexOffset, sparse.count, indexSize,
                  indexSize, where + " (sparse indices)");
    requireWithin(model.views[static_cast<std::size_t>(sparse.valueView)], sparse.valueOffset, sparse.count,
                  elementSize, elementSize, where + " (sparse values)");
}

void checkAccessors(const Model& model) {
    // Elements without data do not add to the file's size, so they need a separate limit.
    constexpr std::uint64_t maxZeros = 1u << 20;
    std::uint64_t zeros = 0;
    for (std::size_t i = 0; i < model.accessors.size(); ++i) {
        const Accessor& accessor = model.accessors[i];
        const std::string where = fmt::format("accessor {}", i);
        allowIndex(accessor.view, model.views.size(), where, "bufferView");
        if (accessor.count == 0) throw Error(fmt::format("{} has a count of 0", where));
        const std::uint64_t size = byteSize(accessor.type) * static_cast<std::uint64_t>(accessor.components);
        if (accessor.view >= 0) {
            const View& view = model.views[static_cast<std::size_t>(accessor.view)];
            const std::uint64_t stride = view.stride == 0 ? size : view.stride;
            if (stride < size || stride % byteSize(accessor.type) != 0)
                throw Error(fmt::format("{} has elements of {} bytes at a stride of {}", where, size, stride));
            requireWithin(view, accessor.offset, accessor.count, stride, size, where);
        } else {
            zeros = accessor.count > maxZeros - zeros ? maxZeros + 1 : zeros + accessor.count;
            if (zeros > maxZeros)
                throw Error(fmt::format("{} has {} elements without data, the limit is {} in all", where,
                                        accessor.count, maxZeros));
        }
        if (accessor.sparse) checkSparse(model, accessor, size, where);
    }
}

void checkMeshes(const Model& model) {
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        for (const Primitive& primitive : model.meshes[m].primitives) {
            const std::string where = fmt::format("mesh {}", m);
            if (primitive.mode < 0 || primitive.mode > 6)
                throw Error(fmt::format("{} has the primitive mode {}, expected 0 to 6", where, primitive.mode));
            const std::size_t count = model.accessors.size();
            for (const int index : {primitive.position, primitive.normal, primitive.colours, primitive.indices})
                allowIndex(index, count, where, "accessor");
            for (const auto& [set, index] : primitive.textureCoordinates) requireIndex(index, count, where, "accessor");
            for (const int index : primitive.joints) requireIndex(index, count, where, "accessor");
            for (const int index : primitive.weights) requireIndex(index, count, where, "accessor");
            for (const MorphTarget& target : primitive.targets) {
                allowIndex(target.position, count, where, "accessor");
                allowIndex(target.normal, count, where, "accessor");
            }
            allowIndex(primitive.material, model.materials.size(), where, "material");
            if (primitive.targets.size() != model.meshes[m].primitives.front().targets.size())
                throw Error(fmt::format("{} has primitives with different numbers of morph targets", where));
        }
    }
}

bool bounded(double value) { return std::abs(value) <= largestNumber; }  // false for NaN

void checkTransform(const Node& node, const std::string& where) {
    bool good = true;
    for (int i = 0; i < 3; ++i) good = good && bounded(node.local.translation[i]) && bounded(node.local.scale[i]);
    for (int i = 0; i < 4; ++i) good = good && bounded(node.local.rotation[i]);
    for (int i = 0; node.matrix && i < 16; ++i) good = good && bounded((*node.matrix)[i / 4][i % 4]);
    if (!good) throw Error(fmt::format("{} has a transform with numbers beyond {}", where, largestNumber));
    if (node.matrix && (*node.matrix)[3][3] != 1.0)
        throw Error(fmt::format("{} has a matrix whose last element is {}, expected 1", where, (*node.matrix)[3][3]));
    for (int column = 0; node.matrix && column < 3; ++column)
        if ((*node.matrix)[column][3] != 0.0)
            throw Error(fmt::format("{} has a matrix whose last row begins with {}, {}, {}, expected zeros", where,
                                    (*node.matrix)[0][3], (*node.matrix)[1][3], (*node.matrix)[2][3]));
    for (const double weight : node.weights)
        if (!bounded(weight)) throw Error(fmt::format("{} has a morph weight beyond {}", where, largestNumber));
}

void checkNodes(const Model& model) {
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const Node& node = model.nodes[i];
        const std::string where = fmt::format("node {}", i);
        for (const int child : node.children) requireIndex(child, model.nodes.size(), where, "node");
        allowIndex(node.mesh, model.meshes.size(), where, "mesh");
        allowIndex(node.skin, model.skins.size(), where, "skin");
        allowIndex(node.camera, model.cameras.size(), where, "camera");
        allowIndex(node.light, model.lights.size(), where, "light");
        checkTransform(node, where);
    }
}

void linkParents(Model& model) {
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        for (const int child : model.nodes[i].children) {
            Node& node = model.nodes[static_cast<std::size_t>(child)];
            if (static_cast<std::size_t>(child) == i) throw Error(fmt::format("node {} is its own child", i));
            if (node.parent >= 0) throw Error(fmt::format("node {} has two parents: {} and {}", child, node.parent, i));
            node.parent = static_cast<int>(i);
        }
    }
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if (model.nodes[i].parent < 0) model.parentsFirst.push_back(static_cast<int>(i));
    for (std::size_t next = 0; next < model.parentsFirst.size(); ++next)
        for (const int child : model.nodes[static_cast<std::size_t>(model.parentsFirst[next])].children)
            model.parentsFirst.push_back(child);
    if (model.parentsFirst.size() != model.nodes.size())
        throw Error(fmt::format("its nodes form a cycle: {} of {} have no root above them",
                                model.nodes.size() - model.parentsFirst.size(), model.nodes.size()));
}

void markScene(Model& model) {
    allowIndex(model.scene, model.scenes.size(), "the file", "scene");
    for (std::size_t s = 0; s < model.scenes.size(); ++s)
        for (const int root : model.scenes[s])
            requireIndex(root, model.nodes.size(), fmt::format("scene {}", s), "node");
    if (model.scene < 0)
        for (Node& node : model.nodes) node.inScene = node.parent < 0;
    else
        for (const int root : model.scenes[static_cast<std::size_t>(model.scene)])
            model.nodes[static_cast<std::size_t>(root)].inScene = true;
    std::size_t children = 0;
    if (model.scene >= 0)
        for (const int root : model.scenes[static_cast<std::size_t>(model.scene)])
            if (model.nodes[static_cast<std::size_t>(root)].parent >= 0) ++children;
    if (children > 0)
        model.notes.push_back(
            fmt::format("{} nodes are roots of the scene and children too; each is shown once, as a child", children));
    for (const int index : model.parentsFirst) {
        Node& node = model.nodes[static_cast<std::size_t>(index)];
        if (node.parent >= 0 && model.nodes[static_cast<std::size_t>(node.parent)].inScene) node.inScene = true;
    }
}

void checkSkins(const Model& model) {
    for (std::size_t i = 0; i < model.skins.size(); ++i) {
        const Skin& skin = model.skins[i];
        const std::string where = fmt::format("skin {}", i);
        if (skin.joints.empty()) throw Error(fmt::format("{} has no joints", where));
        for (const int joint : skin.joints) requireIndex(joint, model.nodes.size(), where, "node");
        allowIndex(skin.inverseBindMatrices, model.accessors.size(), where, "accessor");
        if (skin.inverseBindMatrices < 0) continue;
        const Accessor& matrices = model.accessors[static_cast<std::size_t>(skin.inverseBindMatrices)];
        if (matrices.components != 16 || matrices.type != Component::Float)
            throw Error(fmt::format("{} has inverse bind matrices that are not 4x4 floats", where));
        if (matrices.count < skin.joints.size())
            throw Error(fmt::format("{} has {} inverse bind matrices for {} joints", where, matrices.count,
                                    skin.joints.size()));
    }
}

void checkAnimations(const Model& model) {
    for (std::size_t i = 0; i < model.animations.size(); ++i) {
        const std::string where = fmt::format("animation {}", i);
        for (const AnimationSampler& sampler : model.animations[i].samplers) {
            requireIndex(sampler.input, model.accessors.size(), where, "accessor");
            requireIndex(sampler.output, model.accessors.size(), where, "accessor");
        }
        for (const AnimationChannel& channel : model.animations[i].channels) {
            requireIndex(channel.sampler, model.animations[i].samplers.size(), where, "sampler");
            if (channel.light >= 0)
                requireIndex(channel.light, model.lights.size(), where, "light");
            else
                requireIndex(channel.node, model.nodes.size(), where, "node");
        }
    }
}

void checkMaterials(const Model& model) {
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
        const std::string where = fmt::format("material {}", i);
        const Material& material = model.materials[i].material;
        for (const TextureUse& use : {material.baseColor, material.metallicRoughness, material.emissive})
            allowIndex(use.image, model.textures.size(), where, "texture");
    }
    for (std::size_t i = 0; i < model.textures.size(); ++i)
        allowIndex(model.textures[i].image, model.images.size(), fmt::format("texture {}", i), "image");
    for (std::size_t i = 0; i < model.images.size(); ++i)
        allowIndex(model.images[i].view, model.views.size(), fmt::format("image {}", i), "bufferView");
}

}  // namespace

void validate(Model& model) {
    checkViews(model);
    checkAccessors(model);
    checkMaterials(model);
    checkMeshes(model);
    checkNodes(model);
    checkSkins(model);
    checkAnimations(model);
    linkParents(model);
    markScene(model);
}

}  // namespace timeshade::gltf
