#include "scene/gltf_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include <fmt/format.h>

#include "core/error.h"
#include "scene/gltf_accessors.h"

namespace timeshade::gltf {

namespace {

/// Farther positions have no useful precision in float, and their products overflow.
constexpr float farthest = 1e15f;

/// What primitives lack or lose.
struct Lacks {
    std::size_t coordinates = 0;  ///< primitives without those that their material's textures read
    std::vector<std::string> notes;
};

enum Mode { TriangleList = 4, TriangleStrip = 5, TriangleFan = 6 };

bool drawable(const Primitive& primitive) { return primitive.mode >= TriangleList && primitive.position >= 0; }

std::uint64_t countOf(const Model& model, int accessor) {
    return model.accessors[static_cast<std::size_t>(accessor)].count;
}

template <typename Vector>
std::vector<Vector> grouped(const std::vector<float>& values) {
    std::vector<Vector> vectors(values.size() / static_cast<std::size_t>(Vector::length()));
    if (!values.empty()) std::memcpy(static_cast<void*>(vectors.data()), values.data(), values.size() * sizeof(float));
    return vectors;
}

/// One value per vertex; empty if the file has none.
template <typename Vector>
std::vector<Vector> readAttribute(const Model& model, int accessor, Integers integers, std::size_t vertexCount,
                                  const std::string& what) {
    if (accessor < 0) return {};
    if (countOf(model, accessor) != vertexCount)
        throw Error(fmt::format("{}: accessor {} has {} elements for {} vertices", what, accessor,
                                countOf(model, accessor), vertexCount));
    return grouped<Vector>(readFloats(model, accessor, static_cast<int>(Vector::length()), integers, what));
}

std::vector<glm::vec3> readPositions(const Model& model, int accessor, std::size_t vertexCount,
                                     const std::string& what) {
    auto positions = readAttribute<glm::vec3>(model, accessor, Integers::Quantized, vertexCount, what);
    for (const glm::vec3& p : positions)
        if (std::abs(p.x) > farthest || std::abs(p.y) > farthest || std::abs(p.z) > farthest)
            throw Error(fmt::format("{}: accessor {} has a position beyond {}", what, accessor, farthest));
    return positions;
}

std::vector<glm::u32vec3> assemble(const std::vector<std::uint32_t>& corners, int mode) {
    std::vector<glm::u32vec3> triangles;
    const std::size_t count = corners.size();
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && a != c) triangles.emplace_back(a, b, c);  // strips are stitched by such triangles
    };
    triangles.reserve(mode == TriangleList ? count / 3 : count);
    if (mode == TriangleList)
        for (std::size_t i = 0; i + 2 < count; i += 3) add(corners[i], corners[i + 1], corners[i + 2]);
    if (mode == TriangleStrip)
        for (std::size_t i = 0; i + 2 < count; ++i)
            i % 2 == 0 ? add(corners[i], corners[i + 1], corners[i + 2])
                       : add(corners[i + 1], corners[i], corners[i + 2]);
    if (mode == TriangleFan)
        for (std::size_t i = 0; i + 2 < count; ++i) add(corners[0], corners[i + 1], corners[i + 2]);
    return triangles;
}

std::vector<glm::u32vec3> readTriangles(const Model& model, const Primitive& primitive, std::size_t vertexCount,
                                        const std::string& what) {
    std::vector<std::uint32_t> corners;
    if (primitive.indices >= 0) {
        corners = readUnsigned(model, primitive.indices, 1, true, what + " indices");
        for (const std::uint32_t corner : corners)
            if (corner >= vertexCount)
                throw Error(fmt::format("{}: index {} is beyond its {} vertices", what, corner, vertexCount));
    } else {
        corners.resize(vertexCount);
        std::iota(corners.begin(), corners.end(), 0u);
    }
    return assemble(corners, primitive.mode);
}

