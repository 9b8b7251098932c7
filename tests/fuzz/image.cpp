// Images of models: PNG and JPEG.
#include <cstdint>
#include <span>

#include "image/foreign_image.h"
#include "read_or_refused.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    timeshade::fuzz::readOrRefused(
        [&] { timeshade::decodeImage(std::span(data, size), {.side = 1024, .bytes = std::size_t{8} << 20}); });
    return 0;
}
