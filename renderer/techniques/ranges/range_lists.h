#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plan/light_motion.h"
#include "technique/technique.h"

namespace timeshade {

/// How many of what a frame's lists held.
struct RangeCounts {
    std::size_t fragments = 0;       ///< of prisms, over all texels: N_f
    std::size_t ranges = 0;          ///< N_r
    std::size_t longestList = 0;     ///< fragments of one texel
    std::size_t unpairedLists = 0;   ///< texels in which a prism left an odd number of fragments: it was not closed
    std::size_t predictedBytes = 0;  ///< memory by equation 2 of Hong and Oh 2019, with this form's sizes
};

/// The lists of depth-time ranges of all texels, in one of two forms.
class RangeLists {
  public:
    virtual ~RangeLists() = default;
    /// Draws the prisms of motion.dynamicCasters and makes ranges of them, timed as "build/collect" and
    /// "build/generate". Throws Error that names the limit where the device can't hold the lists.
    virtual void build(const TechniqueFrame& frame, const LightMotion& motion) = 0;
    /// Adds what shaders/techniques/ranges/lists.glsl reads.
    virtual void addInputs(gl::Inputs& inputs) const = 0;
    /// Adds the ranges along a line of the map. Waits for the device.
    virtual void addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const = 0;
    /// Of the lists built last. Waits for the device.
    virtual RangeCounts counts() const = 0;
    virtual std::size_t bytes() const = 0;
};

}  // namespace timeshade