/// Replaces broken or zero-length normals one by one. This affects shading only, not shadows.
std::vector<glm::vec3> readNormals(const Model& model, const Primitive& primitive, const Geometry& geometry,
                                   const std::string& what) {
    std::vector<glm::vec3> generated;
    auto normals = readAttribute<glm::vec3>(model, primitive.normal, Integers::Normalized, geometry.positions.size(),
                                            what + " NORMAL");
    if (normals.empty()) return generatedNormals(geometry.positions, geometry.triangles);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double length = glm::length(glm::dvec3(normals[i]));
        if (length > 1e-6) {
            normals[i] = glm::vec3(glm::dvec3(normals[i]) / length);
        } else {
            if (generated.empty()) generated = generatedNormals(geometry.positions, geometry.triangles);
            normals[i] = generated[i];
        }
    }
    return normals;
}

void normaliseWeights(std::vector<JointSet>& sets, std::size_t vertexCount) {
    for (std::size_t v = 0; v < vertexCount; ++v) {
        double sum = 0.0;
        for (JointSet& set : sets) {
            set.weights[v] = glm::max(set.weights[v], glm::vec4(0.0f));
            for (int i = 0; i < 4; ++i) sum += static_cast<double>(set.weights[v][i]);
        }
        for (JointSet& set : sets)
            set.weights[v] = sum > 0.0 ? glm::vec4(glm::dvec4(set.weights[v]) / sum) : glm::vec4(0.0f);
    }
}

std::vector<JointSet> readJointSets(const Model& model, const Primitive& primitive, std::size_t vertexCount,
                                    std::size_t jointCount, const std::string& what) {
    std::vector<JointSet> sets(primitive.joints.size());
    for (std::size_t s = 0; s < sets.size(); ++s) {
        sets[s].weights =
            readAttribute<glm::vec4>(model, primitive.weights[s], Integers::Normalized, vertexCount, what + " WEIGHTS");
        const auto joints = readUnsigned(model, primitive.joints[s], 4, false, what + " JOINTS");
        if (joints.size() != vertexCount * 4)
            throw Error(fmt::format("{} JOINTS has {} elements for {} vertices", what, joints.size() / 4, vertexCount));
        sets[s].joints.resize(vertexCount);
        for (std::size_t i = 0; i < joints.size(); ++i) {
            const auto lane = static_cast<int>(i % 4);
            // Exporters often leave joints with weight 0 uninitialised; only joints with a weight must exist.
            const bool counts = sets[s].weights[i / 4][lane] > 0.0f;
            if (counts && joints[i] >= jointCount)
                throw Error(
                    fmt::format("{}: vertex {} follows joint {}, its skin has {}", what, i / 4, joints[i], jointCount));
            sets[s].joints[i / 4][lane] = static_cast<std::uint16_t>(counts ? joints[i] : 0u);
        }
    }
    normaliseWeights(sets, vertexCount);
    return sets;
}

/// One value per vertex of the texture coordinates that a material's textures read; zeros where the file has none.
std::vector<glm::vec2> readCoordinates(const Model& model, const Primitive& primitive, const CoordinateSource& source,
                                       std::size_t vertexCount, const std::string& what) {
    const auto set = primitive.textureCoordinates.find(source.set);
    if (set == primitive.textureCoordinates.end()) return std::vector<glm::vec2>(vertexCount, glm::vec2(0.0f));
    auto read = readAttribute<glm::vec2>(model, set->second, Integers::Quantized, vertexCount,
                                         fmt::format("{} TEXCOORD_{}", what, source.set));
    if (source.fromSet != glm::dmat3(1.0))
        for (glm::vec2& place : read) place = glm::vec2(source.fromSet * glm::dvec3(place, 1.0));
    return read;
}

void readAllCoordinates(const Model& model, const Primitive& primitive, Geometry& geometry, Lacks& lacks,
                        const std::string& what) {
    const std::size_t vertexCount = geometry.positions.size();
    const MaterialSource none;
    const MaterialSource& material =
        primitive.material < 0 ? none : model.materials[static_cast<std::size_t>(primitive.material)];
    const auto read = [&](std::size_t list) {
        return readCoordinates(model, primitive, material.coordinates[list], vertexCount, what);
    };
    geometry.textureCoordinates = read(0);
    if (material.coordinates.size() > 1) {
        model.memory->take(vertexCount, sizeof(glm::vec4), what);
        geometry.moreCoordinates.resize(vertexCount, glm::vec4(0.0f));
    }
    for (std::size_t list = 1; list < material.coordinates.size(); ++list) {
        const std::vector<glm::vec2> places = read(list);
        for (std::size_t v = 0; v < vertexCount; ++v) {
            geometry.moreCoordinates[v][list == 1 ? 0 : 2] = places[v].x;
            geometry.moreCoordinates[v][list == 1 ? 1 : 3] = places[v].y;
        }
    }
    const auto lacking = [&](const CoordinateSource& source) {
        return !primitive.textureCoordinates.contains(source.set);
    };
    if (material.textured && std::any_of(material.coordinates.begin(), material.coordinates.end(), lacking))
        ++lacks.coordinates;
}

