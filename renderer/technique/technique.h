#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/setting.h"
#include "technique/footprint.h"
#include "technique/lookup_program.h"
#include "technique/prediction.h"
#include "technique/sampling_traits.h"
#include "technique/stored_along_line.h"
#include "technique/technique_description.h"
#include "technique/technique_frame.h"
#include "technique/technique_statistic.h"
#include "technique/technique_view.h"

namespace timeshade {

/// The thing under study: computes `lit` for every camera sample. It reads the plan, the mesh and the samples, builds
/// what it needs, and says how a lookup tells from it whether a receiver is lit; the frame draws that lookup. It never
/// shades, never reads the clock, draws no random number but from the plan's seed, and knows no other technique and no
/// window. The frame's uniforms, the technique's settings and the mesh are bound when it is called.
class Technique : public HasSettings {
  public:
    Technique() = default;
    Technique(const Technique&) = delete;
    Technique& operator=(const Technique&) = delete;

    virtual const TechniqueDescription& description() const = 0;
    const std::string& settingsPrefix() const override { return description().name; }
    /// Why this plan can't be drawn, in words for the user; nothing if it can.
    virtual std::optional<std::string> unsupported(const FramePlan&) const { return std::nullopt; }
    /// The request as this technique has it drawn, with its settings as they are: a published form may say where in a
    /// pixel its sample lies. Asking twice changes nothing more. Whoever plans a frame for a technique plans this; what
    /// is compared with it in one picture is drawn of the same request, on the same camera samples.
    virtual FrameRequest asked(FrameRequest request) const { return request; }
    /// What of its settings this plan does not allow, and what is done instead, in words for the user.
    virtual std::vector<std::string> warnings(const FramePlan&) const { return {}; }
    /// What one value of it averages over, with its settings as they are.
    virtual Footprint footprint() const { return {}; }
    /// Where and when it looks for casters, with its settings as they are: what the named cases hold it to.
    virtual SamplingTraits samplingTraits() const { return {}; }
    /// What it does to casters beyond that, with its settings as they are. Never null; refers to nothing of the
    /// technique.
    virtual std::shared_ptr<const Prediction> prediction() const { return std::make_shared<Prediction>(); }
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

    /// True: a lookup by Casters::Static leaves out what is dynamic. False: the frame doesn't ask for one, and caches
    /// no visibility of static casters.
    virtual bool separatesStaticCasters() const { return true; }

    /// Draws whatever the lookup needs. Timed as "build".
    virtual void build(const TechniqueFrame& frame) = 0;
    /// True: its lookup program also says litAlong, and of interval samples each part is solved as it is. False: it
    /// tests what it tests, at one random time in each stratum of a part.
    virtual bool solvesIntervals() const { return false; }
    /// How lit follows from what build left, by those casters. With its settings as they are.
    virtual LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) = 0;
    /// True: it draws its lookup itself, and lookupProgram is never called. For what no single program per stratum can
    /// do.
    virtual bool hasOwnLookup() const { return false; }
    /// Writes lit for every camera sample. Only where hasOwnLookup. Both ways are timed as "lookup".
    virtual void drawLookup(const TechniqueFrame& frame);
    /// Views of this technique's own, with its settings as they are.
    virtual std::vector<TechniqueView> views() const { return {}; }
    /// Draws the view of that name after the lookup: one value a pixel into `values` (R32F, the picture's size),
    /// negative where there is nothing to show.
    virtual void drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values);
    /// What build left along a line of the light's map, in x and u: what the epipolar view draws. With the frame of the
    /// last build; of a frame that is drawn as several renders it is called after each. May wait for the device. A
    /// technique that overrides nothing is shown as one that stores nothing.
    virtual StoredAlongLine storedAlong(const TechniqueFrame&, const MapLine&) { return {}; }
    /// What was counted in the frame drawn last. May wait for the device.
    virtual std::vector<TechniqueStatistic> statistics() const { return {}; }
    /// The textures that build has drawn, for checks: none may hold a NaN or an infinity. Those of TechniqueFrame::maps
    /// are not among them.
    virtual std::vector<const gl::Texture*> textures() const { return {}; }
    /// GPU memory held by the technique itself, in bytes: without the frame's maps and caches.
    virtual std::size_t bytes() const = 0;

  private:
    friend class FrameRenderer;
    std::uint64_t drawnAt_ = 0;  ///< the frame's: how much had been invalidated when this drew last; 0 before
};

/// What it states about itself, with its settings as they are.
TechniqueStatement statementOf(const Technique& technique);

}  // namespace timeshade
