#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/frame_caches.h"
#include "frame/late_picture.h"
#include "frame/lookup_pass.h"
#include "frame/part_lookup.h"
#include "frame/settings_block.h"
#include "gl/device_info.h"
#include "gl/pass_timer.h"
#include "image/image_file.h"
#include "passes/display_pass.h"
#include "passes/frame_uniforms.h"
#include "passes/heat_map_pass.h"
#include "passes/sample_pass.h"
#include "passes/shade_pass.h"
#include "technique/technique.h"

namespace timeshade {

/// Bytes of GPU memory, by what holds them; a technique's as of the last render.
struct GpuMemory {
    std::size_t mesh = 0, samples = 0, visibility = 0, technique = 0, picture = 0;
    std::size_t total() const { return mesh + samples + visibility + technique + picture; }
};

/// The one function that draws a frame: window, headless pictures, tests and measurements all call it.
///   plan -> sample pass -> technique (build, lookup) -> shade -> display
/// A technique that draws the frame many times (brute force) is drawn one render a step, so that a window stays alive;
/// so is a shutter of many linear pieces, one piece a step. Within a step there are pause points.
class FrameRenderer {
  public:
    /// Needs a current context for as long as it lives.
    FrameRenderer();

    gl::ProgramCache& programs() { return programs_; }
    /// Nothing of earlier frames is used again: neither what is cached nor what techniques remember. For whatever a key
    /// does not tell: shaders, a scene, buffers that are others.
    void invalidateAll();
    /// Builds all programs again from their files and invalidates everything. Where one can't be built, the last good
    /// one stays; what the driver and the files say of these, a line each.
    std::vector<std::string> reloadShaders();
    const gl::DeviceInfo& device() const { return device_; }

    /// Starts a frame. The technique must outlive the frame. Throws Error where the technique does not support the plan
    /// or the buffers can't be had. `techniqueView` names one of the technique's own views, which is then shown as a
    /// heat map instead of `view`; throws UsageError where the technique has no such view. Where `counts` are read
    /// later, nothing of the frame is to be used before room() says that it is right.
    void begin(FramePlan plan, Technique& technique, View view, const std::string& techniqueView = {},
               gl::LateCounts::Reading counts = gl::LateCounts::Reading::AtOnce);
    /// Draws the next render. True when the frame is complete. Where a pause (core/pause.h) ends it, the frame is given
    /// up and nothing of it or of frames before is used again; a technique with a history has forgotten it.
    bool step();
    /// begin, and step to the end.
    void draw(FramePlan plan, Technique& technique, View view, const std::string& techniqueView = {});

    /// Did the room that was made for lists suffice, in the renders so far? Pending until the device is done with a
    /// complete frame. Where it did not, the frame has to be begun again. Does not wait.
    gl::LateCounts::State room() { return counts_.state(); }
    /// The same of a complete frame, waiting for it.
    gl::LateCounts::State settledRoom() { return counts_.settle(); }
    bool complete() const { return renders_ > 0 && done_ == renders_; }
    int rendersDone() const { return done_; }
    int renders() const { return renders_; }
    const FramePlan& plan() const { return *plan_; }

    /// The picture so far, for the screen; drawn anew by every call.
    const gl::Texture& displayTexture();
    DisplayImage readPicture();
    /// The same without waiting for it: the next frame may be begun before it is taken.
    LatePicture askPicture();
    /// Of a technique's view: its values as they are, in all three channels, negative where there is nothing.
    LinearImage readRadiance();
    /// The technique's view that is shown, with its scale; nothing where light is shown.
    const std::optional<TechniqueView>& techniqueView() const { return techniqueView_; }
    /// lit of every camera sample of the last render: [stratum][row from the bottom][column].
    std::vector<float> readVisibility() const;
    /// Of interval samples, which the last render had (checked): what was found of each part.
    struct PartValue {
        SeenPart part;
        float lit;     ///< over the times at which the receiver faces the light inside its cone; 1 where there are none
        float tested;  ///< their share of the part
    };
    /// Row by row from the bottom, pixel by pixel, position by position, ascending in time.
    std::vector<PartValue> readParts() const;
    bool hasIntervalSamples() const { return render_ && render_->block.positions > 0; }
    /// How many they are.
    std::size_t partCount() const { return hasIntervalSamples() ? intervals_.partCount() : 0; }
    /// Triangle of every camera sample of the last render, same order.
    std::vector<std::uint32_t> readSampleIds() const;

    /// What the technique stored along a line of the light's map in the last render. At least one must have been drawn
    /// (checked), and the technique and its settings be as they were.
    StoredAlongLine storedAlong(const MapLine& line);

    /// Checked: after every render, all float buffers are read back and scanned. A NaN, an infinity, or a lit outside
    /// [0, 1] throws Error that names the buffer, the place and the value. Slow; for tests and --gl-debug.
    void setChecked(bool checked) { checked_ = checked; }

    gl::PassTimer& timer() { return timer_; }
    GpuMemory memory() const;

  private:
    void drawRender();
    void giveUp();
    void resize(int width, int height, int strata);
    void checkBuffers() const;
    void forgetPast(Technique& technique);
    void drawSamples(const FramePlan& plan);
    std::optional<StillPixels> drawLookup(const TechniqueFrame& frame);
    void drawShade(const FramePlan& plan, const std::optional<StillPixels>& still);
    TechniqueFrame techniqueFrame();
    void endFrame();
    float scaleToWhole() const;

    gl::DeviceInfo device_;
    gl::PassTimer timer_;
    gl::ProgramCache programs_;
    FrameCaches caches_;
    gl::LateCounts counts_;
    FrameUniforms uniforms_;
    SettingsBlock settings_;
    LightMaps maps_;
    Fullscreen fullscreen_;
    GpuMesh mesh_;
    SamplePass samplePass_;
    IntervalSamples intervals_;
    ShadePass shadePass_;
    DisplayPass displayPass_;
    HeatMapPass heatMapPass_;
    LookupPass lookupPass_;
    PartLookup partLookup_;
    std::optional<SampleBuffer> samples_;
    std::optional<VisibilityBuffer> visibility_;
    std::optional<gl::Texture> radiance_, picture_;
    std::optional<gl::Texture> values_;  ///< of a technique's view, once one has been shown

    std::optional<FramePlan> plan_;
    std::optional<FramePlan> render_;  ///< the plan of the last render
    Technique* technique_ = nullptr;
    std::size_t techniqueBytes_ = 0;  ///< after the last render
    View view_ = View::Final;
    std::optional<TechniqueView> techniqueView_;
    int instants_ = 1;  ///< that the technique draws of the frame
    int renders_ = 0, done_ = 0;
    double weightDone_ = 0.0;          ///< share of the renders so far in the whole picture
    std::uint64_t invalidatedAt_ = 0;  ///< how much had been invalidated, by any renderer, after this one's last time
    bool checked_ = false;
};

}  // namespace timeshade
