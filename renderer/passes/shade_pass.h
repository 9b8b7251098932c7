#pragma once

#include "core/frame_caches.h"
#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "passes/fullscreen.h"
#include "passes/sample_buffer.h"
#include "passes/still_pixels.h"
#include "passes/visibility_buffer.h"
#include "plan/frame_plan.h"

namespace timeshade {

/// What the picture shows.
enum class View {
    Final,       ///< shaded, tone mapped
    Visibility,  ///< mean of lit over a pixel's camera samples, as it is; weighted like light
};

/// Mean over a pixel's samples of shading times lit, times the plan's weight: linear radiance, exposed. Each sample
/// counts by the shutter's response w at its time (Palmér's equation 2.1, by samples): sum w c / sum w over the pixel's
/// own samples. So what does not change keeps its colour; divided by the mean of w it would not, as the sum of a
/// pixel's weights varies. The price is the bias of a quotient, which stratified times let fall fast: a point that is
/// dark in [.3, .7] of a tent is .36 lit, and by 2, 4, 8 and 16 samples .483, .369, .3617, .3601 in the mean. One
/// sample is its own mean, so that it knows nothing of a response.
class ShadePass {
  public:
    ShadePass(gl::ProgramCache& programs, FrameCaches& caches)
        : programs_(programs), caches_(caches), target_("shade target") {}
    /// `radiance` is RGBA32F of the plan's size. add: add to what is there (brute force) instead of replacing it.
    void draw(const FramePlan& plan, const Fullscreen& fullscreen, const SampleBuffer& samples,
              const VisibilityBuffer& visibility, View view, bool add, const gl::Texture& radiance);

    /// The same picture, to the last bit, by way of a cached one of what is still: only the other pixels are shaded.
    /// For plans whose StaticVersions::shading is not 0.
    void drawOntoStill(const FramePlan& plan, const Fullscreen& fullscreen, const SampleBuffer& samples,
                       const VisibilityBuffer& visibility, View view, const StillPixels& still,
                       const gl::Texture& radiance);

    /// What interval samples are shaded from: IntervalSamples' parts and PartLookup's values.
    struct Parts {
        const gl::Texture& parts;
        const gl::Texture& heads;
        const gl::Texture& values;
        bool solved;  ///< values are means over a part, which is shaded at its middle; else each is of one time
    };
    /// The same of interval samples: parts count by their exposure, exactly.
    void draw(const FramePlan& plan, const Fullscreen& fullscreen, const Parts& parts, View view,
              const gl::Texture& radiance);

  private:
    const gl::Program& programOf(const FramePlan& plan, View view);

    gl::ProgramCache& programs_;
    FrameCaches& caches_;
    gl::Framebuffer target_;
};

}  // namespace timeshade
