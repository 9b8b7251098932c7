#pragma once

#include <string>

namespace timeshade {

// What goes to standard error beside the pictures. Where that is full or closed, what the program does and its exit
// code stay the same.

/// Prints "timeshade: TEXT" as one line. Control characters, and those that turn the direction of writing, become
/// spaces: names from files stand in such lines, and a terminal obeys what it is sent.
void tell(const std::string& text);

/// "timeshade: note: TEXT".
void tellNote(const std::string& text);

/// Writes the bytes as they are, for lines of progress on a terminal, and at once.
void writeToStandardError(const std::string& bytes);

}  // namespace timeshade
