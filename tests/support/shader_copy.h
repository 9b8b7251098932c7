#pragma once

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "gl/shader_source.h"

namespace timeshade {

/// One text of a shader file that becomes another.
struct ShaderEdit {
    std::string file, from, to;
};

/// A copy of the shaders that the program reads instead of the real ones, for as long as this lives.
class ShaderCopy {
  public:
    ShaderCopy()
        : original_(gl::shaderDirectory()),
          folder_(std::filesystem::temp_directory_path() / ("timeshade-shaders-" + std::to_string(::getpid()))) {
        using std::filesystem::copy_options;
        std::filesystem::copy(original_, folder_, copy_options::recursive | copy_options::overwrite_existing);
        ::setenv("TIMESHADE_SHADERS", folder_.c_str(), 1);
    }
    ~ShaderCopy() {
        ::setenv("TIMESHADE_SHADERS", original_.c_str(), 1);
        std::filesystem::remove_all(folder_);
    }
    ShaderCopy(const ShaderCopy&) = delete;
    ShaderCopy& operator=(const ShaderCopy&) = delete;

    void apply(const ShaderEdit& edit) const {
        std::stringstream text;
        text << std::ifstream(folder_ / edit.file).rdbuf();
        std::string changed = text.str();
        const std::size_t at = changed.find(edit.from);
        ASSERT_NE(at, std::string::npos) << edit.file << " holds no \"" << edit.from << '"';
        changed.replace(at, edit.from.size(), edit.to);
        std::ofstream(folder_ / edit.file) << changed;
    }

  private:
    std::filesystem::path original_, folder_;
};

}  // namespace timeshade
