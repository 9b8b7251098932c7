#pragma once

#include "image/foreign_image.h"

namespace timeshade {

// The two formats of decodeImage(), which says what they guarantee. Both libraries report errors by longjmp: the
// functions that call them hold nothing that would have to be destroyed.

ForeignImage decodePng(std::span<const std::uint8_t> bytes, const ImageLimits& limits);
ForeignImage decodeJpeg(std::span<const std::uint8_t> bytes, const ImageLimits& limits);

/// Throws Error where a picture of that size is beyond the limits, and else counts it as spent.
void requireWithin(const ImageLimits& limits, long width, long height);

}  // namespace timeshade
