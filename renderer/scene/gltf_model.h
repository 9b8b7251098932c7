#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "scene/gltf_document.h"
#include "scene/material.h"

namespace timeshade::gltf {

/// Component types; the values are glTF's.
enum class Component {
    Byte = 5120,
    UnsignedByte = 5121,
    Short = 5122,
    UnsignedShort = 5123,
    UnsignedInt = 5125,
    Float = 5126
};

std::size_t byteSize(Component component);

struct View {
    int buffer = -1;
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    std::uint64_t stride = 0;  ///< 0: tightly packed
};

struct SparseValues {
    std::uint64_t count = 0;
    int indexView = -1;
    std::uint64_t indexOffset = 0;
    Component indexType = Component::UnsignedInt;
    int valueView = -1;
    std::uint64_t valueOffset = 0;
};

struct Accessor {
    int view = -1;  ///< -1: all zeros, but for the sparse values
    std::uint64_t offset = 0;
    std::uint64_t count = 0;
    int components = 1;  ///< 1..4 or 16
    Component type = Component::Float;
    bool normalized = false;
    std::optional<SparseValues> sparse;
};

/// Accessor indices, -1 where absent.
struct MorphTarget {
    int position = -1;
    int normal = -1;
};

struct Primitive {
    int position = -1;
    int normal = -1;
    int colours = -1;
    std::map<int, int> textureCoordinates;  ///< by set: 0 for TEXCOORD_0 and so on
    std::vector<int> joints;                ///< JOINTS_0 and JOINTS_1, as many as there are, both lists of one length
    std::vector<int> weights;
    std::vector<MorphTarget> targets;
    int indices = -1;
    int material = -1;
    int mode = 4;
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
    std::vector<double> weights;
};

/// A node's own transform: parentFromNode = T * R * S.
struct LocalTransform {
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};
    glm::dmat4 matrix() const;
};

/// Accessors of EXT_mesh_gpu_instancing, -1 where absent.
struct Instancing {
    int translation = -1;
    int rotation = -1;
    int scale = -1;
};

struct Node {
    std::string name;
    int parent = -1;
    std::vector<int> children;
    LocalTransform local;
    std::optional<glm::dmat4> matrix;  ///< replaces `local` if the file gives a matrix
    int mesh = -1;
    int skin = -1;
    int camera = -1;
    int light = -1;
    std::optional<Instancing> instancing;  ///< of its mesh, until they are expanded
    std::vector<double> weights;
    bool inScene = false;  ///< reachable from the scene that is shown
};

struct Skin {
    std::vector<int> joints;
    int inverseBindMatrices = -1;
};

enum class Interpolation { Step, Linear, CubicSpline };
/// What a channel drives: of a node, or from Colour on of a light.
enum class TargetPath {
    Translation,
    Rotation,
    Scale,
    Weights,
    Other,
    Colour,
    Intensity,
    Range,
    InnerConeAngle,
    OuterConeAngle
};

struct AnimationSampler {
    int input = -1;
    int output = -1;
    Interpolation interpolation = Interpolation::Linear;
};

struct AnimationChannel {
    int sampler = -1;
    int node = -1;  ///< -1 where a light is driven
    TargetPath path = TargetPath::Other;
    int light = -1;
};

struct Animation {
    std::string name;
    std::vector<AnimationSampler> samplers;
    std::vector<AnimationChannel> channels;
};

struct Camera {
    std::string name;
    bool perspective = true;
    double verticalFieldOfView = 0.0;
    double nearDistance = 0.0;
};

struct Light {
    std::string name;
    std::string type;
    glm::dvec3 colour{1.0};
    double intensity = 1.0;
    double innerConeAngle = 0.0;
    double outerConeAngle = 0.785398163397448;
    double range = 0.0;  ///< 0: none
};

/// Texture coordinates as a texture of a material reads them: those of a set, with the texture's transform.
struct CoordinateSource {
    int set = 0;
    glm::dmat3 fromSet{1.0};  ///< affine, of (u, v, 1)
    bool operator==(const CoordinateSource&) const = default;
};

/// Material of the file; the images of its textures are texture indices until the images have been read.
struct MaterialSource {
    Material material;
    /// What the geometry's texture coordinates 0, 1, 2 are, as many as the material needs, at least one.
    std::vector<CoordinateSource> coordinates{CoordinateSource{}};
    bool textured = false;
    bool transparent = false;  ///< blended; drawn opaque
    bool cutOut = false;       ///< alphaMode MASK
    double alphaCutoff = 0.5;
};

struct Texture {
    int image = -1;  ///< -1 for none
    Wrap wrapU = Wrap::Repeat, wrapV = Wrap::Repeat;
    bool nearest = false;  ///< its magFilter
};

struct ImageSource {
    std::string name;
    std::string uri;
    int view = -1;
};

/// The contents of a file as plain data. After readModel() and validate(), every index is in range, every accessor is
/// inside its view and every view inside its buffer.
struct Model {
    std::vector<std::shared_ptr<const Bytes>> buffers;
    std::vector<std::uint64_t> bufferLengths;  ///< as declared; at most the size of the bytes
    std::vector<View> views;
    std::vector<Accessor> accessors;
    std::vector<Mesh> meshes;
    std::vector<Node> nodes;
    std::vector<int> parentsFirst;  ///< all nodes, each after its parent
    std::vector<Skin> skins;
    std::vector<Animation> animations;
    std::vector<MaterialSource> materials;
    std::vector<Texture> textures;
    std::vector<ImageSource> images;
    std::vector<Camera> cameras;
    std::vector<Light> lights;
    std::vector<std::vector<int>> scenes;  ///< root nodes of each
    int scene = -1;                        ///< the one that is shown; -1: all roots
    std::vector<std::string> notes;        ///< on what is left out or replaced
    std::shared_ptr<MemoryBudget> memory;  ///< what is made of the model is counted here before it is allocated
};

/// Converts the JSON. Checks only what this struct needs; validate() checks the rest.
Model readModel(const Document& document);

/// Loads the buffers that the file names.
void loadBuffers(Model& model, const Document& document, FilesBeside& files);

/// Throws Error for the first value that a later step could not rely on. Fills parent, inScene and parentsFirst.
void validate(Model& model);

}  // namespace timeshade::gltf
