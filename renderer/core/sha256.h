#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace timeshade {

using Sha256 = std::array<std::uint8_t, 32>;

/// FIPS 180-4. Names cached files and tells whole ones from damaged ones.
Sha256 sha256(std::span<const std::uint8_t> bytes);

/// 64 lower-case hexadecimal digits.
std::string toHex(const Sha256& hash);

}  // namespace timeshade
