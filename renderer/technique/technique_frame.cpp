#include "technique/technique_frame.h"

namespace timeshade {

gl::ShaderDefines viewDefines(const FramePlan& plan) {
    gl::ShaderDefines defines;
    if (plan.camera.turns) defines.emplace_back("CAMERA_TURNS", "1");
    if (plan.light.projection == Projection::Orthographic) defines.emplace_back("LIGHT_ORTHOGRAPHIC", "1");
    if (plan.cutouts) defines.emplace_back("CUTOUTS", "1");
    return defines;
}

gl::ShaderDefines TechniqueFrame::defines() const {
    gl::ShaderDefines defines = viewDefines(plan);
    defines.push_back(settings);
    return defines;
}

}  // namespace timeshade
