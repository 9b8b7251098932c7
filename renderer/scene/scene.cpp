#include "scene/scene.h"

#include <fmt/format.h>

namespace timeshade {

std::string Scene::contentDigest() const {
    std::string text = name();
    for (const SceneParameter& parameter : parameters()) text += fmt::format(" {}={}", parameter.key, parameter.value);
    return text;
}

}  // namespace timeshade
