#pragma once

#include <string>

#include <glad/gl.h>

namespace timeshade::gl {

/// Notes that a program has been linked and not used yet. Many drivers translate it only when it draws for the first
/// time, some again for another size of what they draw into or read.
void linked(GLuint program, const std::string& label);

/// Before the program in use draws or computes: announces that it is translated where this is its first use with a
/// viewport of about this size (core/pause.h).
void announceFirstUse();

}  // namespace timeshade::gl
