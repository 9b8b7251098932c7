#pragma once

#include <stdexcept>
#include <string>

namespace timeshade {

/// Something outside the program is wrong: a file, an argument, a shader, a driver. The message is one line that names
/// the file or option, the value found and what was expected. The command line prints it after "timeshade: error: " and
/// exits with 1. Mistakes of the program itself are checks (core/check.h).
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The command line itself is wrong (unknown scene, value out of range): exit code 2.
class UsageError : public Error {
  public:
    using Error::Error;
};

/// A frame needs more than the device offers: a larger buffer or texture, or more memory. The message names the limit
/// and which setting to lower. The renderer stays usable for smaller frames.
class LimitError : public Error {
  public:
    using Error::Error;
};

}  // namespace timeshade
