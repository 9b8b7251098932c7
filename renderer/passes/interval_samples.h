#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/frame_caches.h"
#include "gl/growing_buffer.h"
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
/// first begins at 0, the last ends at 1, and each ends where the next begins, bit for bit. Nothing is dropped: where a
/// slice of the shutter has more segments than there is room for at once, or the driver has ended the loops, it is
/// solved again in halves.
class IntervalSamples {
  public:
    IntervalSamples(gl::ProgramCache& programs, FrameCaches& caches);

    /// `cutAtStrata`: no part reaches beyond a stratum. `samples` receives what is static. Waits for the device. Throws
    /// LimitError where the device has no room, or its loops end too soon.
    void draw(const FramePlan& plan, const GpuMesh& mesh, SampleBuffer& samples, bool cutAtStrata);

    std::uint32_t partCount() const { return counts_.parts; }
    /// RGBA32UI, as SeenPart.
    const gl::Texture& parts() const { return parts_.texels(); }
    /// The first part of every position and how many it has, RG32UI, one layer a position.
    const gl::Texture& partsOfPositions() const { return *partsOfPositions_; }
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
    /// As lib/seen_slices.glsl has them.
    struct Counts {
        std::uint32_t parts = 0, slices = 0, segments = 0, unsolved = 0;
    };
    /// Places that are solved together: so many from the first on.
    struct Batch {
        std::uint32_t first, places;
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
    /// `apart`: of so many invocations one writes parts.
    void solve(const FramePlan& plan, const SampleBuffer& samples, const gl::Texture& staticDepth, bool cutAtStrata,
               std::uint32_t apart);
    void solveBatch(const FramePlan& plan, const gl::Inputs& inputs, Batch batch);
    bool solveSlices(const gl::Program& program, std::uint32_t firstSlices);
    void writeParts(const gl::Inputs& inputs, Batch batch, bool cutAtStrata, std::uint32_t apart);
    std::uint32_t placesTogether() const;
    Counts readCounts() const;

    gl::ProgramCache& programs_;
    FrameCaches& caches_;
    StochasticRasterizer rasterizer_;
    gl::GrowingBuffer parts_, slices_, segments_;
    gl::Buffer countsBuffer_;
    std::optional<Candidates> candidates_;
    std::optional<gl::Texture> partsOfPositions_;
    Counts counts_;
};

}  // namespace timeshade
