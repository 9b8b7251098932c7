#pragma once

#include <map>
#include <optional>
#include <string>

#include "gl/texture.h"

namespace timeshade {

/// The pictures of the technique pages, renderer/techniques/NAME/page.png, read when they are first asked for.
class PagePictures {
  public:
    /// Its first row is the uppermost. Null where there is none that can be read.
    const gl::Texture* of(const std::string& technique);

  private:
    std::map<std::string, std::optional<gl::Texture>> pictures_;
};

}  // namespace timeshade
