#pragma once

#include <memory>
#include <optional>

#include "gl/buffer.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "plan/frame_plan.h"
#include "scene/motion_mesh.h"

namespace timeshade {

/// The triangles of a frame and their materials on the GPU. What of the plan's mesh is other than before is uploaded.
class GpuMesh {
  public:
    /// Brings the GPU up to date with the plan.
    void update(const FramePlan& plan);

    /// Binds the buffer textures and material images to the units of frame_blocks.shared.h.
    void bind() const;

    const gl::Buffer& positions() const { return *positions_; }
    /// TRIANGLE_POSITION_TEXELS attributes a vertex, one vertex a triangle: what point rasterisation draws.
    const gl::VertexArray& trianglesAsVertices() const { return *trianglesAsVertices_; }
    /// Indexed vertices (0: position at u = 0, 1: position at u = 1) for ordinary rasterisation of all triangles.
    const gl::VertexArray& vertices() const { return *vertices_; }
    std::size_t triangleCount() const { return triangleCount_; }
    /// Whether some material is cut out by its alpha: what draws or tests triangles is then built with CUTOUTS
    /// (lib/cutouts.glsl).
    bool hasCutouts() const { return cutoutAlphas_.has_value(); }
    std::size_t bytes() const;
    /// Of the mesh, by the last update().
    std::size_t uploadedBytes() const { return uploadedBytes_; }

  private:
    void uploadMaterials(const FramePlan& plan);
    void uploadCutouts(const Cutouts& cutouts);
    void allocate(const FramePlan& plan);
    void uploadVertices(const MeshTopology& topology);

    std::shared_ptr<const MeshTexels> uploaded_;
    std::shared_ptr<const MeshTopology> allocatedFor_;
    const std::vector<Material>* materialsOf_ = nullptr;
    std::size_t triangleCount_ = 0, uploadedBytes_ = 0;
    std::optional<gl::Buffer> positions_, shading_, materials_, vertexPositions_, indices_;
    std::optional<gl::Buffer> cutoutMaterials_, cutoutAlphas_;
    std::optional<gl::Texture> positionsView_, shadingView_, materialsView_;
    // Where the scene has such.
    std::optional<gl::Buffer> vertexColours_, moreCoordinates_;
    std::optional<gl::Texture> vertexColoursView_, moreCoordinatesView_, indicesView_;
    std::optional<gl::Texture> cutoutMaterialsView_, cutoutAlphasView_;
    std::optional<gl::Texture> colorImages_, dataImages_;
    std::optional<gl::VertexArray> trianglesAsVertices_, vertices_;
};

}  // namespace timeshade
