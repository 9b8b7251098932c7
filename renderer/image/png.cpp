#include "image/file_bytes.h"
#include "image/image_file.h"
#include "scene/error.h"

#include <fmt/format.h>
#include <stb_image.h>
#include <stb_image_write.h>

#include <cassert>
#include <limits>
#include <memory>

namespace timeshade {
namespace {

constexpr int channels = 3;

std::size_t byteCount(const DisplayImage& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * channels;
}

void appendBytes(void* context, void* data, int size) {
    auto& bytes = *static_cast<std::vector<char>*>(context);
    const char* begin = static_cast<const char*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
}

struct FreePixels {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

} // namespace

void writePng(const std::filesystem::path& path, const DisplayImage& image) {
    assert(image.rgb.size() == byteCount(image));
    std::vector<char> bytes;
    if (stbi_write_png_to_func(appendBytes, &bytes, image.width, image.height, channels, image.rgb.data(),
                               image.width * channels) == 0) {
        throw Error(fmt::format("cannot write {}: a picture of {}x{} cannot be encoded as PNG", path.string(),
                                image.width, image.height));
    }
    writeFileAtomically(path, bytes);
}

DisplayImage readPng(const std::filesystem::path& path) {
    const std::vector<unsigned char> bytes = readFileBytes(path);
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        throw Error(fmt::format("cannot read {}: {} bytes, expected a PNG below 2 GiB", path.string(), bytes.size()));
    }
    DisplayImage image;
    int channelsFound = 0;
    const std::unique_ptr<stbi_uc, FreePixels> pixels(stbi_load_from_memory(
        bytes.data(), static_cast<int>(bytes.size()), &image.width, &image.height, &channelsFound, channels));
    if (pixels == nullptr) {
        throw Error(fmt::format("cannot read {}: {}, expected a PNG", path.string(), stbi_failure_reason()));
    }
    image.rgb.assign(pixels.get(), pixels.get() + byteCount(image));
    return image;
}

} // namespace timeshade
