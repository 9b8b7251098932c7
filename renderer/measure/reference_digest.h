#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/sha256.h"

namespace timeshade {

/// Collects bytes and names them by their hash: what keys of the reference cache are made of.
class ReferenceDigest {
  public:
    void bytes(const void* data, std::size_t count) {
        const auto* byte = static_cast<const std::uint8_t*>(data);
        bytes_.insert(bytes_.end(), byte, byte + count);
    }
    template <typename T>
    void value(const T& value) {
        bytes(&value, sizeof value);
    }
    template <typename T>
    void values(const std::vector<T>& vector) {
        bytes(vector.data(), vector.size() * sizeof(T));
    }
    std::string text() const { return toHex(sha256(bytes_)); }

  private:
    std::vector<std::uint8_t> bytes_;
};

}  // namespace timeshade
