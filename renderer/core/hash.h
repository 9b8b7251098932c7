#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace timeshade {

/// A number of 64 bits that stands for a sequence of values: equal sequences give equal numbers, others almost never.
/// Not for files or for anyone who means harm (core/sha256.h).
class Hash {
  public:
    Hash& add(std::uint64_t value) {
        state_ = (state_ ^ value) * 0x9e3779b97f4a7c15ull;
        state_ ^= state_ >> 29;
        return *this;
    }
    Hash& add(std::string_view text) {
        for (const char letter : text) add(std::uint64_t{static_cast<unsigned char>(letter)});
        return add(std::uint64_t{text.size()});
    }
    Hash& add(std::span<const std::uint32_t> values) {
        for (const std::uint32_t value : values) add(std::uint64_t{value});
        return add(std::uint64_t{values.size()});
    }
    std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0x51afd7ed558ccdull;
};

}  // namespace timeshade
