#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glad/gl.h>

namespace timeshade::gl {

/// Replaces a part of a buffer, from byte `from` on. Everything large that a frame hands to the device goes through
/// here and is counted.
void uploadBytes(GLuint buffer, std::size_t from, std::span<const std::byte> data);

template <typename T>
void upload(GLuint buffer, std::span<const T> data) {
    uploadBytes(buffer, 0, std::as_bytes(data));
}

/// How many bytes that have been, to all contexts of this process.
std::uint64_t bytesUploadedSoFar();

}  // namespace timeshade::gl
