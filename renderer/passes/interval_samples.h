#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/frame_caches.h"
#include "gl/framebuffer.h"
#include "gl/growing_buffer.h"
#include "passes/fullscreen.h"
#include "passes/sample_buffer.h"
#include "passes/stochastic_rasterizer.h"

namespace timeshade {

/// A part of what a position sees: one triangle, or NO_TRIANGLE, from u = begin to u = end.
struct SeenPart {
    std::uint32_t place;  ///< (row from the bottom x width + column) x positions + position
    std::uint32_t triangle;
    float begin, end;
};

/// Solves what every position of the picture sees during the shutter (docs/numerics.md, "Interval samples"): a
/// partition of [0, 1] into segments, one triangle each, nearest throughout. What is static before the camera is drawn,
/// once while it stays the same; only triangles that move are solved. The parts of a position follow each other; the
/// first begins at 0, the last ends at 1, and each ends where the next begins, bit for bit. Nothing is dropped: what
/// one draw does not finish, as a driver bounds the rounds of its loops, the next goes on with.
class IntervalSamples {
  public:
    IntervalSamples(gl::ProgramCache& programs, FrameCaches& caches);

    /// `cutAtStrata`: no part reaches beyond a stratum. `samples` receives what is static. Waits for the device. Throws
    /// LimitError where the device has no room, or its loops end too soon.
    void draw(const FramePlan& plan, const GpuMesh& mesh, const Fullscreen& fullscreen, SampleBuffer& samples,
              bool cutAtStrata);

    /// Records in parts(): those of the parts, and some between them (shaders/passes/seen_segments.frag).
    std::uint32_t partCount() const { return counts_.parts; }
    /// Of positions whose segments were solved in halves of the shutter, for want of room: how often.
    std::uint32_t halvings() const { return counts_.halvings; }
    const gl::Texture& parts() const { return parts_.texels(); }
    /// Where the first chunk of parts of every position is, RG32UI, one layer a position.
    const gl::Texture& heads() const { return *heads_; }
    /// All parts, position by position, and the number of each in parts().
    struct Read {
        std::vector<SeenPart> parts;
        std::vector<std::uint32_t> places;
    };
    Read read() const;
    std::size_t bytes() const;

  private:
    struct StaticSamples {
        StaticSamples(int width, int height, int positions);
        std::size_t bytes() const { return depth.bytes(); }
        gl::Texture depth;
    };
    struct Counts {
        std::uint32_t parts = 0, unfinished = 0, halvings = 0, advances = 0;
    };
    struct Candidates {
        gl::Buffer triangles, ids, offsets, entries;
        gl::Texture trianglesView, idsView, offsetsView, entriesView;
        int columns = 0;
        std::uint32_t tileSide = 8, buckets = 1;
        explicit Candidates(const FramePlan& plan);
        explicit Candidates(const struct SeenTiles& tiles);
        std::size_t bytes() const;
    };
    const gl::Texture& drawStatic(const FramePlan& plan, const GpuMesh& mesh, SampleBuffer& samples);
    void solve(const FramePlan& plan, const Fullscreen& fullscreen, const SampleBuffer& samples,
               const gl::Texture& staticDepth, bool cutAtStrata);
    Counts takeCounts();
    void finishPosition(const gl::Program& program, const Fullscreen& fullscreen, std::uint32_t position);
    void drawPosition(const gl::Program& program, const Fullscreen& fullscreen, std::uint32_t position) const;
    gl::ShaderDefines definesFor(const FramePlan& plan, bool cutAtStrata) const;
    std::vector<glm::u32vec2> readHeads() const;

    gl::ProgramCache& programs_;
    FrameCaches& caches_;
    StochasticRasterizer rasterizer_;
    gl::Framebuffer target_;
    gl::GrowingBuffer parts_;
    gl::Buffer countsBuffer_;
    std::optional<gl::Buffer> states_;
    std::optional<Candidates> candidates_;
    std::optional<gl::Texture> heads_;
    Counts counts_;
    std::uint32_t positions_ = 0;
};

}  // namespace timeshade
