#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "gl/texture.h"

namespace timeshade {

struct TechniqueFrame;

/// Draws a technique's lookup (shaders/lib/lookup.glsl) over the visibility buffer, once a stratum, and asks no
/// question twice:
/// - where nothing moves and the frame is the one before, the buffer holds the answers already;
/// - where camera and light stand still, answers about still receivers that no moving caster can reach are kept from
/// the
///   second such frame on (one float a sample, and the cells of the light's map that a pixel's samples lie in), and
///   only the other pixels are asked for.
/// What is drawn is the same to the last bit in either case.
class LookupPass {
  public:
    /// The technique's program with further defines (those of lib/lookup_main.glsl), its uniforms set and its textures
    /// bound.
    using ProgramFor = std::function<const gl::Program&(const gl::ShaderDefines& purpose)>;

    explicit LookupPass(gl::ProgramCache& programs) : programs_(programs), target_("visibility target") {}
    void draw(const TechniqueFrame& frame, const ProgramFor& programFor);

    /// Around a technique's lookup: one that does not come here leaves nothing to be kept.
    void begin() { used_ = false; }
    void end() {
        if (!used_) forget();
    }
    void forget();
    std::size_t bytes() const;

  private:
    static void drawStrata(const TechniqueFrame& frame, const gl::Program& program, const gl::Framebuffer& target,
                           const gl::Texture& ids, const gl::Texture& lit, const gl::Texture* cells);
    void dropCache();
    void keep(const TechniqueFrame& frame, const ProgramFor& programFor);
    void drawReached(const TechniqueFrame& frame, const ProgramFor& programFor);

    gl::ProgramCache& programs_;
    gl::Framebuffer target_;
    std::optional<gl::Framebuffer> cacheTarget_, reachedTarget_;
    bool used_ = false;
    std::uint64_t drawn_ = 0;   ///< key of what the visibility buffer holds, where that is good for the next frame
    std::uint64_t seen_ = 0;    ///< key of the frame before
    std::uint64_t cached_ = 0;  ///< key of what is kept
    std::optional<gl::Texture> cachedLit_, cachedCells_, reached_, depth_;
};

}  // namespace timeshade
