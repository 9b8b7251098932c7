// EXT_meshopt_compression, decoded by the library of its authors.

#include <span>

#include <fmt/format.h>

#include "core/error.h"
#include "core/one_line.h"
#include "scene/gltf_compression.h"
#include "scene/gltf_extensions.h"

#ifdef TIMESHADE_MESHOPT
#include <meshoptimizer.h>
#endif

namespace timeshade::gltf {

#ifdef TIMESHADE_MESHOPT

namespace {

using Json = nlohmann::json;

struct Stream {
    std::span<const std::uint8_t> bytes;
    std::uint64_t count = 0, stride = 0;
    std::string mode, filter;
};

std::string textOf(const Json& object, const char* key, const std::string& otherwise) {
    const auto found = object.find(key);
    return found == object.end() ? otherwise : found->is_string() ? found->get<std::string>() : std::string("?");
}

Stream streamOf(const Model& model, const Json& from, const std::string& what) {
    constexpr std::uint64_t most = 0x7fffffff;
    const auto buffer = static_cast<std::size_t>(wholeNumber(from, "buffer", 0, most, what));
    if (buffer >= model.buffers.size())
        throw Error(fmt::format("{}: refers to buffer {}, the file has {}", what, buffer, model.buffers.size()));
    const std::uint64_t offset = from.contains("byteOffset") ? wholeNumber(from, "byteOffset", 0, most, what) : 0;
    const std::uint64_t length = wholeNumber(from, "byteLength", 1, most, what);
    const std::uint64_t size = model.bufferLengths[buffer];
    if (offset > size || length > size - offset)
        throw Error(
            fmt::format("{}: spans bytes {} to {} of a buffer of {} bytes", what, offset, offset + length, size));
    Stream stream;
    stream.bytes = std::span(*model.buffers[buffer]).subspan(offset, length);
    stream.count = wholeNumber(from, "count", 1, most, what);
    stream.stride = wholeNumber(from, "byteStride", 1, 256, what);
    stream.mode = textOf(from, "mode", "?");
    stream.filter = textOf(from, "filter", "NONE");
    return stream;
}

/// Throws Error for what the decoder takes for granted.
void requireDecodable(const Stream& stream, const std::string& what) {
    const bool attributes = stream.mode == "ATTRIBUTES", triangles = stream.mode == "TRIANGLES";
    if (!attributes && !triangles && stream.mode != "INDICES")
        throw Error(fmt::format("{}: its mode is \"{}\", expected ATTRIBUTES, TRIANGLES or INDICES", what,
                                oneLine(stream.mode, 30)));
    const bool strideFits = attributes ? stream.stride % 4 == 0 : stream.stride == 2 || stream.stride == 4;
    if (!strideFits)
        throw Error(fmt::format("{}: its byteStride is {}, expected {}", what, stream.stride,
                                attributes ? "a multiple of 4" : "2 or 4"));
    if (triangles && stream.count % 3 != 0)
        throw Error(fmt::format("{}: it has {} indices, expected whole triangles", what, stream.count));
    const bool octahedral = stream.filter == "OCTAHEDRAL", quaternion = stream.filter == "QUATERNION";
    if (!octahedral && !quaternion && stream.filter != "EXPONENTIAL" && stream.filter != "NONE")
        throw Error(fmt::format("{}: its filter is \"{}\", expected NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL", what,
                                oneLine(stream.filter, 30)));
    const bool filterFits = stream.filter == "NONE" ||
                            (attributes && (!octahedral || stream.stride <= 8) && (!quaternion || stream.stride == 8));
    if (!filterFits)
        throw Error(fmt::format("{}: the filter {} does not go with {} of {} bytes", what, stream.filter, stream.mode,
                                stream.stride));
}

Bytes decoded(const Stream& stream, MemoryBudget& memory, const std::string& what) {
    memory.take(stream.count, stream.stride, what);
    Bytes bytes(static_cast<std::size_t>(stream.count * stream.stride));
    const auto count = static_cast<std::size_t>(stream.count), stride = static_cast<std::size_t>(stream.stride);
    using Decode = int (*)(void*, std::size_t, std::size_t, const unsigned char*, std::size_t);
    const Decode decode = stream.mode == "ATTRIBUTES"  ? Decode{&meshopt_decodeVertexBuffer}
                          : stream.mode == "TRIANGLES" ? Decode{&meshopt_decodeIndexBuffer}
                                                       : Decode{&meshopt_decodeIndexSequence};
    if (decode(bytes.data(), count, stride, stream.bytes.data(), stream.bytes.size()) != 0)
        throw Error(fmt::format("{}: its data is damaged", what));
    if (stream.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes.data(), count, stride);
    if (stream.filter == "QUATERNION") meshopt_decodeFilterQuat(bytes.data(), count, stride);
    if (stream.filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), count, stride);
    return bytes;
}

}  // namespace

void decompressViews(Model& model, const Json& root) {
    const Json::json_pointer place("/extensions/EXT_meshopt_compression");
    std::size_t number = 0;
    for (const Json& view : elements(root, "bufferViews")) {
        const std::size_t index = number++;
        if (!view.contains(place) || index >= model.views.size()) continue;
        const std::string what = fmt::format("bufferView {} (EXT_meshopt_compression)", index);
        const Stream stream = streamOf(model, view[place], what);
        requireDecodable(stream, what);
        if (model.views[index].length > stream.count * stream.stride)
            throw Error(fmt::format("{}: {} elements of {} bytes do not fill its {} bytes", what, stream.count,
                                    stream.stride, model.views[index].length));
        const std::uint64_t stride = model.views[index].stride;
        const int added = addView(model, decoded(stream, *model.memory, what), stride);
        model.views[index] = model.views[static_cast<std::size_t>(added)];
        model.views.pop_back();
    }
}

#else

void decompressViews(Model&, const nlohmann::json&) {}

#endif

}  // namespace timeshade::gltf
