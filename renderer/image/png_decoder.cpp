#include "image/decoders.h"

#include <algorithm>
#include <csetjmp>
#include <cstring>

#include <fmt/format.h>
#include <png.h>

#include "core/error.h"
#include "core/one_line.h"

namespace timeshade {

namespace {

/// What is read, and the first complaint. Nothing in it needs a destructor.
struct Source {
    const std::uint8_t* at = nullptr;
    std::size_t left = 0;
    char message[128] = "damaged";
};

void read(png_structp png, png_bytep out, png_size_t count) {
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (source->left < count) png_error(png, "cut off");
    std::memcpy(out, source->at, count);
    source->at += count;
    source->left -= count;
}

[[noreturn]] void onError(png_structp png, png_const_charp text) {
    auto* source = static_cast<Source*>(png_get_error_ptr(png));
    std::strncpy(source->message, text, sizeof source->message - 1);
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

bool readHeader(png_structp png, png_infop info) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_read_info(png, info);
    return true;
}

/// `rows` has as many pointers as the picture has rows.
bool readRows(png_structp png, png_infop info, png_bytepp rows) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_expand(png);    // palettes, few bits, transparent colours
    png_set_strip_16(png);  // not rounded: the upper byte, as ever
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    if (png_get_rowbytes(png, info) != 4 * std::size_t{png_get_image_width(png, info)})
        png_error(png, "pixels of an unknown kind");
    png_read_image(png, rows);
    return true;
}

/// Owns libpng's two structures.
class Reader {
  public:
    Reader(Source& source, const ImageLimits& limits)
        : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, &onError, &onWarning)) {
        if (png_ == nullptr) throw Error("libpng cannot be started");
        info_ = png_create_info_struct(png_);
        png_set_read_fn(png_, &source, &read);
        png_set_user_limits(png_, 0x7fffffff, 0x7fffffff);  // requireWithin() says which side is too long
        png_set_chunk_malloc_max(png_, std::min<std::size_t>(limits.bytes, 8 << 20));
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    }
    ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    png_structp png() const { return png_; }
    png_infop info() const { return info_; }

  private:
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

/// What the header says, before anything is allocated for it: it has a fixed place.
void checkSize(std::span<const std::uint8_t> bytes, const ImageLimits& limits) {
    if (bytes.size() < 24) throw Error("cut off");
    const auto number = [&](std::size_t at) {
        return std::size_t{bytes[at]} << 24 | std::size_t{bytes[at + 1]} << 16 | std::size_t{bytes[at + 2]} << 8 |
               std::size_t{bytes[at + 3]};
    };
    const std::size_t width = number(16), height = number(20);
    requireWithin(limits, static_cast<long>(width), static_cast<long>(height));
    // Deflate compresses no better than about 1000 : 1, and a pixel may have a single bit: a larger size cannot be
    // true.
    if (width * height / 8 / 1100 > bytes.size())
        throw Error(fmt::format("{} bytes cannot hold {}x{} pixels", bytes.size(), width, height));
}

}  // namespace

ForeignImage decodePng(std::span<const std::uint8_t> bytes, const ImageLimits& limits) {
    checkSize(bytes, limits);
    Source source{bytes.data(), bytes.size()};
    const Reader reader(source, limits);
    if (!readHeader(reader.png(), reader.info())) throw Error(oneLine(source.message, 80));
    const auto width = static_cast<std::size_t>(png_get_image_width(reader.png(), reader.info()));
    const auto height = static_cast<std::size_t>(png_get_image_height(reader.png(), reader.info()));
    ForeignImage image{static_cast<int>(width), static_cast<int>(height),
                       std::vector<std::uint8_t>(4 * width * height)};
    std::vector<png_bytep> rows(height);
    for (std::size_t y = 0; y < height; ++y) rows[y] = image.rgba.data() + 4 * width * y;
    if (!readRows(reader.png(), reader.info(), rows.data())) throw Error(oneLine(source.message, 80));
    return image;
}

}  // namespace timeshade
