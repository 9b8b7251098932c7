#pragma once

#include <cstdint>
#include <optional>

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "technique/technique_frame.h"

namespace timeshade {

/// Tests converged pixels less often while the camera is static. Once four tests in a row were certain for all samples,
/// a pixel is tested in every 32nd frame; near an edge, where values are averaged, in every 16th; never if all samples
/// are proven. Pixels are due tile by tile in turn, so that frames cost alike. Motion invalidates them. In between they
/// show their last values.
///
/// Memory: 4 bytes per pixel for the re-test period and map cells, 4 for marks, and 4 per camera sample for the values.
class ConvergedPixels {
  public:
    explicit ConvergedPixels(gl::ProgramCache& programs);

    /// Creates the textures for frames of this size. Textures of another size and their content are dropped.
    void allocate(const TechniqueFrame& frame);
    /// The next frame tests every pixel.
    void forget() { known_ = false; }
    /// Whether every pixel has values that may be shown again.
    bool known() const { return known_; }

    struct DynamicCasters {
        const gl::Texture &mask, &flags;  ///< DynamicMask's
    };
    /// Marks the pixels to test in a depth texture: a lookup with the depth test EQUAL draws only those. `written`: the
    /// history of the previous frame. The technique's uniforms must be bound.
    void invalidate(const TechniqueFrame& frame, const gl::Texture& written,
                    const std::optional<DynamicCasters>& dynamicCasters);
    const gl::Texture& marks() const { return *marks_; }
    /// Copies all values, those of converged pixels included, to the frame. known() is true afterwards.
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
