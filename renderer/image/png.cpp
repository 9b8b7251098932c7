#include "core/check.h"
#include "core/error.h"
#include "core/file_bytes.h"
#include "image/decoders.h"
#include "image/png_bytes.h"

#include <fmt/format.h>
#include <stb_image_write.h>

namespace timeshade {
namespace {

constexpr int channels = 3;
constexpr int maximumSide = 1 << 15;

std::size_t byteCount(const DisplayImage& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * channels;
}

void appendBytes(void* context, void* data, int size) {
    auto& bytes = *static_cast<std::vector<char>*>(context);
    const char* begin = static_cast<const char*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
}

/// CRC of PNG's chunks (PNG specification, annex D).
std::uint32_t checksumOf(std::span<const char> bytes) {
    std::uint32_t sum = 0xffffffffu;
    for (const char byte : bytes) {
        sum ^= static_cast<std::uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1u) != 0 ? 0xedb88320u : 0u);
    }
    return ~sum;
}

void appendNumber(std::vector<char>& bytes, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(number >> shift));
}

/// An iTXt chunk, not compressed, without language.
std::vector<char> textChunk(const std::string& keyword, const std::string& text) {
    std::string body = "iTXt" + keyword;
    body += std::string("\0\0\0\0\0", 5) + text;
    std::vector<char> chunk;
    appendNumber(chunk, static_cast<std::uint32_t>(body.size() - 4));
    chunk.insert(chunk.end(), body.begin(), body.end());
    appendNumber(chunk, checksumOf(body));
    return chunk;
}

}  // namespace

std::vector<char> pngBytes(const std::filesystem::path& path, const DisplayImage& image, const std::string& note) {
    CHECK_EQ(image.rgb.size(), byteCount(image));
    std::vector<char> bytes;
    if (stbi_write_png_to_func(appendBytes, &bytes, image.width, image.height, channels, image.rgb.data(),
                               image.width * channels) == 0) {
        throw Error(fmt::format("cannot write {}: a picture of {}x{} cannot be encoded as PNG", path.string(),
                                image.width, image.height));
    }
    if (!note.empty()) {
        constexpr std::ptrdiff_t afterHeader = 8 + 25;  // signature and IHDR
        const std::vector<char> chunk = textChunk("timeshade", note);
        bytes.insert(bytes.begin() + afterHeader, chunk.begin(), chunk.end());
    }
    return bytes;
}

void writePng(const std::filesystem::path& path, const DisplayImage& image, const std::string& note) {
    writeFileAtomically(path, pngBytes(path, image, note));
}

DisplayImage readPng(const std::filesystem::path& path) {
    const std::vector<unsigned char> bytes = readFileBytes(path);
    try {
        const ForeignImage read = decodePng(bytes, {maximumSide, std::size_t{4} * maximumSide * maximumSide});
        DisplayImage image{read.width, read.height, {}};
        image.rgb.reserve(byteCount(image));
        for (std::size_t i = 0; i < read.rgba.size(); i += 4)
            image.rgb.insert(image.rgb.end(), {read.rgba[i], read.rgba[i + 1], read.rgba[i + 2]});
        return image;
    } catch (const Error& error) {
        throw Error(fmt::format("cannot read {}: {}, expected a PNG", path.string(), error.what()));
    }
}

}  // namespace timeshade
