#include "passes/shadow_map.h"

namespace timeshade {

void ShadowMap::draw(const FramePlan& plan, const GpuMesh& mesh, float instant, const glm::mat3& mapFromPlane) {
    const int size = plan.request.mapSize;
    if (!depth_ || depth_->width() != size) {
        depth_ = gl::Texture::array2D("shadow map", GL_DEPTH_COMPONENT32F, size, size, 1);
        target_.emplace("shadow map target");
        target_->setColorCount(keepsTriangles_ ? 1 : 0);
        target_->attach(GL_DEPTH_ATTACHMENT, *depth_);
        if (keepsTriangles_) {
            triangles_ = gl::Texture::array2D("triangles of the shadow map", GL_R32UI, size, size, 1);
            target_->attach(GL_COLOR_ATTACHMENT0, *triangles_);
        }
    }
    gl::ShaderDefines defines;
    if (plan.light.projection == Projection::Orthographic) defines.emplace_back("LIGHT_ORTHOGRAPHIC", "1");
    const gl::Program& program = programs_.get({"shadow map", "passes/shadow_map.vert", keepsTriangles_ ? "passes/triangle_number.frag" : "passes/depth_only.frag", defines});
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    target_->bindForDrawing(size, size);
    const float farthest = 0.0f;
    glClearNamedFramebufferfv(target_->name(), GL_DEPTH, 0, &farthest);
    const GLuint none[4] = {NO_TRIANGLE, 0, 0, 0};
    if (keepsTriangles_) glClearNamedFramebufferuiv(target_->name(), GL_COLOR, 0, none);
    program.use();
    glUniform1f(0, instant);
    glUniformMatrix3fv(1, 1, GL_FALSE, &mapFromPlane[0][0]);
    glBindVertexArray(mesh.vertices().name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * mesh.triangleCount()), GL_UNSIGNED_INT, nullptr);
    glDisable(GL_DEPTH_TEST);
}

} // namespace timeshade
