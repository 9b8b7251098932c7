// Images that anyone may have made: what is decoded is what was encoded, and what is damaged, cut off, or larger than
// it may be costs a message.
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <jpeglib.h>
#include <png.h>

#include "core/error.h"
#include "image/foreign_image.h"

namespace timeshade {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int width = 37, height = 21;

/// Smooth, so that JPEG keeps it nearly.
Bytes gradient(int channels) {
    Bytes pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c) pixels.push_back(static_cast<std::uint8_t>(40 + 3 * x + 2 * y + 20 * c));
    return pixels;
}

Bytes jpegOf(int channels, J_COLOR_SPACE space, bool progressive) {
    Bytes pixels = gradient(channels);
    jpeg_compress_struct encoder{};
    jpeg_error_mgr manager{};
    encoder.err = jpeg_std_error(&manager);
    jpeg_create_compress(&encoder);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&encoder, &bytes, &size);
    encoder.image_width = width;
    encoder.image_height = height;
    encoder.input_components = channels;
    encoder.in_color_space = space;
    jpeg_set_defaults(&encoder);
    jpeg_set_quality(&encoder, 98, TRUE);
    if (progressive) jpeg_simple_progression(&encoder);
    jpeg_start_compress(&encoder, TRUE);
    for (int y = 0; y < height; ++y) {
        JSAMPROW row = pixels.data() + std::size_t(y) * width * std::size_t(channels);
        jpeg_write_scanlines(&encoder, &row, 1);
    }
    jpeg_finish_compress(&encoder);
    jpeg_destroy_compress(&encoder);
    Bytes result(bytes, bytes + size);
    std::free(bytes);
    return result;
}

Bytes pngOf(std::uint32_t format, int channels) {
    const Bytes pixels = gradient(channels);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = format;
    png_alloc_size_t size = 0;
    png_image_write_to_memory(&image, nullptr, &size, 0, pixels.data(), 0, nullptr);
    Bytes bytes(size);
    png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr);
    bytes.resize(size);
    return bytes;
}

std::string errorOf(const Bytes& bytes, const ImageLimits& limits = {}) {
    try {
        decodeImage(bytes, limits);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ForeignImage, ReadsEveryKindOfPng) {
    const struct {
        std::uint32_t format;
        int channels;
    } kinds[] = {{PNG_FORMAT_GRAY, 1}, {PNG_FORMAT_GA, 2}, {PNG_FORMAT_RGB, 3}, {PNG_FORMAT_RGBA, 4}};
    for (const auto& kind : kinds) {
        const ForeignImage image = decodeImage(pngOf(kind.format, kind.channels), {});
        ASSERT_EQ(image.width, width);
        ASSERT_EQ(image.height, height);
        const Bytes stored = gradient(kind.channels);
        for (std::size_t i = 0; i < stored.size() / std::size_t(kind.channels); ++i) {
            const std::uint8_t* in = stored.data() + i * std::size_t(kind.channels);
            const bool grey = kind.channels < 3;
            EXPECT_EQ(image.rgba[4 * i], in[0]);
            EXPECT_EQ(image.rgba[4 * i + 1], grey ? in[0] : in[1]);
            EXPECT_EQ(image.rgba[4 * i + 2], grey ? in[0] : in[2]);
            EXPECT_EQ(image.rgba[4 * i + 3], kind.channels % 2 == 0 ? in[kind.channels - 1] : 255);
        }
    }
}

TEST(ForeignImage, ReadsEveryKindOfJpeg) {
    const struct {
        int channels;
        J_COLOR_SPACE space;
        bool progressive;
    } kinds[] = {{1, JCS_GRAYSCALE, false}, {3, JCS_RGB, false}, {3, JCS_RGB, true}, {4, JCS_CMYK, false}};
    for (const auto& kind : kinds) {
        const ForeignImage image = decodeImage(jpegOf(kind.channels, kind.space, kind.progressive), {});
        ASSERT_EQ(image.width, width);
        ASSERT_EQ(image.height, height);
        const Bytes stored = gradient(kind.channels);
        for (std::size_t i = 0; i < stored.size() / std::size_t(kind.channels); ++i) {
            const std::uint8_t* in = stored.data() + i * std::size_t(kind.channels);
            for (std::size_t c = 0; c < 3; ++c) {
                const int value = kind.channels == 4 ? in[c] * in[3] / 255 : in[kind.channels == 1 ? 0 : c];
                EXPECT_NEAR(image.rgba[4 * i + c], value, 8) << kind.channels << " channels, pixel " << i;
            }
            EXPECT_EQ(image.rgba[4 * i + 3], 255);
        }
    }
}

/// A table of Huffman codes that claims more than 256 of them.
TEST(ForeignImage, RefusesTablesThatClaimTooMuch) {
    Bytes jpeg = jpegOf(3, JCS_RGB, false);
    for (std::size_t i = 0; i + 22 < jpeg.size(); ++i)
        if (jpeg[i] == 0xff && jpeg[i + 1] == 0xc4)
            for (std::size_t k = 5; k < 21; ++k) jpeg[i + k] = 0xff;
    EXPECT_NE(errorOf(jpeg), "");
}

TEST(ForeignImage, RefusesWhatIsCutOff) {
    for (const Bytes& whole : {jpegOf(3, JCS_RGB, false), jpegOf(3, JCS_RGB, true), pngOf(PNG_FORMAT_RGB, 3)})
        for (std::size_t length = 0; length < whole.size() * 9 / 10; length += 3)
            EXPECT_NE(errorOf(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(length))), "") << length;
}

TEST(ForeignImage, SurvivesDamage) {
    std::mt19937 dice(7);
    for (const Bytes& whole :
         {jpegOf(3, JCS_RGB, false), jpegOf(3, JCS_RGB, true), jpegOf(4, JCS_CMYK, false), pngOf(PNG_FORMAT_RGBA, 4)})
        for (int i = 0; i < 3000; ++i) {
            Bytes damaged = whole;
            for (int k = 0; k < 1 + i % 4; ++k) damaged[dice() % damaged.size()] = static_cast<std::uint8_t>(dice());
            errorOf(damaged, {512, std::size_t{4} << 20});  // an image or a message; never more than the limits
        }
}

TEST(ForeignImage, SaysWhatDecodingHasSpentAlsoWhereItFails) {
    for (std::vector<std::uint8_t> bytes : {pngOf(PNG_FORMAT_RGB, 3), jpegOf(3, JCS_RGB, false)}) {
        bytes.resize(bytes.size() - 30);  // its header is whole
        std::size_t spent = 0;
        ImageLimits limits;
        limits.spent = &spent;
        EXPECT_NE(errorOf(bytes, limits), "");
        EXPECT_EQ(spent, std::size_t{4} * width * height);
    }
}

TEST(ForeignImage, KeepsToItsLimits) {
    EXPECT_NE(errorOf(pngOf(PNG_FORMAT_RGB, 3), {36, 1 << 20}).find("37x21 pixels, the limit is 36"),
              std::string::npos);
    EXPECT_NE(errorOf(jpegOf(3, JCS_RGB, false), {8192, 4 * width * height - 1}).find("limit on bytes"),
              std::string::npos);
    EXPECT_EQ(errorOf(jpegOf(3, JCS_RGB, false), {8192, std::size_t{1} << 20}), "");
    EXPECT_NE(errorOf({'G', 'I', 'F'}), "");
    EXPECT_NE(errorOf({}), "");
}

}  // namespace

}  // namespace timeshade
