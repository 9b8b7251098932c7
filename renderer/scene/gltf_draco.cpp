// KHR_draco_mesh_compression, decoded by the library of its authors. The library allocates what a stream announces; so
// what it announces is counted before, at the places where the decoder has read it and has not yet used it.

#include <algorithm>
#include <map>
#include <span>

#include <fmt/format.h>

#include "core/error.h"
#include "core/one_line.h"
#include "scene/gltf_compression.h"
#include "scene/gltf_extensions.h"

#ifdef TIMESHADE_DRACO
#include <draco/compression/config/decoder_options.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#endif

namespace timeshade::gltf {

#ifdef TIMESHADE_DRACO

namespace {

using Json = nlohmann::json;

// Of a face: its corners, what lies opposite, their vertices, and the face itself, as the library holds them, and half
// as much again; of each attribute's own connectivity; of a number of an attribute, as stored, predicted and converted.
constexpr std::uint64_t bytesPerFace = 120, bytesPerFaceAndSeam = 40, bytesPerNumber = 24;

/// Counts what a stream announces. What its budget refuses is kept, since the library's functions only return false.
class Guard {
  public:
    Guard(MemoryBudget& memory, std::string what) : memory_(memory), what_(std::move(what)) {}

    bool take(std::uint64_t times, std::uint64_t each) {
        try {
            memory_.take(times, each, what_);
            return true;
        } catch (const Error& error) {
            problem_ = error.what();
            return false;
        }
    }

    /// Before the connectivity: `counts` are what follows in the stream, without consuming it.
    bool announces(draco::DecoderBuffer stream, bool edgebreaker) {
        std::uint32_t first = 0, second = 0;
        std::uint8_t seams = 0;
        if (stream.bitstream_version() != DRACO_BITSTREAM_VERSION(2, 2)) {
            problem_ = fmt::format("{}: its stream is not of version 2.2", what_);
            return false;
        }
        if (!draco::DecodeVarint(&first, &stream) || !draco::DecodeVarint(&second, &stream)) return false;
        if (edgebreaker && !stream.Decode(&seams)) return false;
        const std::uint64_t faces = edgebreaker ? second : first, vertices = edgebreaker ? first : second;
        if (vertices > 3 * faces) {
            problem_ = fmt::format("{}: it has {} vertices for {} faces", what_, vertices, faces);
            return false;
        }
        return take(faces, bytesPerFace + seams * bytesPerFaceAndSeam);
    }

    /// Before the attributes' values.
    bool announces(const draco::PointCloud& cloud) {
        std::uint64_t numbers = 0;
        for (std::int32_t i = 0; i < cloud.num_attributes(); ++i) numbers += 1u + cloud.attribute(i)->num_components();
        return take(cloud.num_points(), numbers * bytesPerNumber);
    }

    std::string problem() const { return problem_.empty() ? fmt::format("{}: its data is damaged", what_) : problem_; }

  private:
    MemoryBudget& memory_;
    std::string what_, problem_;
};

template <typename Base, bool edgebreaker>
class GuardedDecoder final : public Base {
  public:
    explicit GuardedDecoder(Guard& guard) : guard_(guard) {}

  protected:
    bool DecodeConnectivity() override {
        return guard_.announces(*this->buffer(), edgebreaker) && Base::DecodeConnectivity();
    }
    bool DecodeAllAttributes() override {
        return guard_.announces(*this->point_cloud()) && Base::DecodeAllAttributes();
    }

