#pragma once

#include <string>
#include <string_view>

namespace timeshade {

/// The text as it may stand in a message of one line: control characters become spaces, and what is longer than
/// `limit` bytes is cut (never within a UTF-8 sequence) and ends in "...". Names in files are untrusted.
std::string oneLine(std::string_view text, std::size_t limit = 60);

}  // namespace timeshade
