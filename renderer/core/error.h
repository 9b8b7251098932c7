#pragma once

#include <stdexcept>
#include <string>

namespace timeshade {

/// Something outside the program is wrong: a file, an argument, a shader, a driver.
/// The message is one line that names the file or option, the value found and what was expected;
/// the command line prints it after "timeshade: error: " and exits with 1.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The command line itself is wrong (unknown scene, value out of range): exit code 2.
class UsageError : public Error {
  public:
    using Error::Error;
};

/// A frame needs more than the device gives: a buffer, a texture, memory. The message names the limit and what to
/// lower; smaller frames go on working.
class LimitError : public Error {
  public:
    using Error::Error;
};

}  // namespace timeshade
