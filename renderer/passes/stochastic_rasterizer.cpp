#include "passes/stochastic_rasterizer.h"

#include <array>
#include <span>

namespace timeshade {

namespace {

gl::ShaderDefines definesFor(const ViewPlan& view, StochasticRasterizer::Role role, StochasticRasterizer::Output output) {
    gl::ShaderDefines defines;
    if (role == StochasticRasterizer::Role::Light) defines.emplace_back("VIEW_LIGHT", "1");
    if (view.turns) defines.emplace_back("VIEW_TURNS", "1");
    if (view.projection == Projection::Orthographic) defines.emplace_back("VIEW_ORTHOGRAPHIC", "1");
    if (output == StochasticRasterizer::Output::TriangleId) defines.emplace_back("OUTPUT_ID", "1");
    if (output == StochasticRasterizer::Output::DepthVelocity) defines.emplace_back("OUTPUT_DEPTH_VELOCITY", "1");
    return defines;
}

/// Keeps the buffer while the list fits; grows by half again, since lists change a little every frame. True when the
/// buffer is another one than before: its name does not tell, since drivers give freed names out again.
bool uploadList(std::optional<gl::Buffer>& buffer, const char* label, const std::vector<std::uint32_t>& list) {
    const std::size_t bytes = list.size() * sizeof(std::uint32_t);
    const bool renewed = !buffer || buffer->bytes() < bytes;
    if (renewed) buffer.emplace(label, bytes + bytes / 2);
    buffer->upload(std::span<const std::uint32_t>(list));
    return renewed;
}

} // namespace

StochasticRasterizer::StochasticRasterizer(gl::ProgramCache& programs)
    : programs_(programs), target_("stochastic raster target"), none_("no attributes") {}

void StochasticRasterizer::uploadLists(const ViewPlan& view) {
    uploadList(small_, "small triangles", view.smallTriangles);
    if (uploadList(large_, "large triangles", view.largeTriangles))
        largeView_ = gl::Texture::ofBuffer("large triangles", GL_R32UI, *large_);
}

void StochasticRasterizer::draw(const GpuMesh& mesh, const ViewPlan& view, Role role, Output output, std::uint32_t strata,
                                const gl::Texture* color, const gl::Texture& depth) {
    uploadLists(view);
    const gl::ShaderDefines defines = definesFor(view, role, output);
    const gl::Program& points =
        programs_.get({"stochastic points", "passes/stochastic_points.vert", "passes/stochastic.frag", defines});
    const gl::Program& rectangles =
        programs_.get({"stochastic rectangles", "passes/stochastic_rectangles.vert", "passes/stochastic.frag", defines});

    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glEnable(GL_PROGRAM_POINT_SIZE);
    largeView_->bind(LARGE_TRIANGLES_UNIT);
    glVertexArrayElementBuffer(mesh.trianglesAsVertices().name(), small_->name());
    target_.setColorCount(color ? 1 : 0);
    for (std::uint32_t stratum = 0; stratum < strata; ++stratum) {
        const int layer = static_cast<int>(stratum);
        if (color) target_.attach(GL_COLOR_ATTACHMENT0, *color, layer);
        target_.attach(GL_DEPTH_ATTACHMENT, depth, depth.layers() > 1 ? layer : 0);
        target_.bindForDrawing(depth.width(), depth.height());
        const float farthest = 0.0f;
        glClearNamedFramebufferfv(target_.name(), GL_DEPTH, 0, &farthest);
        if (output == Output::TriangleId) {
            const std::array<GLuint, 4> nothing{NO_TRIANGLE, 0, 0, 0};
            glClearNamedFramebufferuiv(target_.name(), GL_COLOR, 0, nothing.data());
        } else if (color) {
            const std::array<GLfloat, 4> zero{};
            glClearNamedFramebufferfv(target_.name(), GL_COLOR, 0, zero.data());
        }
        if (!view.smallTriangles.empty()) {
            points.use();
            glUniform1ui(0, stratum);
            glBindVertexArray(mesh.trianglesAsVertices().name());
            glDrawElements(GL_POINTS, static_cast<GLsizei>(view.smallTriangles.size()), GL_UNSIGNED_INT, nullptr);
        }
        if (!view.largeTriangles.empty()) {
            rectangles.use();
            glUniform1ui(0, stratum);
            glBindVertexArray(none_.name());
            glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(view.largeTriangles.size()));
        }
    }
    glDisable(GL_DEPTH_TEST);
}

std::size_t StochasticRasterizer::bytes() const { return (small_ ? small_->bytes() : 0) + (large_ ? large_->bytes() : 0); }

} // namespace timeshade
