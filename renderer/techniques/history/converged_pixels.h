#pragma once

#include <cstdint>
#include <optional>

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "technique/technique_frame.h"

namespace timeshade {

/// Pixels whose history has learned enough rest while the camera stands: once four tests in a row were sure of every
/// sample they are asked in every thirty-second frame, by an edge where answers are averaged in every sixteenth, and
/// never where all is proven; tile by tile in turn, so that frames cost alike. What moves wakes them. In between they
/// show what they showed before.
///
/// Memory: 4 bytes a pixel for when and where each is woken, 4 for marks, and 4 a camera sample for what is shown.
class ConvergedPixels {
  public:
    explicit ConvergedPixels(gl::ProgramCache& programs);

    /// Makes the textures for frames like this one. Those of another size are dropped, with what they know.
    void allocate(const TechniqueFrame& frame);
    /// Nothing rests in the next frame.
    void forget() { known_ = false; }
    /// Does every pixel have an answer that may be shown again?
    bool known() const { return known_; }

    struct DynamicCasters {
        const gl::Texture &mask, &flags;  ///< DynamicMask's
    };
    /// Marks the pixels that are not to rest, in a depth texture: a lookup with the depth test EQUAL draws them alone.
    /// `written`: the history as the frame before left it. The technique's uniforms must be bound.
    void invalidate(const TechniqueFrame& frame, const gl::Texture& written,
                    const std::optional<DynamicCasters>& dynamicCasters);
    const gl::Texture& marks() const { return *marks_; }
    /// Hands the answers, those of resting pixels with the others, to the frame. From then on they are known.
    void show(const TechniqueFrame& frame);

    const gl::Texture& periods() const { return *periods_; }  ///< R32UI: the lookup's second output
    const gl::Texture& lit() const { return *lit_; }          ///< R32F, a layer a stratum: what the lookup stores
    std::size_t bytes() const;

  private:
    gl::ProgramCache& programs_;
    gl::Framebuffer target_;
    std::optional<gl::Texture> periods_, marks_, lit_;
    bool known_ = false;
};

}  // namespace timeshade
