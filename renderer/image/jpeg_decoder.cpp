#include "image/decoders.h"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstring>

#include <jpeglib.h>  // after <cstdio>, which it needs

#include <jerror.h>  // after <jpeglib.h>

#include <fmt/format.h>

#include "core/error.h"
#include "core/one_line.h"

namespace timeshade {

namespace {

/// A picture that is refined more often than this is made to keep a decoder busy.
constexpr int mostScans = 100;

/// libjpeg's error manager, and where its errors lead. Nothing in it needs a destructor.
struct ErrorManager {
    jpeg_error_mgr base;  ///< first: libjpeg knows this part alone
    std::jmp_buf back;
    char message[JMSG_LENGTH_MAX];
};

ErrorManager* managerOf(j_common_ptr common) { return reinterpret_cast<ErrorManager*>(common->err); }

[[noreturn]] void onError(j_common_ptr common) {
    ErrorManager* manager = managerOf(common);
    manager->base.format_message(common, manager->message);
    std::longjmp(manager->back, 1);
}

/// Negative levels are warnings. Those about pixels that are not in the file are errors here; those about bytes too
/// many or odd headers are not, as many files have them.
void onMessage(j_common_ptr common, int level) {
    const int code = common->err->msg_code;
    const bool invented =
        code == JWRN_HIT_MARKER || code == JWRN_JPEG_EOF || code == JWRN_HUFF_BAD_CODE || code == JWRN_ARITH_BAD_CODE;
    if (level < 0 && invented) onError(common);
}

void onOutput(j_common_ptr) {}

void onProgress(j_common_ptr common) {
    const auto* decoder = reinterpret_cast<const jpeg_decompress_struct*>(common);
    if (decoder->input_scan_number <= mostScans) return;
    ErrorManager* manager = managerOf(common);
    std::strcpy(manager->message, "too many scans");
    std::longjmp(manager->back, 1);
}

bool readHeader(jpeg_decompress_struct& decoder, ErrorManager& manager, std::span<const std::uint8_t> bytes) {
    if (setjmp(manager.back) != 0) return false;
    jpeg_mem_src(&decoder, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&decoder, TRUE);
    const bool inks = decoder.jpeg_color_space == JCS_CMYK || decoder.jpeg_color_space == JCS_YCCK;
    decoder.out_color_space = inks ? JCS_CMYK : JCS_EXT_RGBA;
    return true;
}

bool readRows(jpeg_decompress_struct& decoder, ErrorManager& manager, std::uint8_t* rgba) {
    if (setjmp(manager.back) != 0) return false;
    jpeg_start_decompress(&decoder);
    while (decoder.output_scanline < decoder.output_height) {
        JSAMPROW row = rgba + std::size_t{4} * decoder.output_width * decoder.output_scanline;
        jpeg_read_scanlines(&decoder, &row, 1);
    }
    jpeg_finish_decompress(&decoder);
    return true;
}

/// Inks as Adobe stores them, the other way round: 255 is none.
void convertInks(std::vector<std::uint8_t>& pixels) {
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        const int black = pixels[i + 3];
        for (std::size_t c = 0; c < 3; ++c) pixels[i + c] = static_cast<std::uint8_t>(pixels[i + c] * black / 255);
        pixels[i + 3] = 255;
    }
}

/// Owns what libjpeg allocates.
class Decoder {
  public:
    explicit Decoder(const ImageLimits& limits) {
        state.err = jpeg_std_error(&manager.base);
        manager.base.error_exit = &onError;
        manager.base.emit_message = &onMessage;
        manager.base.output_message = &onOutput;
        jpeg_create_decompress(&state);
        progress.progress_monitor = &onProgress;
        state.progress = &progress;
        state.mem->max_memory_to_use = static_cast<long>(limits.bytes);
    }
    ~Decoder() { jpeg_destroy_decompress(&state); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    jpeg_decompress_struct state{};
    ErrorManager manager{};

  private:
    jpeg_progress_mgr progress{};
};

}  // namespace

ForeignImage decodeJpeg(std::span<const std::uint8_t> bytes, const ImageLimits& limits) {
    Decoder decoder(limits);
    if (!readHeader(decoder.state, decoder.manager, bytes)) throw Error(oneLine(decoder.manager.message, 80));
    const std::size_t width = decoder.state.image_width, height = decoder.state.image_height;
    requireWithin(limits, static_cast<long>(width), static_cast<long>(height));
    // A block of 8 x 8 pixels takes two bits at least; a refined one none, but then its first scan had them.
    if (width * height / 64 / 4 / 8 > bytes.size())
        throw Error(fmt::format("{} bytes cannot hold {}x{} pixels", bytes.size(), width, height));
    ForeignImage image{static_cast<int>(width), static_cast<int>(height),
                       std::vector<std::uint8_t>(4 * width * height)};
    if (!readRows(decoder.state, decoder.manager, image.rgba.data())) throw Error(oneLine(decoder.manager.message, 80));
    if (decoder.state.out_color_space == JCS_CMYK) convertInks(image.rgba);
    return image;
}

}  // namespace timeshade
