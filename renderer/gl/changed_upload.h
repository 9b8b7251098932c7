#pragma once

#include <cstddef>
#include <span>

#include "gl/buffer.h"

namespace timeshade::gl {

/// Replaces those parts of the buffer that differ from `before`, which it holds, byte for byte: in runs of blocks of
/// 4 KiB. Both spans have the same size (checked). Returns how many bytes were uploaded.
std::size_t uploadChangedBytes(Buffer& buffer, std::span<const std::byte> now, std::span<const std::byte> before);

template <typename T>
std::size_t uploadChanged(Buffer& buffer, std::span<const T> now, std::span<const T> before) {
    return uploadChangedBytes(buffer, std::as_bytes(now), std::as_bytes(before));
}

}  // namespace timeshade::gl
