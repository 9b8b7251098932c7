#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gl/growing_buffer.h"
#include "gl/program_cache.h"
#include "gl/vertex_array.h"
#include "plan/frame_plan.h"

namespace timeshade {

/// One cheap cover a moving triangle over all texels of the light's map that it may visit during the shutter: a point
/// where its sweep is small, else a rectangle. The fragment shader gets the triangle
/// (lib/covering_triangle.glsl) and decides.
class MovingCovers {
  public:
    MovingCovers();

    /// Uploads the triangles, sorted by kind of cover.
    void set(const FramePlan& plan, const std::vector<std::uint32_t>& triangles);
    /// Draws all covers into the framebuffer that is bound, with the inputs that the fragment shader wants.
    void draw(gl::ProgramCache& programs, const std::string& fragment, const gl::ShaderDefines& defines,
              const gl::Inputs& inputs) const;
    std::size_t count() const { return small_ + large_; }
    std::size_t bytes() const { return smallTriangles_.bytes() + largeTriangles_.bytes() + indices_.bytes(); }
    /// Of the index buffer, whose size does not depend on the scene.
    std::size_t fixedBytes() const { return indices_.bytes(); }

  private:
    gl::GrowingBuffer smallTriangles_, largeTriangles_;
    gl::Buffer indices_;
    gl::VertexArray rectangles_, points_;
    std::size_t small_ = 0, large_ = 0;
    bool orthographic_ = false, hasCutouts_ = false;
};

}  // namespace timeshade
