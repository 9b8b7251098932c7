#include "passes/still_map.h"

namespace timeshade {

namespace {

/// Triangles in a row are drawn by one call's entry: the mesh's own index buffer serves, whatever is left out.
struct Runs {
    std::vector<GLsizei> counts;
    std::vector<const void*> offsets;
};

Runs runsOf(const std::vector<std::uint32_t>& triangles) {
    Runs runs;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i == 0 || triangles[i] != triangles[i - 1] + 1) {
            runs.counts.push_back(0);
            runs.offsets.push_back(reinterpret_cast<const void*>(std::size_t{triangles[i]} * 3 * sizeof(std::uint32_t)));
        }
        runs.counts.back() += 3;
    }
    return runs;
}

} // namespace

void StillMap::draw(const FramePlan& plan, const GpuMesh& mesh, const std::vector<std::uint32_t>& triangles) {
    const int size = plan.request.mapSize;
    if (!depth_ || depth_->width() != size) {
        depth_ = gl::Texture::array2D("still map", GL_DEPTH_COMPONENT32F, size, size, 1);
        target_.emplace("still map target");
        target_->setColorCount(0);
        target_->attach(GL_DEPTH_ATTACHMENT, *depth_);
    }
    gl::ShaderDefines defines;
    if (plan.light.projection == Projection::Orthographic) defines.emplace_back("LIGHT_ORTHOGRAPHIC", "1");
    const gl::Program& program = programs_.get({"shadow map", "passes/shadow_map.vert", "passes/depth_only.frag", defines});
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    target_->bindForDrawing(size, size);
    const float farthest = 0.0f;
    glClearNamedFramebufferfv(target_->name(), GL_DEPTH, 0, &farthest);
    program.use();
    glUniform1f(0, 0.0f);
    const glm::mat3 asItIs(1.0f);
    glUniformMatrix3fv(1, 1, GL_FALSE, &asItIs[0][0]);
    const Runs runs = runsOf(triangles);
    glBindVertexArray(mesh.vertices().name());
    if (!triangles.empty())
        glMultiDrawElements(GL_TRIANGLES, runs.counts.data(), GL_UNSIGNED_INT, runs.offsets.data(), static_cast<GLsizei>(runs.counts.size()));
    glDisable(GL_DEPTH_TEST);
}

} // namespace timeshade
