#include "core/check.h"
#include "core/error.h"
#include "core/file_bytes.h"
#include "image/image_file.h"

#include <fmt/format.h>
#include <tinyexr.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>

namespace timeshade {
namespace {

// OpenEXR stores channels in alphabetical order; the number is the channel's place in our pixels.
struct StoredChannel {
    const char* name;
    std::size_t offset;
};
constexpr std::array<StoredChannel, 3> storedChannels = {{{"B", 2}, {"G", 1}, {"R", 0}}};
constexpr std::size_t pixelSize = 3;

struct FreeMemory {
    void operator()(unsigned char* memory) const { std::free(memory); }
};

std::string takeMessage(const char* message) {
    std::string text = message != nullptr ? message : "no reason given";
    FreeEXRErrorMessage(message);
    // tinyexr ends its messages with line breaks; messages of this program have one line.
    while (!text.empty() && text.back() == '\n') {
        text.pop_back();
    }
    return text;
}

/// tinyexr's structures while a file is read; freed on every return and exception.
struct LoadedExr {
    LoadedExr() {
        InitEXRHeader(&header);
        InitEXRImage(&image);
    }
    ~LoadedExr() {
        FreeEXRImage(&image);
        FreeEXRHeader(&header);
    }
    LoadedExr(const LoadedExr&) = delete;
    LoadedExr& operator=(const LoadedExr&) = delete;

    EXRHeader header;
    EXRImage image;
};

[[noreturn]] void failReading(const std::filesystem::path& path, std::string_view found) {
    throw Error(fmt::format("cannot read {}: {}, expected an EXR of scan lines with channels R, G and B", path.string(),
                            found));
}

void load(const std::filesystem::path& path, const std::vector<unsigned char>& bytes, LoadedExr& exr) {
    EXRVersion version{};
    if (ParseEXRVersionFromMemory(&version, bytes.data(), bytes.size()) != TINYEXR_SUCCESS) {
        failReading(path, "not an EXR");
    }
    if (version.multipart != 0 || version.non_image != 0 || version.tiled != 0) {
        failReading(path, "found tiles, parts or deep data");
    }
    const char* message = nullptr;
    if (ParseEXRHeaderFromMemory(&exr.header, &version, bytes.data(), bytes.size(), &message) != TINYEXR_SUCCESS) {
        failReading(path, takeMessage(message));
    }
    for (int channel = 0; channel < exr.header.num_channels; ++channel) {
        if (exr.header.pixel_types[channel] == TINYEXR_PIXELTYPE_HALF) {
            exr.header.requested_pixel_types[channel] = TINYEXR_PIXELTYPE_FLOAT;
        }
    }
    // If loading fails, tinyexr frees as many channels as this number says.
    exr.image.num_channels = exr.header.num_channels;
    if (LoadEXRImageFromMemory(&exr.image, &exr.header, bytes.data(), bytes.size(), &message) != TINYEXR_SUCCESS) {
        // tinyexr has freed what it had loaded, but left the pointers set.
        InitEXRImage(&exr.image);
        failReading(path, takeMessage(message));
    }
}

const unsigned char* findChannel(const LoadedExr& exr, std::string_view name) {
    for (int channel = 0; channel < exr.header.num_channels; ++channel) {
        // Half floats were converted while loading; integer channels are not colours.
        if (exr.header.channels[channel].name == name && exr.header.pixel_types[channel] != TINYEXR_PIXELTYPE_UINT) {
            return exr.image.images[channel];
        }
    }
    return nullptr;
}

}  // namespace

void writeExr(const std::filesystem::path& path, const LinearImage& image) {
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    CHECK_EQ(image.rgb.size(), pixels * pixelSize);

    std::array<std::vector<float>, storedChannels.size()> planes;
    std::array<unsigned char*, storedChannels.size()> planePointers{};
    std::array<EXRChannelInfo, storedChannels.size()> channels{};
    std::array<int, storedChannels.size()> types{};
    for (std::size_t channel = 0; channel < storedChannels.size(); ++channel) {
        planes[channel].resize(pixels);
        for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
            planes[channel][pixel] = image.rgb[pixel * pixelSize + storedChannels[channel].offset];
        }
        planePointers[channel] = reinterpret_cast<unsigned char*>(planes[channel].data());
        std::strcpy(channels[channel].name, storedChannels[channel].name);
        types[channel] = TINYEXR_PIXELTYPE_FLOAT;
    }

    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = static_cast<int>(storedChannels.size());
    header.channels = channels.data();
    header.pixel_types = types.data();
    header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
    EXRImage exr;
    InitEXRImage(&exr);
    exr.num_channels = header.num_channels;
    exr.images = planePointers.data();
    exr.width = image.width;
    exr.height = image.height;

    unsigned char* memory = nullptr;
    const char* message = nullptr;
    const std::size_t size = SaveEXRImageToMemory(&exr, &header, &memory, &message);
    const std::unique_ptr<unsigned char, FreeMemory> owned(memory);
    if (size == 0) {
        throw Error(fmt::format("cannot write {}: a picture of {}x{} cannot be encoded as EXR: {}", path.string(),
                                image.width, image.height, takeMessage(message)));
    }
    writeFileAtomically(path, {reinterpret_cast<const char*>(memory), size});
}

LinearImage readExr(const std::filesystem::path& path) {
    const std::vector<unsigned char> bytes = readFileBytes(path);
    LoadedExr exr;
    load(path, bytes, exr);

    LinearImage image{exr.image.width, exr.image.height, {}};
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.rgb.resize(pixels * pixelSize);
    for (const StoredChannel& channel : storedChannels) {
        const unsigned char* plane = findChannel(exr, channel.name);
        if (plane == nullptr) {
            failReading(path, fmt::format("found no channel {} of floating-point numbers", channel.name));
        }
        for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
            std::memcpy(&image.rgb[pixel * pixelSize + channel.offset], plane + pixel * sizeof(float), sizeof(float));
        }
    }
    return image;
}

}  // namespace timeshade
