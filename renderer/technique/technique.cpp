#include "technique/technique.h"

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

void Technique::drawView(const TechniqueFrame&, const std::string& name, const gl::Texture&) {
    throw Error(fmt::format("technique {} has no view '{}'", description().name, name));
}

gl::ShaderDefines viewDefines(const FramePlan& plan) {
    gl::ShaderDefines defines;
    if (plan.camera.turns) defines.emplace_back("CAMERA_TURNS", "1");
    if (plan.light.projection == Projection::Orthographic) defines.emplace_back("LIGHT_ORTHOGRAPHIC", "1");
    return defines;
}

}  // namespace timeshade
