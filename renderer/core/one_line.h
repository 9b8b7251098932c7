#pragma once

#include <string>
#include <string_view>

namespace timeshade {

/// Makes untrusted text (names in files) fit for a message of one line: control characters, and those that turn the
/// direction of writing, become spaces, and text longer than `limit` bytes is cut, never inside a UTF-8 sequence, and
/// ends in "...".
std::string oneLine(std::string_view text, std::size_t limit = 60);

/// The last line of a text that is not only space, made fit in the same way.
std::string lastLine(std::string_view text, std::size_t limit);

}  // namespace timeshade
