#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/growing_buffer.h"
#include "passes/cell_lists.h"
#include "passes/moving_covers.h"
#include "technique/technique.h"

namespace timeshade {

/// What the lists of a frame came to.
struct IntervalCounts {
    std::size_t collected = 0;    ///< intervals of all texels before their lists were arranged
    std::size_t kept = 0;         ///< that are looked up
    std::size_t most = 0;         ///< of one texel, kept
    std::size_t texelsInUse = 0;  ///< with at least one
    std::size_t bentParts = 0;    ///< whose distance is not within `depth_error` of linear
    std::size_t overflowed = 0;   ///< texels in which intervals were merged
    double meanError = 0.0;       ///< of their compression, over those: world units, a mean over the shutter
    double mostError = 0.0;       ///< of one of them
    std::size_t usedBytes = 0;    ///< memory that the layout takes for what was collected
};

/// The light's map of intervals (Palmér 2011, section 2.1): for each texel, and each triangle that covers its centre
/// during the shutter, from when to when, how far from the light at both ends, and the triangle's number. 20 bytes an
/// interval in lists of exact size, sorted by time. Linear in between: within `depth_error` texels of the triangle, or
/// as published. Beside them it holds the intervals as they were collected: 28 bytes each, and 16 a texel for places.
class IntervalMap {
  public:
    struct Form {
        bool asPublished = false;
        std::uint32_t capacity = 0;              ///< as published: intervals of a texel; 0: without a limit
        const gl::Texture* staticMap = nullptr;  ///< what is behind it is left out; may be none
    };

    explicit IntervalMap(gl::ProgramCache& programs);

    /// Lists the triangles (ascending), none of which crosses the light's near plane. Timed as "build/count",
    /// "build/intervals" and "build/arrange". Throws LimitError where the device does not hold the lists.
    void build(const TechniqueFrame& frame, const std::vector<std::uint32_t>& triangles, const Form& form);
    /// Adds what shaders/techniques/intervals/lists.glsl reads.
    void addInputs(gl::Inputs& inputs) const;
    /// As published: the error of compression of each texel, distance times u.
    const gl::Texture& errors() const { return errors_.texels(); }
    /// Adds the intervals along a line of the map. Waits for the device.
    void addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const;
    /// Reads the lists back: waits for the device.
    IntervalCounts counts() const;
    std::size_t bytes() const;

  private:
    void collect(const TechniqueFrame& frame, bool fill);
    std::size_t reserve(std::size_t count);
    void bindEntries() const;
    std::size_t reserveArranged(std::size_t count);
    void bindArranged() const;
    void arrangeVisible(const TechniqueFrame& frame);
    void arrangeAsPublished(const TechniqueFrame& frame);
    gl::Inputs entries() const;
    void run(const gl::ProgramDescription& source, const gl::Inputs& inputs, std::size_t invocations);
    /// The places of what is looked up.
    const CellLists& lookedUp() const;
    void addErrors(const std::vector<GLuint>& offsets, IntervalCounts& counts) const;

    gl::ProgramCache& programs_;
    Form form_;
    MovingCovers covers_;
    CellLists lists_;
    gl::GrowingBuffer times_, depths_, ids_;  ///< as collected
    gl::GrowingBuffer visibleTimes_;          ///< of those: when each is seen
    CellLists arrangedLists_;                 ///< of what is seen; as published lists keep their places
    gl::GrowingBuffer arrangedTimes_, arrangedDepths_, arrangedIds_, errors_;
    gl::Buffer bentParts_;
    gl::Framebuffer target_;
    std::size_t collected_ = 0;  ///< at most
};

}  // namespace timeshade
