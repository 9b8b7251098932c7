#pragma once

#include <filesystem>
#include <string>

#include "image/image_file.h"

namespace timeshade {

/// Where `shot` writes: files, one a frame, or, for "-", the standard output. Where that is the picture's, all else
/// goes to standard error.
class ShotOutput {
  public:
    /// Throws Error where it can't be written to, or would be sent to a terminal.
    ShotOutput(const std::string& output, int frames);

    std::filesystem::path path(int frame) const;
    void write(const std::filesystem::path& path, const DisplayImage& picture) const;
    /// A line or more of text, ended by a new line each.
    void say(const std::string& text) const;

  private:
    bool isStandardOutput() const { return output_ == "-"; }

    std::string output_;
    int frames_;
};

}  // namespace timeshade
