#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gl/growing_buffer.h"
#include "gl/inputs.h"

namespace timeshade {

/// The moving triangles that cross the light's near plane (LightMotion::nearPlane), on the GPU: they have no
/// projection, and lib/near_triangles.glsl tries them one by one. Holds no memory while there are none.
class NearTriangles {
  public:
    void set(const std::vector<std::uint32_t>& triangles);
    std::size_t count() const { return count_; }
    /// Adds the list and its length, as lib/near_triangles.glsl reads them. Only where there are any.
    void addInputs(gl::Inputs& inputs) const;
    std::size_t bytes() const { return list_ ? list_->bytes() : 0; }

  private:
    std::optional<gl::GrowingBuffer> list_;
    std::size_t count_ = 0;
};

}  // namespace timeshade
