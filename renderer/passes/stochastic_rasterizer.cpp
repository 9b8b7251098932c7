#include "passes/stochastic_rasterizer.h"

#include <array>
#include <span>
#include <string>

#include "core/check.h"
#include "core/work_part.h"
#include "gl/pause_point.h"

namespace timeshade {

namespace {

gl::ShaderDefines definesFor(const ViewPlan& view, StochasticRasterizer::Role role,
                             StochasticRasterizer::Output output) {
    gl::ShaderDefines defines;
    if (role == StochasticRasterizer::Role::Light) defines.emplace_back("VIEW_LIGHT", "1");
    if (view.turns) defines.emplace_back("VIEW_TURNS", "1");
    if (view.projection == Projection::Orthographic) defines.emplace_back("VIEW_ORTHOGRAPHIC", "1");
    if (output == StochasticRasterizer::Output::TriangleId) defines.emplace_back("OUTPUT_ID", "1");
    if (output == StochasticRasterizer::Output::DepthRate) defines.emplace_back("OUTPUT_DEPTH_RATE", "1");
    if (output == StochasticRasterizer::Output::DepthVelocity) defines.emplace_back("OUTPUT_DEPTH_VELOCITY", "1");
    if (output == StochasticRasterizer::Output::Motion) defines.emplace_back("OUTPUT_MOTION", "1");
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

void copyLayer(const gl::Texture& from, int fromLayer, const gl::Texture& to, int toLayer) {
    glCopyImageSubData(from.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, fromLayer, to.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0,
                       toLayer, from.width(), from.height(), 1);
}

/// Takes a texture off a framebuffer, even where the work ends at a pause.
struct Detached {
    const gl::Framebuffer& target;
    bool attached;
    ~Detached() {
        if (attached) target.detach(GL_COLOR_ATTACHMENT1);
    }
};

}  // namespace

StochasticRasterizer::StochasticRasterizer(gl::ProgramCache& programs)
    : programs_(programs), target_("stochastic raster target"), none_("no attributes") {}

void StochasticRasterizer::upload(Uploaded& uploaded, const TriangleLists& lists) {
    uploadList(uploaded.small, "small triangles", lists.small);
    if (uploadList(uploaded.large, "large triangles", lists.large))
        uploaded.largeView = gl::Texture::ofBuffer("large triangles", GL_R32UI, *uploaded.large);
    uploaded.smallCount = lists.small.size();
    uploaded.largeCount = lists.large.size();
}

void StochasticRasterizer::draw(const GpuMesh& mesh, const ViewPlan& view,
                                std::initializer_list<const TriangleLists*> lists, Role role, Output output,
                                const Strata& strata, const gl::Texture* color, const gl::Texture& depth,
                                const Start* start, int firstRow) {
    uploaded_.resize(lists.size());
    for (std::size_t i = 0; i < lists.size(); ++i) upload(uploaded_[i], *lists.begin()[i]);
    gl::ShaderDefines defines = definesFor(view, role, output);
    if (mesh.hasCutouts()) defines.emplace_back("CUTOUTS", "1");
    if (start) defines.emplace_back("OUTPUT_DYNAMIC_PIXELS", "1");
    CHECK(strata.timePattern == 0 || role == Role::Light);
    if (strata.timePattern > 0) defines.emplace_back("TIME_PATTERN", std::to_string(strata.timePattern));
    const gl::Program& points =
        programs_.get({"stochastic points", "passes/stochastic_points.vert", "passes/stochastic.frag", defines});
    const gl::Program& rectangles = programs_.get(
        {"stochastic rectangles", "passes/stochastic_rectangles.vert", "passes/stochastic.frag", defines});
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glEnable(GL_PROGRAM_POINT_SIZE);
    target_.setColorCount(start ? 2 : color ? 1 : 0);
    const Detached afterwards{target_, start != nullptr};
    if (start) {
        const GLfloat nothing = 0.0f;
        glClearTexImage(start->dynamicPixels.name(), 0, GL_RED, GL_FLOAT, &nothing);
        target_.attach(GL_COLOR_ATTACHMENT1, start->dynamicPixels);
    }
    for (std::uint32_t stratum = 0; stratum < strata.count; ++stratum) {
        const WorkPart part = workPart(static_cast<int>(stratum), static_cast<int>(strata.count));
        const int layer = static_cast<int>(stratum), depthLayer = depth.layers() > 1 ? layer : 0;
        if (start) {
            copyLayer(start->color, layer, *color, layer);
            copyLayer(start->depth, layer, depth, depthLayer);
        }
        if (color) target_.attach(GL_COLOR_ATTACHMENT0, *color, layer);
        target_.attach(GL_DEPTH_ATTACHMENT, depth, depthLayer);
        target_.bindForDrawing(depth.width(), depth.height());
        glViewport(0, -firstRow, depth.width(), static_cast<GLsizei>(view.block.size.y));
        if (!start) clear(output, color != nullptr);
        for (const Uploaded& list : uploaded_) {
            gl::Inputs inputs;
            inputs.set("stratum", stratum).set("stratumLength", strata.length).set("firstRow", firstRow);
            if (list.smallCount > 0) {
                points.use(inputs);
                glVertexArrayElementBuffer(mesh.trianglesAsVertices().name(), list.small->name());
                glBindVertexArray(mesh.trianglesAsVertices().name());
                glDrawElements(GL_POINTS, static_cast<GLsizei>(list.smallCount), GL_UNSIGNED_INT, nullptr);
            }
            if (list.largeCount > 0) {
                rectangles.use(inputs);
                list.largeView->bind(LARGE_TRIANGLES_UNIT);
                glBindVertexArray(none_.name());
                glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(list.largeCount));
            }
        }
        gl::pausePoint();
    }
    glDisable(GL_DEPTH_TEST);
}

void StochasticRasterizer::clear(Output output, bool color) const {
    const float farthest = 0.0f;
    glClearNamedFramebufferfv(target_.name(), GL_DEPTH, 0, &farthest);
    if (output == Output::TriangleId) {
        const std::array<GLuint, 4> nothing{NO_TRIANGLE, 0, 0, 0};
        glClearNamedFramebufferuiv(target_.name(), GL_COLOR, 0, nothing.data());
    } else if (color) {
        const std::array<GLfloat, 4> zero{};
        glClearNamedFramebufferfv(target_.name(), GL_COLOR, 0, zero.data());
    }
}

std::size_t StochasticRasterizer::bytes() const {
    std::size_t sum = 0;
    for (const Uploaded& list : uploaded_)
        sum += (list.small ? list.small->bytes() : 0) + (list.large ? list.large->bytes() : 0);
    return sum;
}

}  // namespace timeshade
