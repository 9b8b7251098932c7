#include "scene/gltf_document.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "core/error.h"
#include "core/json_limits.h"
#include "core/one_line.h"
#include "scene/gltf_extensions.h"

namespace timeshade::gltf {

namespace {

constexpr std::size_t maxJsonBytes = std::size_t{256} << 20;

std::uint32_t littleEndian32(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return static_cast<std::uint32_t>(bytes[offset]) | static_cast<std::uint32_t>(bytes[offset + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[offset + 2]) << 16 | static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

struct Chunks {
    std::span<const std::uint8_t> json;
    std::span<const std::uint8_t> binary;
    bool hasBinary = false;
};

Chunks splitBinaryGltf(std::span<const std::uint8_t> bytes) {
    constexpr std::uint32_t jsonChunk = 0x4e4f534au;  // "JSON"
    constexpr std::uint32_t binChunk = 0x004e4942u;   // "BIN\0"
    if (bytes.size() < 20) throw Error("is a truncated .glb: its header is not complete");
    const std::uint32_t version = littleEndian32(bytes, 4);
    if (version != 2) throw Error(fmt::format("is a .glb of version {}, expected 2", version));
    const std::size_t length = littleEndian32(bytes, 8);
    if (length > bytes.size())
        throw Error(
            fmt::format("is a truncated .glb: its header says {} bytes, the file has {}", length, bytes.size()));
    if (length < 20) throw Error(fmt::format("has a .glb header with a length of {} bytes", length));

    Chunks chunks;
    bool first = true;
    for (std::size_t at = 12; length - at >= 8; first = false) {
        const std::size_t size = littleEndian32(bytes, at);
        const std::uint32_t type = littleEndian32(bytes, at + 4);
        at += 8;
        if (size > length - at) throw Error("is a damaged .glb: a chunk goes past the end of the file");
        if (first && type != jsonChunk) throw Error("is a damaged .glb: its first chunk is not JSON");
        if (first) {
            chunks.json = bytes.subspan(at, size);
        } else if (type == binChunk && !chunks.hasBinary) {
            chunks.binary = bytes.subspan(at, size);
            chunks.hasBinary = true;
        }
        at += size;
        at = std::min((at + 3) / 4 * 4, length);
    }
    return chunks;
}

/// What parsed JSON takes, with the structures that are made of it: the most that was measured, for lists of empty
/// materials and of short texts, and a quarter more. Quoted brackets and commas count too: they take the same room
/// otherwise.
void takeForJson(std::string_view text, MemoryBudget& memory) {
    constexpr std::uint64_t bytesPerObject = 1280, bytesPerValue = 224;
    const auto objects = static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '{'));
    const auto values = static_cast<std::uint64_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return c == ',' || c == '[' || c == ':'; }));
    memory.take(1, 4 * text.size() + bytesPerObject * objects + bytesPerValue * values, "its JSON");
}

nlohmann::json parseJson(std::span<const std::uint8_t> bytes, MemoryBudget& memory) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.size() > maxJsonBytes)
        throw Error(fmt::format("has {} bytes of JSON, the limit is {}", text.size(), maxJsonBytes));
    while (!text.empty() && text.back() == '\0') text.remove_suffix(1);  // some writers pad the chunk with zeros
    if (isNestedTooDeeply(text)) throw Error(fmt::format("its JSON is nested more than {} levels deep", deepestJson));
    takeForJson(text, memory);
    try {
        nlohmann::json root = nlohmann::json::parse(text);
        if (!root.is_object()) throw Error("is not glTF: its JSON is not an object");
        return root;
    } catch (const nlohmann::json::parse_error& error) {
        throw Error(fmt::format("is neither a .glb nor valid JSON (at byte {})", error.byte));
    } catch (const nlohmann::json::exception&) {
        throw Error("its JSON holds a number too large to be read");
    }
}

void refuseOtherVersions(const nlohmann::json& root) {
    const auto asset = root.find("asset");
    if (asset == root.end() || !asset->is_object()) throw Error("is not glTF: it has no \"asset\"");
    const auto version = asset->find("version");
    if (version == asset->end() || !version->is_string()) throw Error("is not glTF: \"asset\" has no version");
    const auto text = version->get<std::string>();
    if (!text.starts_with("2.")) throw Error(fmt::format("is glTF of version \"{}\", expected 2.0", oneLine(text, 20)));
}

}  // namespace

Document parseDocument(Bytes bytes, std::shared_ptr<MemoryBudget> memory) {
    Document document;
    document.memory = std::move(memory);
    const bool binary = bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
    if (bytes.empty()) throw Error("is empty");
    const Chunks chunks = binary ? splitBinaryGltf(bytes) : Chunks{bytes, {}, false};
    document.json = parseJson(chunks.json, *document.memory);
    // Checked first: compressed files fail later checks with messages that hide the cause.
    refuseUnsupportedExtensions(document.json);
    refuseOtherVersions(document.json);
    checkStructure(document.json);
    refuseCompressedGeometry(document.json);
    document.memory->take(1, chunks.binary.size(), "its binary chunk");
    if (chunks.hasBinary)
        document.binaryChunk = std::make_shared<const Bytes>(chunks.binary.begin(), chunks.binary.end());
    return document;
}

Document readDocument(const std::filesystem::path& path, std::size_t limit, std::shared_ptr<MemoryBudget> memory) {
    Bytes bytes = readRegularFile(path, limit, *memory);
    const Sha256 digest = sha256(bytes);
    Document document = parseDocument(std::move(bytes), std::move(memory));
    document.digest = digest;
    return document;
}

}  // namespace timeshade::gltf
