#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/setting.h"
#include "gl/pass_timer.h"
#include "gl/program_cache.h"
#include "passes/fullscreen.h"
#include "passes/gpu_mesh.h"
#include "passes/sample_buffer.h"
#include "passes/visibility_buffer.h"
#include "plan/frame_plan.h"
#include "technique/footprint.h"
#include "technique/lookup_pass.h"
#include "technique/sampling_traits.h"

namespace timeshade {

struct TechniqueDescription {
    std::string name;     ///< as on the command line: lower case, also the name of its folders
    std::string title;    ///< for people
    std::string summary;  ///< one sentence: the idea and the price
    std::string source;   ///< paper, year
};

/// What a technique may read, and the one buffer that it writes.
struct TechniqueFrame {
    const FramePlan& plan;
    const GpuMesh& mesh;
    const SampleBuffer& samples;
    const VisibilityBuffer& visibility;
    const Fullscreen& fullscreen;
    gl::PassTimer& timer;  ///< for steps inside build and lookup, named "build/..." and "lookup/..."
    LookupPass& lookup;    ///< how a lookup is drawn that asks each sample for itself
    const gl::Texture* staticIds =
        nullptr;  ///< samples of what stands still alone, layers as in `samples`; null where it is not known
    const gl::Texture* dynamicPixels =
        nullptr;  ///< R8: pixels in which something that moves is seen; null where there is none
    std::uint64_t staticVisibility =
        0;  ///< equal in two frames: still receivers and still casters give the same answers, by this technique too
};

/// A picture of what a technique works with, instead of the scene: one value a pixel, coloured by a scale.
struct TechniqueView {
    std::string name;              ///< as after --view: lower case, dashes between words
    std::string title;             ///< for people
    std::string unit;              ///< of the values: "ranges", "u"; may be empty
    double low = 0.0, high = 1.0;  ///< the scale's ends; values beyond take the ends' colours
    bool logarithmic = false;
};

/// Something that a technique counted while it drew, for the panel, --explain and reports.
struct TechniqueStatistic {
    std::string name;  ///< "dynamic triangles", "entries", "lists with unpaired fragments"
    double value = 0.0;
    std::string unit;     ///< may be empty
    std::string warning;  ///< what it means for the picture, where that is not right; else empty
};

/// The thing under study: computes `lit` for every camera sample. It reads the plan, the mesh and the samples and
/// writes the visibility buffer. It never shades, never asks the clock, draws no random number but from the plan's
/// seed, and knows no other technique and no window. The frame's uniforms and the mesh are bound when it is called.
class Technique : public HasSettings {
  public:
    Technique() = default;
    Technique(const Technique&) = delete;
    Technique& operator=(const Technique&) = delete;

    virtual const TechniqueDescription& description() const = 0;
    const std::string& settingsPrefix() const override { return description().name; }
    /// Why this plan can't be drawn, in words for the user; nothing if it can.
    virtual std::optional<std::string> unsupported(const FramePlan&) const { return std::nullopt; }
    /// What one value of it averages over, with its settings as they are.
    virtual Footprint footprint() const { return {}; }
    /// Where and when it looks for casters, with its settings as they are: what the named cases hold it to.
    virtual SamplingTraits samplingTraits() const { return {}; }
    /// The passes that this technique adds to the plan's, each with its reason.
    virtual std::vector<PassDecision> passes(const FramePlan& plan) const = 0;
    /// How many times the whole frame is drawn, each time with all samples at one instant, and averaged. 1: drawn
    /// once, with the samples spread over the shutter.
    virtual int renders() const { return 1; }

    /// How many frames before the first must be drawn, in order, for that one to be what it would be in a sequence.
    virtual int warmUpFrames() const { return 0; }
    /// How many times that frame itself is drawn beforehand, as when a window stands still on it.
    virtual int heldFrames() const { return 0; }
    /// How often a window draws a still moment again, because the picture goes on getting better.
    virtual int settlingFrames() const { return 0; }
    /// Forgets what earlier frames left behind: the next frame has no past.
    virtual void forget() {}

    /// Draws whatever the lookup needs. Timed as "build".
    virtual void build(const TechniqueFrame& frame) = 0;
    /// Writes lit for every camera sample. Timed as "lookup".
    virtual void lookup(const TechniqueFrame& frame) = 0;
    /// Views of this technique's own, with its settings as they are.
    virtual std::vector<TechniqueView> views() const { return {}; }
    /// Draws the view of that name after the lookup: one value a pixel into `values` (R32F, the picture's size),
    /// negative where there is nothing to show.
    virtual void drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values);
    /// What was counted in the frame drawn last. May wait for the device.
    virtual std::vector<TechniqueStatistic> statistics() const { return {}; }
    /// The textures that build has drawn, for checks: none may hold a NaN or an infinity.
    virtual std::vector<const gl::Texture*> textures() const = 0;
    /// GPU memory held, in bytes.
    virtual std::size_t bytes() const = 0;
};

/// Defines that lib/receiver.glsl and lib/light_map.glsl want for this plan.
gl::ShaderDefines viewDefines(const FramePlan& plan);

}  // namespace timeshade
