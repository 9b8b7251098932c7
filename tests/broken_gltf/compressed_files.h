#pragma once

// Compressed models, made by the libraries' own encoders where a build has them.

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "gltf_writer.h"

#ifdef TIMESHADE_MESHOPT
#include <meshoptimizer.h>
#endif
#ifdef TIMESHADE_DRACO
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#endif

namespace timeshade::test {

/// A grid of side x side quads over a wavy ground.
struct Grid {
    explicit Grid(int side) {
        const int row = side + 1;
        for (int y = 0; y <= side; ++y)
            for (int x = 0; x <= side; ++x) {
                const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
                positions.insert(positions.end(), {fx, 0.25f * std::sin(fx * 0.7f + fy), fy});
                coordinates.insert(coordinates.end(), {fx / 8.0f, fy / 8.0f});
                if (x == side || y == side) continue;
                const auto a = static_cast<std::uint32_t>(y * row + x), b = a + static_cast<std::uint32_t>(row);
                indices.insert(indices.end(), {a, b, a + 1, a + 1, b, b + 1});
            }
    }
    std::size_t vertices() const { return positions.size() / 3; }
    std::vector<float> positions, coordinates;
    std::vector<std::uint32_t> indices;
};

inline GltfFile plainFile(const Grid& grid) {
    GltfFile file;
    const int positions = file.vec3s(grid.positions);
    const int coordinates = file.addAccessor<float>(grid.coordinates, "VEC2", 2);
    file.addMesh({{"POSITION", positions}, {"TEXCOORD_0", coordinates}},
                 file.addAccessor<std::uint32_t>(grid.indices, "SCALAR", 1));
    file.addRoot({{"mesh", 0}});
    return file;
}

#ifdef TIMESHADE_MESHOPT

/// A view that is compressed into buffer 0 and stands for bytes of buffer 1, which nobody has.
inline int addMeshopt(GltfFile& file, const std::vector<std::uint8_t>& stream, std::size_t count, std::size_t stride,
                      const char* mode, const char* filter = "NONE") {
    const int view = file.addView(stream.data(), stream.size());
    Json& made = file.json["bufferViews"][static_cast<std::size_t>(view)];
    const Json own = {{"buffer", 0},
                      {"byteOffset", made["byteOffset"]},
                      {"byteLength", stream.size()},
                      {"count", count},
                      {"byteStride", stride},
                      {"mode", mode},
                      {"filter", filter}};
    made = {{"buffer", 1}, {"byteOffset", 0}, {"byteLength", count * stride}};
    if (std::string(mode) == "ATTRIBUTES") made["byteStride"] = stride;
    made["extensions"]["EXT_meshopt_compression"] = own;
    return view;
}

inline std::vector<std::uint8_t> encodedVertices(const void* vertices, std::size_t count, std::size_t stride) {
    std::vector<std::uint8_t> stream(meshopt_encodeVertexBufferBound(count, stride));
    stream.resize(meshopt_encodeVertexBuffer(stream.data(), stream.size(), vertices, count, stride));
    return stream;
}

inline std::vector<std::uint8_t> encodedIndices(const std::vector<std::uint32_t>& indices, std::size_t vertices,
                                                bool list) {
    std::vector<std::uint8_t> stream(list ? meshopt_encodeIndexBufferBound(indices.size(), vertices)
                                          : meshopt_encodeIndexSequenceBound(indices.size(), vertices));
    stream.resize(list ? meshopt_encodeIndexBuffer(stream.data(), stream.size(), indices.data(), indices.size())
                       : meshopt_encodeIndexSequence(stream.data(), stream.size(), indices.data(), indices.size()));
    return stream;
}

inline int accessor(GltfFile& file, int view, int componentType, std::size_t count, const char* type,
                    bool normalized = false) {
    return file.add("accessors", {{"bufferView", view},
                                  {"componentType", componentType},
                                  {"count", count},
                                  {"type", type},
                                  {"normalized", normalized}});
}

inline void finishMeshopt(GltfFile& file) {
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    file.json["buffers"] =
        Json::array({{{"byteLength", file.data.size()}},
                     {{"byteLength", 1 << 24}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}});
}

inline GltfFile meshoptFile(const Grid& grid, bool list, std::size_t indexSize) {
    GltfFile file;
    const int view = addMeshopt(file, encodedVertices(grid.positions.data(), grid.vertices(), 12), grid.vertices(), 12,
                                "ATTRIBUTES");
    const int positions = accessor(file, view, 5126, grid.vertices(), "VEC3");
    const int corners = addMeshopt(file, encodedIndices(grid.indices, grid.vertices(), list), grid.indices.size(),
                                   indexSize, list ? "TRIANGLES" : "INDICES");
    file.addMesh({{"POSITION", positions}},
                 accessor(file, corners, indexSize == 2 ? 5123 : 5125, grid.indices.size(), "SCALAR"));
    file.addRoot({{"mesh", 0}});
    finishMeshopt(file);
    return file;
}

#endif

#ifdef TIMESHADE_DRACO

inline std::vector<std::uint8_t> dracoStream(const Grid& grid, int speed, int bits) {
    draco::TriangleSoupMeshBuilder builder;
    const auto faces = static_cast<int>(grid.indices.size() / 3);
    builder.Start(faces);
    const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int coordinate = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
    for (int f = 0; f < faces; ++f) {
        const std::uint32_t* v = &grid.indices[static_cast<std::size_t>(3 * f)];
        const auto set = [&](int attribute, const std::vector<float>& of, std::size_t width) {
            builder.SetAttributeValuesForFace(attribute, draco::FaceIndex(static_cast<std::uint32_t>(f)),
                                              &of[v[0] * width], &of[v[1] * width], &of[v[2] * width]);
        };
        set(position, grid.positions, 3);
        set(coordinate, grid.coordinates, 2);
    }
    const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetSpeedOptions(speed, speed);
    encoder.SetEncodingMethod(speed == 10 ? draco::MESH_SEQUENTIAL_ENCODING : draco::MESH_EDGEBREAKER_ENCODING);
    if (bits > 0) {
        encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
        encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, bits);
    }
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeMeshToBuffer(*mesh, &buffer).ok()) return {};
    return {buffer.data(), buffer.data() + buffer.size()};
}

inline GltfFile dracoFile(const Grid& grid, const std::vector<std::uint8_t>& stream) {
    GltfFile file;
    const int view = file.addView(stream.data(), stream.size());
    const Json bare = {{"componentType", 5126}, {"count", grid.vertices()}};
    const auto add = [&](const char* type) {
        Json made = bare;
        made["type"] = type;
        return file.add("accessors", made);
    };
    const int position = add("VEC3"), coordinate = add("VEC2");
    const int indices =
        file.add("accessors", {{"componentType", 5125}, {"count", grid.indices.size()}, {"type", "SCALAR"}});
    file.addMesh({{"POSITION", position}, {"TEXCOORD_0", coordinate}}, indices);
    file.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}};
    file.addRoot({{"mesh", 0}});
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return file;
}

#endif

}  // namespace timeshade::test
