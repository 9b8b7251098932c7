#include "passes/near_triangles.h"

#include "gl/uploads.h"
#include "shared/frame_blocks.shared.h"

namespace timeshade {

void NearTriangles::set(const std::vector<std::uint32_t>& triangles) {
    count_ = triangles.size();
    if (triangles.empty()) {
        list_.reset();
        return;
    }
    if (!list_) list_.emplace("near-plane triangles", GL_R32UI);
    list_->reserve(count_, "fewer triangles must cross the light's near plane");
    gl::upload(list_->buffer().name(), std::span<const std::uint32_t>(triangles));
}

void NearTriangles::addInputs(gl::Inputs& inputs) const {
    inputs.texture("nearTriangles", list_->texels()).set("nearCount", static_cast<std::int32_t>(count_));
}

}  // namespace timeshade
