#include "passes/shadow_map.h"

namespace timeshade {

namespace {

/// Triangles in a row are drawn by one call's entry: the mesh's own index buffer serves, whatever is left out.
struct Runs {
    std::vector<GLsizei> counts;
    std::vector<const void*> offsets;
    std::vector<GLint> firsts;  ///< the same as numbers of vertices, three a triangle
};

Runs runsOf(const std::vector<std::uint32_t>& triangles) {
    Runs runs;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i == 0 || triangles[i] != triangles[i - 1] + 1) {
            runs.counts.push_back(0);
            runs.offsets.push_back(
                reinterpret_cast<const void*>(std::size_t{triangles[i]} * 3 * sizeof(std::uint32_t)));
            runs.firsts.push_back(static_cast<GLint>(3 * triangles[i]));
        }
        runs.counts.back() += 3;
    }
    return runs;
}

/// `none`: a vertex array without attributes. What is cut out needs to know its triangle, so its vertices are not
/// shared.
void drawRuns(const FramePlan& plan, const GpuMesh& mesh, const gl::VertexArray& none, const Runs& runs) {
    const auto count = static_cast<GLsizei>(runs.counts.size());
    glBindVertexArray(plan.cutouts ? none.name() : mesh.vertices().name());
    if (count > 0 && plan.cutouts)
        glMultiDrawArrays(GL_TRIANGLES, runs.firsts.data(), runs.counts.data(), count);
    else if (count > 0)
        glMultiDrawElements(GL_TRIANGLES, runs.counts.data(), GL_UNSIGNED_INT, runs.offsets.data(), count);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace

void ShadowMap::begin(const FramePlan& plan, float instant, const glm::mat3& mapFromPlane) {
    const MapSize size = plan.request.mapSize;
    if (!depth_ || MapSize(depth_->width(), depth_->height()) != size) {
        depth_ = gl::Texture::array2D("shadow map", GL_DEPTH_COMPONENT32F, size.width, size.height, 1);
        target_.emplace("shadow map target");
        target_->setColorCount(keepsTriangles_ ? 1 : 0);
        target_->attach(GL_DEPTH_ATTACHMENT, *depth_);
        if (keepsTriangles_) {
            triangles_ = gl::Texture::array2D("triangles of the shadow map", GL_R32UI, size.width, size.height, 1);
            target_->attach(GL_COLOR_ATTACHMENT0, *triangles_);
        }
    }
    gl::ShaderDefines defines;
    if (plan.light.projection == Projection::Orthographic) defines.emplace_back("LIGHT_ORTHOGRAPHIC", "1");
    const std::string plain = keepsTriangles_ ? "passes/triangle_number.frag" : "passes/depth_only.frag";
    if (plan.cutouts) defines.emplace_back("CUTOUTS", "1");
    if (plan.cutouts && keepsTriangles_) defines.emplace_back("OUTPUT_TRIANGLE", "1");
    const gl::Program& program =
        programs_.get({"shadow map", "passes/shadow_map.vert",
                       plan.cutouts ? std::string("passes/shadow_map_cutouts.frag") : plain, defines});
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    target_->bindForDrawing(size.width, size.height);
    program.use(gl::Inputs().set("instant", instant).set("mapFromPlane", mapFromPlane));
}

void ShadowMap::clear() const {
    const float farthest = 0.0f;
    glClearNamedFramebufferfv(target_->name(), GL_DEPTH, 0, &farthest);
    const GLuint none[4] = {NO_TRIANGLE, 0, 0, 0};
    if (keepsTriangles_) glClearNamedFramebufferuiv(target_->name(), GL_COLOR, 0, none);
}

void ShadowMap::draw(const FramePlan& plan, const GpuMesh& mesh, float instant, const glm::mat3& mapFromPlane) {
    begin(plan, instant, mapFromPlane);
    clear();
    drawRuns(plan, mesh, none_, {{static_cast<GLsizei>(3 * mesh.triangleCount())}, {nullptr}, {0}});
}

void ShadowMap::draw(const FramePlan& plan, const GpuMesh& mesh, float instant,
                     const std::vector<std::uint32_t>& triangles) {
    begin(plan, instant, glm::mat3(1.0f));
    clear();
    drawRuns(plan, mesh, none_, runsOf(triangles));
}

void ShadowMap::drawOnto(const ShadowMap& start, const FramePlan& plan, const GpuMesh& mesh, float instant,
                         const std::vector<std::uint32_t>& triangles) {
    begin(plan, instant, glm::mat3(1.0f));
    glCopyImageSubData(start.depth().name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, depth_->name(), GL_TEXTURE_2D_ARRAY, 0, 0,
                       0, 0, depth_->width(), depth_->height(), 1);
    drawRuns(plan, mesh, none_, runsOf(triangles));
}

}  // namespace timeshade
