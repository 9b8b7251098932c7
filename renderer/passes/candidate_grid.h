#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "gl/growing_buffer.h"
#include "gl/program_cache.h"
#include "passes/candidate_cost.h"
#include "passes/cell_lists.h"
#include "plan/frame_plan.h"

namespace timeshade {

/// Lists of triangles that might shadow a receiver: one list per cell of the light's map and bucket of the shutter.
/// Conservative: a triangle that covers any point of the cell at any time of the bucket is in that list, with what the
/// projection may have rounded. An entry is the triangle's number and a depth that it is never nearer than.
class CandidateGrid {
  public:
    explicit CandidateGrid(gl::ProgramCache& programs);

    /// The frame's uniforms and the mesh must be bound. Where the lists would be larger than a storage block of this
    /// device takes, the grid's side is halved until they fit: slower to look up, and the same picture. `maxEntries`
    /// may lower that limit further.
    void build(const FramePlan& plan, const std::vector<std::uint32_t>& casters, const CandidateGridSize& wanted,
               gl::LateCounts& counts, std::size_t maxEntries = ~std::size_t{0});
    /// One place a cell and bucket and one more, and the entries: of four entries one texel holds the bounds and the
    /// next one the triangles.
    const gl::Texture& offsets() const { return lists_.offsets(); }
    const gl::Texture& candidates() const { return candidates_.texels(); }
    /// The same as buffers, to read back.
    const gl::Buffer& offsetsBuffer() const { return lists_.offsetsBuffer(); }
    const gl::Buffer& candidatesBuffer() const { return candidates_.buffer(); }

    int side() const { return side_; }
    int buckets() const { return buckets_; }
    /// Waits for the device.
    std::size_t entries() const { return lists_.total(); }
    bool coarsened() const { return coarsened_; }
    /// Memory held by everything, kept room included.
    std::size_t bytes() const;
    /// Bytes that these lists need: 8 an entry, 4 a caster and 4 a caster and bucket; and 8 a cell and bucket. The
    /// first waits for the device.
    double entryBytes() const;
    double cellBytes() const;

  private:
    void insert(const FramePlan& plan, std::size_t casters, bool fill);

    gl::ProgramCache& programs_;
    CellLists lists_;
    gl::GrowingBuffer casters_, candidates_;
    std::optional<gl::Buffer> queue_;
    int side_ = 0, buckets_ = 0;
    std::size_t castersCount_ = 0;
    bool coarsened_ = false;
};

}  // namespace timeshade
