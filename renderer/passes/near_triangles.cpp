#include "passes/near_triangles.h"

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
    glNamedBufferSubData(list_->buffer().name(), 0, static_cast<GLsizeiptr>(count_ * sizeof(std::uint32_t)),
                         triangles.data());
}

void NearTriangles::addInputs(gl::Inputs& inputs) const {
    inputs.texture("nearTriangles", list_->texels()).set("nearCount", static_cast<std::int32_t>(count_));
}

}  // namespace timeshade
