#include "techniques/history/dynamic_mask.h"

#include <algorithm>

namespace timeshade {

namespace {

/// The 18 floats of a triangle's positions: nine at the shutter's opening, nine at its closing.
constexpr std::size_t positionFloats = 18;

}  // namespace

std::vector<std::uint32_t> dynamicCastersBetween(const MeshTexels& before, const MeshTexels& now) {
    std::vector<std::uint32_t> dynamicCasters;
    const std::size_t count = now.positions.size() / TRIANGLE_POSITION_TEXELS;
    for (std::size_t i = 0; i < count; ++i) {
        const float* a = &before.positions[i * TRIANGLE_POSITION_TEXELS].x;
        const float* b = &now.positions[i * TRIANGLE_POSITION_TEXELS].x;
        const bool still =
            std::equal(b, b + positionFloats, a) && std::equal(b, b + positionFloats / 2, b + positionFloats / 2);
        if (!still) dynamicCasters.push_back(static_cast<std::uint32_t>(i));
    }
    return dynamicCasters;
}

void DynamicMask::draw(const TechniqueFrame& frame, const gl::Texture& previousPositions,
                       std::span<const std::uint32_t> dynamicCasters) {
    const FramePlan& plan = frame.plan;
    const int size = sideFor(plan.request.mapSize.longerSide());
    if (!depth_ || depth_->width() != size) {
        depth_ = gl::Texture::array2D("mask of dynamic casters", GL_DEPTH_COMPONENT32F, size, size, 1);
        target_.emplace("mask of dynamic casters target");
        target_->setColorCount(0);
        target_->attach(GL_DEPTH_ATTACHMENT, *depth_);
    }
    const std::size_t triangles = plan.mesh->topology->triangles.size();
    if (!flags_ || flags_->bytes() != triangles) {
        list_.emplace("dynamic casters", triangles * sizeof(std::uint32_t));
        listView_ = gl::Texture::ofBuffer("dynamic casters", GL_R32UI, *list_);
        flags_.emplace("flags of dynamic casters", triangles);
        flagsView_ = gl::Texture::ofBuffer("flags of dynamic casters", GL_R8UI, *flags_);
    }
    list_->upload(dynamicCasters);
    std::vector<std::uint8_t> flags(triangles);
    for (const std::uint32_t id : dynamicCasters) flags[id] = 1;
    flags_->upload(std::span<const std::uint8_t>(flags));
    listView_->bind(LARGE_TRIANGLES_UNIT);
    const gl::Program& program = programs_.get({"mask of dynamic casters", "techniques/history/dynamic_casters.vert",
                                                "passes/depth_only.frag", frame.defines()});
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    target_->bindForDrawing(size, size);
    const float farthest = 0.0f;
    glClearNamedFramebufferfv(target_->name(), GL_DEPTH, 0, &farthest);
    program.use(gl::Inputs().texture("previousPositions", previousPositions));
    glBindVertexArray(frame.fullscreen.noAttributes().name());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(dynamicCasters.size()));
    glDisable(GL_DEPTH_TEST);
}

}  // namespace timeshade
