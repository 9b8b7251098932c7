#include "scene/gltf_model.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

// tinygltf only parses the structure. This importer reads files and images itself.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include "core/error.h"
#include "core/one_line.h"
#include "scene/gltf_extensions.h"

namespace timeshade::gltf {

namespace {

bool keepNoImage(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
    return true;
}

tinygltf::Model parseStructure(const Document& document) {
    // Without these sections tinygltf opens no file and decodes nothing.
    nlohmann::json bare = document.json;
    bare.erase("buffers");
    bare.erase("images");
    const std::string text = bare.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    bare = nullptr;

    tinygltf::TinyGLTF reader;
    reader.SetImageLoader(&keepNoImage, nullptr);
    tinygltf::Model model;
    std::string error;
    std::string warning;
    if (!reader.LoadASCIIFromString(&model, &error, &warning, text.c_str(), static_cast<unsigned int>(text.size()), ""))
        throw Error(error.empty() ? "its structure is not glTF" : oneLine(error, 160));
    return model;
}

Component component(int value, const std::string& where) {
    switch (value) {
    case 5120:
    case 5121:
    case 5122:
    case 5123:
    case 5125:
    case 5126: return static_cast<Component>(value);
    default: throw Error(fmt::format("{} has component type {}, which glTF does not know", where, value));
    }
}

int components(int type, const std::string& where) {
    switch (type) {
    case TINYGLTF_TYPE_SCALAR: return 1;
    case TINYGLTF_TYPE_VEC2: return 2;
    case TINYGLTF_TYPE_VEC3: return 3;
    case TINYGLTF_TYPE_VEC4:
    case TINYGLTF_TYPE_MAT2: return 4;
    case TINYGLTF_TYPE_MAT3: return 9;
    case TINYGLTF_TYPE_MAT4: return 16;
    default: throw Error(fmt::format("{} has a type that glTF does not know", where));
    }
}

std::uint64_t unsignedOf(int value) { return value < 0 ? ~std::uint64_t{0} : static_cast<std::uint64_t>(value); }

Accessor convert(const tinygltf::Accessor& from, std::size_t index) {
    const std::string where = fmt::format("accessor {}", index);
    Accessor to{from.bufferView,
                from.byteOffset,
                from.count,
                components(from.type, where),
                component(from.componentType, where),
                from.normalized,
                {}};
    if (from.sparse.isSparse)
        to.sparse = SparseValues{unsignedOf(from.sparse.count),
                                 from.sparse.indices.bufferView,
                                 unsignedOf(from.sparse.indices.byteOffset),
                                 component(from.sparse.indices.componentType, where + " (sparse)"),
                                 from.sparse.values.bufferView,
                                 unsignedOf(from.sparse.values.byteOffset)};
    return to;
}

int found(const std::map<std::string, int>& attributes, const std::string& name) {
    const auto place = attributes.find(name);
    return place == attributes.end() ? -1 : place->second;
}

Primitive convert(const tinygltf::Primitive& from) {
    Primitive to;
    to.position = found(from.attributes, "POSITION");
    to.normal = found(from.attributes, "NORMAL");
    to.textureCoordinates = found(from.attributes, "TEXCOORD_0");
    for (const char* set : {"0", "1"}) {
        const int joints = found(from.attributes, std::string("JOINTS_") + set);
        const int weights = found(from.attributes, std::string("WEIGHTS_") + set);
        if (joints < 0 || weights < 0) break;
        to.joints.push_back(joints);
        to.weights.push_back(weights);
    }
    for (const auto& target : from.targets) to.targets.push_back({found(target, "POSITION"), found(target, "NORMAL")});
    to.indices = from.indices;
    to.material = from.material;
    to.mode = from.mode;
    return to;
}

/// The spec demands as many sets of weights as of joints: with one of them missing nothing says what follows what.
void requireJointsAndWeights(const std::vector<tinygltf::Mesh>& meshes) {
    for (std::size_t m = 0; m < meshes.size(); ++m)
        for (const tinygltf::Primitive& primitive : meshes[m].primitives)
            for (const auto& [name, accessor] : primitive.attributes)
                for (const auto& [one, other] : {std::pair{"JOINTS_", "WEIGHTS_"}, {"WEIGHTS_", "JOINTS_"}})
                    if (name.starts_with(one) &&
                        !primitive.attributes.contains(other + name.substr(std::string(one).size())))
                        throw Error(fmt::format("mesh {} has {} without {}{}", m, oneLine(name, 30), other,
                                                oneLine(name.substr(std::string(one).size()), 20)));
}

/// What of the primitives is not read, named once.
void noteAttributes(const std::vector<tinygltf::Mesh>& meshes, std::vector<std::string>& notes) {
    std::size_t coloured = 0, manyJoints = 0;
    for (const tinygltf::Mesh& mesh : meshes)
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            if (primitive.attributes.contains("COLOR_0")) ++coloured;
            if (primitive.attributes.contains("JOINTS_2")) ++manyJoints;
        }
    if (coloured > 0) notes.push_back(fmt::format("vertex colours of {} primitives are left out", coloured));
    if (manyJoints > 0)
        notes.push_back(fmt::format("{} primitives have more than 8 joints a vertex; the first 8 count", manyJoints));
}

Mesh convert(const tinygltf::Mesh& from) {
    Mesh to{oneLine(from.name), {}, from.weights};
    for (const tinygltf::Primitive& primitive : from.primitives) to.primitives.push_back(convert(primitive));
    return to;
}

/// Exporters write products of float matrices: a last row that is 0 0 0 1 but for rounding becomes that.
glm::dmat4 withoutRounding(glm::dmat4 matrix) {
    constexpr double rounding = 1e-5;
    const glm::dvec4 exact(0.0, 0.0, 0.0, 1.0);
    for (int column = 0; column < 4; ++column)
        if (std::abs(matrix[column][3] - exact[column]) <= rounding) matrix[column][3] = exact[column];
    return matrix;
}

Node convert(const tinygltf::Node& from) {
    Node to;
    to.name = oneLine(from.name);
    to.children = from.children;
    if (from.matrix.size() == 16) to.matrix = withoutRounding(glm::make_mat4(from.matrix.data()));
    if (from.translation.size() == 3) to.local.translation = glm::make_vec3(from.translation.data());
    if (from.scale.size() == 3) to.local.scale = glm::make_vec3(from.scale.data());
    if (from.rotation.size() == 4)
        to.local.rotation = glm::dquat(from.rotation[3], from.rotation[0], from.rotation[1], from.rotation[2]);
    to.mesh = from.mesh;
    to.skin = from.skin;
    to.camera = from.camera;
    to.weights = from.weights;
    if (const auto light = from.extensions.find("KHR_lights_punctual");
        light != from.extensions.end() && light->second.Has("light"))
        to.light = light->second.Get("light").GetNumberAsInt();
    if (const auto instances = from.extensions.find("EXT_mesh_gpu_instancing"); instances != from.extensions.end()) {
        const tinygltf::Value& attributes = instances->second.Get("attributes");
        const auto found = [&](const char* name) {
            return attributes.Has(name) ? attributes.Get(name).GetNumberAsInt() : -1;
        };
        to.instancing = Instancing{found("TRANSLATION"), found("ROTATION"), found("SCALE")};
    }
    return to;
}

Interpolation interpolation(const std::string& name) {
    if (name == "STEP") return Interpolation::Step;
    if (name == "CUBICSPLINE") return Interpolation::CubicSpline;
    if (name == "LINEAR") return Interpolation::Linear;
    throw Error(fmt::format("an animation has the interpolation \"{}\", expected STEP, LINEAR or CUBICSPLINE",
                            oneLine(name, 30)));
}

TargetPath targetPath(const std::string& name) {
    if (name == "translation") return TargetPath::Translation;
    if (name == "rotation") return TargetPath::Rotation;
    if (name == "scale") return TargetPath::Scale;
    if (name == "weights") return TargetPath::Weights;
    return TargetPath::Other;
}

Animation convert(const tinygltf::Animation& from) {
    Animation to{oneLine(from.name), {}, {}};
    for (const auto& sampler : from.samplers)
        to.samplers.push_back({sampler.input, sampler.output, interpolation(sampler.interpolation)});
    for (const auto& channel : from.channels)
        if (channel.target_node >= 0)
            to.channels.push_back({channel.sampler, channel.target_node, targetPath(channel.target_path)});
    return to;
}

float unit(double value, double fallback) {
    return static_cast<float>(std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : fallback);
}

MaterialSource convert(const tinygltf::Material& from, std::size_t index) {
    MaterialSource to;
    const auto& pbr = from.pbrMetallicRoughness;
    to.material.name = from.name.empty() ? fmt::format("material {}", index) : oneLine(from.name);
    for (int i = 0; i < 4 && pbr.baseColorFactor.size() == 4; ++i)
        to.material.baseColorFactor[i] = unit(pbr.baseColorFactor[static_cast<std::size_t>(i)], 1.0);
    for (int i = 0; i < 3 && from.emissiveFactor.size() == 3; ++i)
        to.material.emissiveFactor[i] = unit(from.emissiveFactor[static_cast<std::size_t>(i)], 0.0);
    to.material.metallicFactor = unit(pbr.metallicFactor, 1.0);
    to.material.roughnessFactor = unit(pbr.roughnessFactor, 1.0);
    to.material.doubleSided = from.doubleSided;
    to.cutOut = from.alphaMode == "MASK";
    to.transparent = from.alphaMode != "OPAQUE" && !to.cutOut;
    if (std::isfinite(from.alphaCutoff)) to.alphaCutoff = from.alphaCutoff;
    to.baseColorTexture = pbr.baseColorTexture.index;
    to.metallicRoughnessTexture = pbr.metallicRoughnessTexture.index;
    to.emissiveTexture = from.emissiveTexture.index;
    for (const auto* texture : {&pbr.baseColorTexture, &pbr.metallicRoughnessTexture})
        to.otherCoordinates =
            to.otherCoordinates ||
            (texture->index >= 0 && (texture->texCoord != 0 || texture->extensions.contains("KHR_texture_transform")));
    return to;
}

TextureSampler samplerOf(const tinygltf::Model& model, const tinygltf::Texture& texture) {
    TextureSampler to;
    if (texture.sampler < 0 || static_cast<std::size_t>(texture.sampler) >= model.samplers.size()) return to;
    const tinygltf::Sampler& from = model.samplers[static_cast<std::size_t>(texture.sampler)];
    const auto wrap = [](int value) {
        if (value == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::ClampToEdge;
        return value == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::MirroredRepeat : Wrap::Repeat;
    };
    to.wrapS = wrap(from.wrapS);
    to.wrapT = wrap(from.wrapT);
    to.nearest = from.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    return to;
}

Light convert(const tinygltf::Light& from) {
    Light to{oneLine(from.name),      from.type, glm::dvec3(1.0), from.intensity, from.spot.innerConeAngle,
             from.spot.outerConeAngle};
    if (from.color.size() == 3) to.colour = glm::make_vec3(from.color.data());
    return to;
}

std::vector<ImageSource> imageSources(const nlohmann::json& root) {
    std::vector<ImageSource> images;
    const auto section = root.find("images");
    if (section == root.end()) return images;
    for (const nlohmann::json& from : *section) {
        ImageSource to;
        const auto text = [&](const char* key) {
            const auto place = from.find(key);
            return place != from.end() && place->is_string() ? place->get<std::string>() : std::string();
        };
        to.name = text("name").empty() ? fmt::format("image {}", images.size()) : oneLine(text("name"));
        to.uri = text("uri");
        if (from.contains("bufferView")) to.view = from["bufferView"].get<int>();
        images.push_back(std::move(to));
    }
    return images;
}

}  // namespace

std::size_t byteSize(Component value) {
    switch (value) {
    case Component::Byte:
    case Component::UnsignedByte: return 1;
    case Component::Short:
    case Component::UnsignedShort: return 2;
    case Component::UnsignedInt:
    case Component::Float: return 4;
    }
    return 4;
}

glm::dmat4 LocalTransform::matrix() const {
    const glm::dmat3 turn = glm::mat3_cast(rotation);
    return {glm::dvec4(turn[0] * scale.x, 0.0), glm::dvec4(turn[1] * scale.y, 0.0), glm::dvec4(turn[2] * scale.z, 0.0),
            glm::dvec4(translation, 1.0)};
}

Model readModel(const Document& document) {
    const tinygltf::Model from = parseStructure(document);
    Model to;
    to.memory = document.memory;
    for (const auto& view : from.bufferViews)
        to.views.push_back({view.buffer, view.byteOffset, view.byteLength, view.byteStride});
    for (const auto& accessor : from.accessors) to.accessors.push_back(convert(accessor, to.accessors.size()));
    requireJointsAndWeights(from.meshes);
    noteAttributes(from.meshes, to.notes);
    for (const auto& mesh : from.meshes) to.meshes.push_back(convert(mesh));
    for (const auto& node : from.nodes) to.nodes.push_back(convert(node));
    for (const auto& skin : from.skins) to.skins.push_back({skin.joints, skin.inverseBindMatrices});
    for (const auto& animation : from.animations) to.animations.push_back(convert(animation));
    for (const auto& material : from.materials) to.materials.push_back(convert(material, to.materials.size()));
    for (const auto& texture : from.textures) {
        to.textureImages.push_back(texture.source);
        to.textureSamplers.push_back(samplerOf(from, texture));
    }
    for (const auto& camera : from.cameras)
        to.cameras.push_back(
            {oneLine(camera.name), camera.type == "perspective", camera.perspective.yfov, camera.perspective.znear});
    for (const auto& light : from.lights) to.lights.push_back(convert(light));
    for (const auto& scene : from.scenes) to.scenes.push_back(scene.nodes);
    to.scene = from.defaultScene >= 0 || from.scenes.empty() ? from.defaultScene : 0;
    to.images = imageSources(document.json);
    const std::vector<std::string> notes = notesOnExtensions(document.json);
    to.notes.insert(to.notes.end(), notes.begin(), notes.end());
    return to;
}

void loadBuffers(Model& model, const Document& document, FilesBeside& files) {
    const auto section = document.json.find("buffers");
    if (section == document.json.end()) return;
    for (const nlohmann::json& buffer : *section) {
        const std::size_t index = model.buffers.size();
        const auto length = buffer.find("byteLength");
        if (length == buffer.end()) throw Error(fmt::format("buffer {} has no byteLength", index));
        const auto uri = buffer.find("uri");
        if (uri != buffer.end() && !uri->is_string())
            throw Error(fmt::format("buffer {} has a URI that is no text", index));
        if (uri == buffer.end() && !(index == 0 && document.binaryChunk))
            throw Error(fmt::format("buffer {} has neither a URI nor a binary chunk", index));

        std::shared_ptr<const Bytes> bytes;
        try {
            bytes = uri == buffer.end() ? document.binaryChunk : files.read(uri->get<std::string>());
        } catch (const Error& error) {
            throw Error(fmt::format("buffer {} {}", index, error.what()));
        }
        model.bufferLengths.push_back(length->get<std::uint64_t>());
        if (model.bufferLengths.back() > bytes->size())
            throw Error(fmt::format("buffer {} needs {} bytes, there are {}", index, model.bufferLengths.back(),
                                    bytes->size()));
        model.buffers.push_back(std::move(bytes));
    }
}

}  // namespace timeshade::gltf
