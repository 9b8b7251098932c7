#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "technique/technique.h"

namespace timeshade {

/// What the tuples of a frame came to.
struct TupleCounts {
    std::size_t tuples = 0;
    std::size_t longestList = 0;
    std::size_t coveredTexels = 0;   ///< claimed by a triangle in the coverage map
    std::size_t skippedTuples = 0;   ///< left out since a claim says enough
    std::size_t predictedBytes = 0;  ///< memory that the layout takes for so many tuples
};

/// The temporal shadow map: lists of tuples per texel, and the coverage map beside them.
class TupleLists {
  public:
    TupleLists() = default;
    virtual ~TupleLists() = default;
    TupleLists(const TupleLists&) = delete;
    TupleLists& operator=(const TupleLists&) = delete;

    /// Draws the moving triangles `moving` (ascending).
    virtual void build(const TechniqueFrame& frame, const std::vector<std::uint32_t>& moving, bool coverageMap) = 0;
    /// Adds what lookup and views read.
    virtual void addInputs(gl::Inputs& inputs) const = 0;
    /// Adds the tuples along a line of the map. Waits for the device.
    virtual void addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const = 0;
    /// Reads the lists back: waits for the device.
    virtual TupleCounts counts() const = 0;
    virtual std::vector<const gl::Texture*> textures() const = 0;
    virtual std::size_t bytes() const = 0;
};

}  // namespace timeshade
