#include "standard_error.h"

#include <cstdio>

#include "core/one_line.h"

namespace timeshade {

void tell(const std::string& text) { writeToStandardError("timeshade: " + oneLine(text, text.size()) + "\n"); }

void tellNote(const std::string& text) { tell("note: " + text); }

void writeToStandardError(const std::string& bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), stderr);  // its result is nobody's: there is no one left to tell
    std::fflush(stderr);
}

}  // namespace timeshade
