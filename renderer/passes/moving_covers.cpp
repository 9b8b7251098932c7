#include "passes/moving_covers.h"

#include <algorithm>
#include <array>
#include <span>

#include "gl/uploads.h"
#include "plan/view_triangle.h"

namespace timeshade {

namespace {

/// A square wastes what lies beside a long sweep; a rectangle costs four vertices.
constexpr float maxPointSide = 12.0f;
/// As many rectangles as one call draws: their vertices are numbered by 16 bits.
constexpr std::size_t rectanglesPerCall = 16384;

std::vector<std::uint16_t> rectangleIndices() {
    std::vector<std::uint16_t> indices;
    for (std::size_t rectangle = 0; rectangle < rectanglesPerCall; ++rectangle)
        for (const std::size_t corner : {0u, 1u, 2u, 2u, 1u, 3u})
            indices.push_back(static_cast<std::uint16_t>(4 * rectangle + corner));
    return indices;
}

void upload(gl::GrowingBuffer& buffer, const std::vector<std::uint32_t>& list) {
    buffer.reserve(std::max<std::size_t>(list.size(), 1), "a scene of fewer moving triangles is needed");
    gl::upload(buffer.buffer().name(), std::span<const std::uint32_t>(list));
}

}  // namespace

MovingCovers::MovingCovers()
    : smallTriangles_("small sweeps", GL_R32UI),
      largeTriangles_("large sweeps", GL_R32UI),
      indices_("rectangle indices", std::span<const std::uint16_t>(rectangleIndices())),
      rectangles_("rectangles"),
      points_("points") {
    glVertexArrayElementBuffer(rectangles_.name(), indices_.name());
}

void MovingCovers::set(const FramePlan& plan, const std::vector<std::uint32_t>& triangles) {
    orthographic_ = plan.light.projection == Projection::Orthographic;
    hasCutouts_ = plan.cutouts != nullptr;
    std::vector<std::uint32_t> small, large;
    for (const std::uint32_t id : triangles) {
        const shared::SweptBounds bounds =
            boundsOf(plan.light, viewTriangle(plan.light.block, plan.texels->positions, id));
        const glm::vec2 extent = (bounds.high - bounds.low) * plan.light.block.size;
        (bounds.crosses == 0u && std::max(extent.x, extent.y) <= maxPointSide ? small : large).push_back(id);
    }
    upload(smallTriangles_, small);
    upload(largeTriangles_, large);
    small_ = small.size();
    large_ = large.size();
}

void MovingCovers::draw(gl::ProgramCache& programs, const std::string& fragment, const gl::ShaderDefines& defines,
                        const gl::Inputs& inputs) const {
    gl::ShaderDefines all = defines;
    if (orthographic_) all.emplace_back("LIGHT_ORTHOGRAPHIC", "1");
    if (hasCutouts_) all.emplace_back("CUTOUTS", "1");
    glDisable(GL_BLEND);
    if (large_ > 0) {
        const gl::Program& program = programs.get({"moving rectangles", "passes/moving_cover.vert", fragment, all});
        program.use(gl::Inputs(inputs).texture("coverTriangles", largeTriangles_.texels()));
        glBindVertexArray(rectangles_.name());
        for (std::size_t first = 0; first < large_; first += rectanglesPerCall)
            glDrawElementsBaseVertex(GL_TRIANGLES,
                                     static_cast<GLsizei>(6 * std::min(rectanglesPerCall, large_ - first)),
                                     GL_UNSIGNED_SHORT, nullptr, static_cast<GLint>(4 * first));
    }
    if (small_ > 0) {
        all.emplace_back("COVER_POINTS", "1");
        const gl::Program& program = programs.get({"moving points", "passes/moving_cover.vert", fragment, all});
        program.use(gl::Inputs(inputs).texture("coverTriangles", smallTriangles_.texels()));
        glEnable(GL_PROGRAM_POINT_SIZE);
        glBindVertexArray(points_.name());
        glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(small_));
    }
}

}  // namespace timeshade