/// Colours, which change looks alone: where they can't be read, there is a note.
std::vector<glm::vec4> readColours(const Model& model, const Primitive& primitive, std::size_t vertexCount,
                                   std::vector<std::string>& notes, const std::string& what) {
    if (primitive.colours < 0) return {};
    std::vector<glm::vec4> colours;
    try {
        if (model.accessors[static_cast<std::size_t>(primitive.colours)].components == 4) {
            colours = readAttribute<glm::vec4>(model, primitive.colours, Integers::Normalized, vertexCount,
                                               what + " COLOR_0");
        } else {
            model.memory->take(vertexCount, sizeof(glm::vec4), what + " COLOR_0");
            for (const glm::vec3& rgb : readAttribute<glm::vec3>(model, primitive.colours, Integers::Normalized,
                                                                 vertexCount, what + " COLOR_0"))
                colours.emplace_back(rgb, 1.0f);
        }
    } catch (const Error& error) {
        notes.push_back(fmt::format("vertex colours are left out: {}", error.what()));
        return {};
    }
    bool held = false, white = true;
    for (glm::vec4& colour : colours) {
        const glm::vec4 within = glm::clamp(colour, 0.0f, 1.0f);
        held = held || within != colour;
        white = white && within == glm::vec4(1.0f);
        colour = within;
    }
    if (held) notes.push_back(fmt::format("{} COLOR_0 has colours beyond 0 to 1, which are held there", what));
    if (white) colours.clear();
    return colours;
}

Geometry readGeometry(const Model& model, const Primitive& primitive, std::size_t jointCount, Lacks& lacks,
                      const std::string& what) {
    Geometry geometry;
    const auto vertexCount = static_cast<std::size_t>(countOf(model, primitive.position));
    geometry.positions = readPositions(model, primitive.position, vertexCount, what + " POSITION");
    geometry.triangles = readTriangles(model, primitive, vertexCount, what);
    // Also what is worked out where the file has none: normals, texture coordinates, triangles of lists of corners.
    model.memory->take(vertexCount, sizeof(glm::vec3) + sizeof(glm::vec2), what);
    model.memory->take(geometry.triangles.size(), sizeof(glm::u32vec3), what);
    geometry.normals = readNormals(model, primitive, geometry, what);
    readAllCoordinates(model, primitive, geometry, lacks, what);
    geometry.colours = readColours(model, primitive, vertexCount, lacks.notes, what);
    const bool cutOut = primitive.material >= 0 && model.materials[static_cast<std::size_t>(primitive.material)].cutOut;
    if (cutOut && std::any_of(geometry.colours.begin(), geometry.colours.end(), [](auto& c) { return c.w < 1.0f; }))
        lacks.notes.push_back(fmt::format("{} COLOR_0 has an alpha below 1, which cuts nothing out", what));
    if (jointCount > 0) geometry.jointSets = readJointSets(model, primitive, vertexCount, jointCount, what);
    for (const MorphTarget& target : primitive.targets) {
        MorphDeltas deltas;
        deltas.positions = readPositions(model, target.position, vertexCount, what + " morph POSITION");
        if (primitive.normal >= 0)
            deltas.normals = readAttribute<glm::vec3>(model, target.normal, Integers::Normalized, vertexCount,
                                                      what + " morph NORMAL");
        geometry.morphs.push_back(std::move(deltas));
    }
    geometry.material = primitive.material;
    return geometry;
}

void spend(std::size_t& used, std::uint64_t amount, const Budget& budget, const char* what) {
    if (amount > budget.most - used)
        throw Error(fmt::format("has more than {} {} over all its instances, which is the limit", budget.most, what));
    used += static_cast<std::size_t>(amount);
}

