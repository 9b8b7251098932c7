#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace timeshade {

/// An image from a file that anyone may have made: 4 channels of eight bits, as stored, rows from top to bottom.
struct ForeignImage {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// What decoding may cost at most.
struct ImageLimits {
    int side = 8192;                           ///< pixels
    std::size_t bytes = std::size_t{1} << 30;  ///< of decoded pixels, and of what the decoder keeps besides
    std::size_t* spent = nullptr;              ///< where given, set to the bytes of pixels once their decoding begins
};

/// Decodes a PNG or a JPEG (libpng, libjpeg-turbo). Sixteen-bit channels keep their upper byte; gamma and colour
/// profiles are ignored, as glTF wants it. The header is checked against the limits before anything is allocated.
/// Throws Error with the reason, without a file's name: anything else, damage, cut-off data, more than the limits.
/// A JPEG that is cut off throws as well.
ForeignImage decodeImage(std::span<const std::uint8_t> bytes, const ImageLimits& limits);

}  // namespace timeshade
