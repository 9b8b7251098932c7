#include "image/foreign_image.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/error.h"
#include "image/decoders.h"

namespace timeshade {

namespace {

bool startsWith(std::span<const std::uint8_t> bytes, std::span<const std::uint8_t> beginning) {
    return bytes.size() >= beginning.size() && std::equal(beginning.begin(), beginning.end(), bytes.begin());
}

}  // namespace

void requireWithin(const ImageLimits& limits, long width, long height) {
    if (width < 1 || height < 1 || width > limits.side || height > limits.side)
        throw Error(fmt::format("{}x{} pixels, the limit is {} a side", width, height, limits.side));
    if (4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > limits.bytes)
        throw Error("the limit on bytes of images is used up");
    if (limits.spent != nullptr) *limits.spent = 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

ForeignImage decodeImage(std::span<const std::uint8_t> bytes, const ImageLimits& limits) {
    constexpr std::array<std::uint8_t, 4> png{0x89, 'P', 'N', 'G'};
    constexpr std::array<std::uint8_t, 3> jpeg{0xff, 0xd8, 0xff};
    if (startsWith(bytes, png)) return decodePng(bytes, limits);
    if (startsWith(bytes, jpeg)) return decodeJpeg(bytes, limits);
    throw Error("neither PNG nor JPEG");
}

}  // namespace timeshade
