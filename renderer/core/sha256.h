#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace timeshade {

using Sha256 = std::array<std::uint8_t, 32>;

/// SHA-256 (FIPS 180-4). Cached files are named by it, and it detects damaged ones.
Sha256 sha256(std::span<const std::uint8_t> bytes);

/// 64 lower-case hexadecimal digits.
std::string toHex(const Sha256& hash);

}  // namespace timeshade