// What one more vertex and one more triangle of an instance take, as measured: in the topology and the poses that are
// compared while loading, in a frame's two ends, packed for the device and in its buffers.
constexpr std::uint64_t bytesPerVertex = 480, bytesPerTriangle = 700;
// Of a vertex with colours or more texture coordinates beside: in the topology, its copies and the device's buffers.
constexpr std::uint64_t bytesPerLook = 4 * sizeof(glm::vec4);

void spendOnPrimitive(const Model& model, const Primitive& primitive, Budget& budget) {
    const std::uint64_t vertices = countOf(model, primitive.position);
    spend(budget.vertices, vertices, budget, "vertices");
    // Targets are stored per mesh, their weights per node; counting per node bounds both.
    for (std::size_t target = 0; target < primitive.targets.size(); ++target)
        spend(budget.morphs, vertices, budget, "vertices of morph targets");
    spend(budget.triangles, mostTrianglesOf(model, primitive), budget, "triangles");
}

/// A scene of which one vertex has a colour holds one for each.
void takeForLooks(const Model& model, const std::vector<std::vector<Geometry>>& geometries, std::size_t vertices) {
    bool colours = false, coordinates = false;
    for (const std::vector<Geometry>& mesh : geometries)
        for (const Geometry& geometry : mesh) {
            colours = colours || !geometry.colours.empty();
            coordinates = coordinates || !geometry.moreCoordinates.empty();
        }
    for (const auto& [has, what] : {std::pair{colours, "vertex colours"}, {coordinates, "more texture coordinates"}})
        if (has) model.memory->take(vertices, bytesPerLook, fmt::format("its {} over all instances", what));
}

}  // namespace

std::uint64_t mostTrianglesOf(const Model& model, const Primitive& primitive) {
    if (!drawable(primitive)) return 0;
    const std::uint64_t corners = countOf(model, primitive.indices >= 0 ? primitive.indices : primitive.position);
    return primitive.mode == TriangleList ? corners / 3 : corners;
}

std::vector<std::vector<Geometry>> readGeometries(const Model& model, Budget budget, std::vector<std::string>& notes,
                                                  const LoadingWatch& watch) {
    std::vector<std::size_t> uses(model.meshes.size(), 0);
    std::vector<std::size_t> jointCounts(model.meshes.size(), 0);  // the fewest of the skins that deform a mesh
    for (const Node& node : model.nodes) {
        if (node.mesh < 0) continue;
        const auto mesh = static_cast<std::size_t>(node.mesh);
        for (const Primitive& primitive : model.meshes[mesh].primitives)
            if (primitive.position >= 0) spendOnPrimitive(model, primitive, budget);
        if (!node.inScene) continue;
        ++uses[mesh];
        if (node.skin < 0) continue;
        const std::size_t joints = model.skins[static_cast<std::size_t>(node.skin)].joints.size();
        jointCounts[mesh] = jointCounts[mesh] == 0 ? joints : std::min(jointCounts[mesh], joints);
    }
    model.memory->take(budget.vertices, bytesPerVertex, "its vertices over all instances");
    model.memory->take(budget.triangles, bytesPerTriangle, "its triangles over all instances");

    std::vector<std::vector<Geometry>> geometries(model.meshes.size());
    std::size_t skipped = 0;
    Lacks lacks;
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        watch({"meshes", m, model.meshes.size()});
        for (std::size_t p = 0; uses[m] > 0 && p < model.meshes[m].primitives.size(); ++p) {
            const Primitive& primitive = model.meshes[m].primitives[p];
            if (!drawable(primitive))
                ++skipped;
            else
                geometries[m].push_back(
                    readGeometry(model, primitive, jointCounts[m], lacks, fmt::format("mesh {} primitive {}", m, p)));
        }
    }
    takeForLooks(model, geometries, budget.vertices);
    if (skipped > 0)
        notes.push_back(fmt::format("{} primitives of points, lines or without positions are left out", skipped));
    if (lacks.coordinates > 0)
        notes.push_back(fmt::format("{} primitives lack texture coordinates that their textures read; they get 0, 0",
                                    lacks.coordinates));
    notes.insert(notes.end(), lacks.notes.begin(), lacks.notes.end());
    return geometries;
}

}  // namespace timeshade::gltf