  private:
    Guard& guard_;
};

std::unique_ptr<draco::Mesh> decodedMesh(std::span<const std::uint8_t> bytes, MemoryBudget& memory,
                                         const std::string& what) {
    Guard guard(memory, what);
    auto mesh = std::make_unique<draco::Mesh>();
    draco::DecoderBuffer stream;
    stream.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::DecoderBuffer header = stream;
    draco::DracoHeader kind;
    const draco::DecoderOptions options;
    bool good =
        draco::PointCloudDecoder::DecodeHeader(&header, &kind).ok() && kind.encoder_type == draco::TRIANGULAR_MESH;
    if (good && kind.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {
        GuardedDecoder<draco::MeshEdgebreakerDecoder, true> decoder(guard);
        good = decoder.Decode(options, &stream, mesh.get()).ok();
    } else if (good) {
        GuardedDecoder<draco::MeshSequentialDecoder, false> decoder(guard);
        good = decoder.Decode(options, &stream, mesh.get()).ok();
    }
    if (!good) throw Error(guard.problem());
    return mesh;
}

template <typename Number>
Bytes valuesOf(const draco::PointAttribute& from, std::uint32_t points, const std::string& what) {
    const auto components = static_cast<std::size_t>(from.num_components());
    Bytes bytes(points * components * sizeof(Number));
    auto* to = reinterpret_cast<Number*>(bytes.data());
    for (std::uint32_t p = 0; p < points; ++p, to += components) {
        const draco::AttributeValueIndex index = from.mapped_index(draco::PointIndex(p));
        if (index.value() >= from.size() || !from.ConvertValue<Number>(index, from.num_components(), to))
            throw Error(fmt::format("{}: the value of vertex {} can't be had", what, p));
    }
    return bytes;
}

Bytes valuesOf(const draco::PointAttribute& from, Component type, std::uint32_t points, const std::string& what) {
    switch (type) {
    case Component::Byte: return valuesOf<std::int8_t>(from, points, what);
    case Component::UnsignedByte: return valuesOf<std::uint8_t>(from, points, what);
    case Component::Short: return valuesOf<std::int16_t>(from, points, what);
    case Component::UnsignedShort: return valuesOf<std::uint16_t>(from, points, what);
    case Component::UnsignedInt: return valuesOf<std::uint32_t>(from, points, what);
    case Component::Float: break;
    }
    return valuesOf<float>(from, points, what);
}

/// Fills accessors from compressed primitives. Several primitives may share a stream, and accessors with it.
class Unpacker {
  public:
    explicit Unpacker(Model& model) : model_(model) {}

    void unpack(Primitive& primitive, const Json& attributes, const Json& extension, const std::string& what) {
        const std::uint64_t view = wholeNumber(extension, "bufferView", 0, 0x7fffffff, what);
        const draco::Mesh& mesh = meshOf(view, what);
        const auto ids = extension.find("attributes");
        if (ids == extension.end() || !ids->is_object()) throw Error(fmt::format("{}: it has no attributes", what));
        for (const auto& [name, id] : ids->items()) {
            static_cast<void>(id);
            const std::string here = fmt::format("{} {}", what, oneLine(name, 30));
            if (!attributes.contains(name)) throw Error(fmt::format("{}: the primitive has no such attribute", here));
            const auto number = static_cast<std::uint32_t>(wholeNumber(*ids, name.c_str(), 0, 0x7fffffff, what));
            fill(attributes[name].get<int>(), mesh, {view, number}, here);
        }
        fillIndices(primitive, mesh, view, what);
    }

  private:
    using Source = std::pair<std::uint64_t, std::int64_t>;  // view, attribute; -1 for indices

    const draco::Mesh& meshOf(std::uint64_t index, const std::string& what) {
        std::unique_ptr<draco::Mesh>& mesh = meshes_[index];
        if (mesh) return *mesh;
        if (index >= model_.views.size())
            throw Error(fmt::format("{}: refers to bufferView {}, the file has {}", what, index, model_.views.size()));
        const View& view = model_.views[static_cast<std::size_t>(index)];
        const auto buffer = static_cast<std::size_t>(view.buffer);
        const std::uint64_t size =
            view.buffer >= 0 && buffer < model_.buffers.size() ? model_.bufferLengths[buffer] : 0;
        if (view.offset > size || view.length > size - view.offset || view.length == 0)
            throw Error(fmt::format("{}: bufferView {} is not inside its buffer", what, index));
        mesh = decodedMesh(std::span(*model_.buffers[buffer]).subspan(view.offset, view.length), *model_.memory, what);
        return *mesh;
    }

    /// Whether the accessor still has to be filled.
    bool isNew(int index, const Source& source, const std::string& what) {
        if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size())
            throw Error(
                fmt::format("{}: refers to accessor {}, the file has {}", what, index, model_.accessors.size()));
        const auto [known, added] = sources_.try_emplace(index, source);
        if (!added && known->second != source)
            throw Error(fmt::format("{}: accessor {} is that of another compressed attribute too", what, index));
        return added;
    }

    void fill(int index, const draco::Mesh& mesh, const Source& source, const std::string& what) {
        if (!isNew(index, source, what)) return;
        Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
        const draco::PointAttribute* from = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(source.second));
        if (from == nullptr) throw Error(fmt::format("{}: the stream has no attribute {}", what, source.second));
        if (from->num_components() != accessor.components)
            throw Error(fmt::format("{}: the stream has {} components, accessor {} has {}", what,
                                    int{from->num_components()}, index, accessor.components));
        model_.memory->take(mesh.num_points(), byteSize(accessor.type) * std::uint64_t(accessor.components), what);
        accessor.view = addView(model_, valuesOf(*from, accessor.type, mesh.num_points(), what), 0);
        accessor.offset = 0;
        accessor.count = mesh.num_points();
        accessor.sparse.reset();
    }

    void fillIndices(Primitive& primitive, const draco::Mesh& mesh, std::uint64_t view, const std::string& what) {
        if (primitive.indices < 0) {
            primitive.indices = static_cast<int>(model_.accessors.size());
            model_.accessors.emplace_back();
        }
        primitive.mode = 4;  // as the stream has them
        if (!isNew(primitive.indices, {view, -1}, what + " indices")) return;
        model_.memory->take(mesh.num_faces(), 3 * sizeof(std::uint32_t), what + " indices");
        Bytes bytes(std::size_t{mesh.num_faces()} * 3 * sizeof(std::uint32_t));
        auto* to = reinterpret_cast<std::uint32_t*>(bytes.data());
        for (std::uint32_t f = 0; f < mesh.num_faces(); ++f)
            for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(f))) *to++ = corner.value();
        Accessor accessor;
        accessor.view = addView(model_, std::move(bytes), 0);
        accessor.count = std::uint64_t{mesh.num_faces()} * 3;
        accessor.type = Component::UnsignedInt;
        model_.accessors[static_cast<std::size_t>(primitive.indices)] = accessor;
    }

    Model& model_;
    std::map<std::uint64_t, std::unique_ptr<draco::Mesh>> meshes_;  ///< by view
    std::map<int, Source> sources_;                                 ///< by accessor
};

}  // namespace

void decompressPrimitives(Model& model, const Json& root) {
    const Json::json_pointer place("/extensions/KHR_draco_mesh_compression");
    Unpacker unpacker(model);
    std::size_t m = 0;
    for (const Json& mesh : elements(root, "meshes")) {
        std::size_t p = 0;
        for (const Json& primitive : elements(mesh, "primitives")) {
            if (primitive.contains(place) && !hasData(root, primitive) && m < model.meshes.size() &&
                p < model.meshes[m].primitives.size())
                unpacker.unpack(model.meshes[m].primitives[p], primitive["attributes"], primitive[place],
                                fmt::format("mesh {} primitive {} (KHR_draco_mesh_compression)", m, p));
            ++p;
        }
        ++m;
    }
}

#else

void decompressPrimitives(Model&, const nlohmann::json&) {}

#endif

}  // namespace timeshade::gltf
