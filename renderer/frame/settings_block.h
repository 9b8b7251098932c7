#pragma once

#include <optional>
#include <string>
#include <utility>

#include "gl/buffer.h"
#include "technique/technique.h"

namespace timeshade {

/// A technique's settings as its shaders read them: one uniform block with a member for each, named by its key, in the
/// order of their declaration (lib/settings.glsl). Numbers are floats or ints, switches are bools.
class SettingsBlock {
  public:
    /// Uploads the values of now.
    void set(Technique& technique);
    void bind() const;
    /// The members, as the define that lib/settings.glsl wants.
    const std::pair<std::string, std::string>& define() const { return define_; }
    /// Stands for the technique and the values of its settings.
    CacheKey key() const { return key_; }

  private:
    std::optional<gl::Buffer> buffer_;
    std::pair<std::string, std::string> define_{"TECHNIQUE_SETTINGS", "float none;"};
    CacheKey key_ = 0;
};

}  // namespace timeshade
