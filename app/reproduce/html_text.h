#pragma once

#include <span>
#include <string>
#include <string_view>

namespace timeshade {

/// The text with what HTML takes for its own replaced, also for an attribute in double quotes.
std::string forHtml(std::string_view text);

/// Base 64 with padding (RFC 4648), for data: addresses.
std::string base64(std::span<const unsigned char> bytes);

}  // namespace timeshade
