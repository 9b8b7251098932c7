#pragma once

#include <functional>
#include <optional>

#include "core/frame_caches.h"
#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "gl/texture.h"
#include "passes/still_pixels.h"
#include "technique/footprint.h"
#include "technique/lookup_program.h"
#include "technique/technique_frame.h"

namespace timeshade {

/// A technique's way to tell what is lit, as the frame draws it.
struct Lookup {
    std::function<LookupProgram(Casters)> program;
    Footprint footprint;
    CacheKey key = 0;                        ///< of what static casters do to static receivers, by this technique too
    const gl::Texture* staticIds = nullptr;  ///< samples of what is static alone, layers as in the sample buffer; null
                                             ///< where that is not known
};

/// The program `wanted` of a lookup, with the defines of the frame, of the times that its footprint spans, of the
/// purpose that it is drawn for, and its own.
const gl::Program& programOf(gl::ProgramCache& programs, const TechniqueFrame& frame, const Lookup& lookup,
                             const LookupProgram& wanted, const gl::ShaderDefines& purpose);

/// Draws a lookup program (shaders/lib/lookup.glsl) over the visibility buffer, once a stratum, and tests nothing
/// twice:
/// - where nothing moves and the frame is the one before, the buffer holds the visibility already;
/// - where camera and light stand, the visibility of static receivers that no dynamic caster can reach is cached from
///   the second such frame on (one float a sample, and the cells of the light's map that a pixel's samples lie in), and
///   only the other pixels are tested. That takes a technique that tests a point at an instant, with a filter of at
///   most DynamicCasterMask's margin.
/// What is drawn is the same to the last bit in either case.
class LookupPass {
  public:
    LookupPass(gl::ProgramCache& programs, FrameCaches& caches)
        : programs_(programs), caches_(caches), target_("visibility target") {}
    /// Returns the pixels that are still, where it has found them out.
    std::optional<StillPixels> draw(const TechniqueFrame& frame, const Lookup& lookup);

  private:
    /// Visibility of static receivers by static casters, and the cells of the light's map that each pixel's samples lie
    /// in: x and y, and what is left beyond them.
    struct StaticVisibility {
        StaticVisibility(int width, int height, int strata);
        std::size_t bytes() const { return lit.bytes() + cells.bytes(); }
        gl::Texture lit, cells;
        gl::Framebuffer target;
    };
    /// Which cells of the map a dynamic caster reaches, and the pixels that are to be tested, as a depth buffer.
    struct ReachedPixels {
        ReachedPixels(int width, int height);
        std::size_t bytes() const { return cells.bytes() + depth.bytes(); }
        gl::Texture cells, depth;
        gl::Framebuffer target;
    };
    const gl::Program& use(const TechniqueFrame& frame, const Lookup& lookup, Casters casters,
                           const gl::ShaderDefines& purpose);
    static void drawStrata(const TechniqueFrame& frame, const gl::Program& program, const gl::Framebuffer& target,
                           const gl::Texture& lit);
    StaticVisibility& staticVisibility(const TechniqueFrame& frame, const Lookup& lookup);
    void markReached(const TechniqueFrame& frame, const StaticVisibility& cached, ReachedPixels& reached);
    StillPixels drawReached(const TechniqueFrame& frame, const Lookup& lookup);

    gl::ProgramCache& programs_;
    FrameCaches& caches_;
    gl::Framebuffer target_;
};

}  // namespace timeshade
