#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

#include "gl/texture.h"

namespace timeshade::gl {

/// What a program reads, by the names that its shaders give them. The textures must outlive it.
class Inputs {
  public:
    using Value = std::variant<float, std::int32_t, std::uint32_t, glm::vec3, glm::mat3>;

    Inputs& set(std::string name, Value value) {
        values_.emplace_back(std::move(name), value);
        return *this;
    }
    /// A sampler, or an image that is read and written with the texture's own format, all layers.
    Inputs& texture(std::string name, const Texture& texture) {
        textures_.emplace_back(std::move(name), &texture);
        return *this;
    }

    const std::vector<std::pair<std::string, Value>>& values() const { return values_; }
    const std::vector<std::pair<std::string, const Texture*>>& textures() const { return textures_; }

  private:
    std::vector<std::pair<std::string, Value>> values_;
    std::vector<std::pair<std::string, const Texture*>> textures_;
};

}  // namespace timeshade::gl
