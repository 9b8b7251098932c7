#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "panels/panels.h"
#include "panels/theme.h"

namespace timeshade {

namespace {

void drawInstant(Session& session, Widgets& widgets) {
    bool on = session.moment.instant.has_value();
    if (widgets.checkbox("instant.on", "Single instant", on, false,
                         "Draws the scene, shadows too, at one instant of the shutter instead of all of it."))
        session.moment.instant = on ? std::optional<double>(0.5) : std::nullopt;
    if (!session.moment.instant) return;
    Widgets::Number number;
    number.format = "u = %.4f";
    number.help =
        "Where in the shutter: 0 where it opens, 1 where it closes. Comma and full stop step by a sixteenth; playing "
        "runs through the shutter.";
    double u = *session.moment.instant;
    if (widgets.slider("instant", "Instant", u, number)) session.moment.instant = std::clamp(u, 0.0, 1.0);
}

void drawMotionSteps(Session& session, Widgets& widgets) {
    FrameRequest& request = session.moment.request;
    const std::vector<std::string> counts{"1", "2", "4", "8", "16", "32"};
    const auto steps = widgets.combo(
        "motion-steps", "Motion steps", counts,
        static_cast<std::size_t>(std::countr_zero(unsigned(request.motionSteps))),
        "Into how many pieces the shutter is cut, in each of which all motion is linear: what turns or bounces is "
        "drawn "
        "right with enough of them. Each is drawn with its share of the samples, so that they are lowered to what "
        "divides those.",
        counts);
    if (steps) request.motionSteps = 1 << *steps;
}

void drawPart(Session& session, Widgets& widgets) {
    Playback& playback = session.moment.playback;
    if (!playback.moves()) return;
    Widgets::Number speed;
    speed.minimum = 0.01;
    speed.maximum = 1.0;
    speed.logarithmic = true;
    speed.format = "%.3gx";
    speed.defaultValue = 1.0;
    speed.help = "1x is real time. The frames stay the same.";
    double value = playback.speed();
    if (widgets.slider("speed", "Playback speed", value, speed)) playback.setSpeed(value);
    Widgets::Number frame;
    frame.maximum = playback.loopFrames() - 1;
    frame.format = "Frame %d";
    frame.help = "The part of the motion that is played again and again.";
    int first = playback.firstFrame(), last = playback.lastFrame();
    frame.defaultValue = 0.0;
    const bool from = widgets.slider("loop.first", "Loop from", first, frame);
    frame.defaultValue = frame.maximum;
    const bool to = widgets.slider("loop.last", "Loop to", last, frame);
    if (from) playback.setPart(first, std::max(first, last));
    if (to) playback.setPart(std::min(first, last), last);
    FrameRequest& request = session.moment.request;
    const auto looping = widgets.combo(
        "loop", "Beyond the clip", {"Automatic", "Repeat", "Hold"}, static_cast<std::size_t>(request.looping),
        "What a shutter sees that opens before the clip's start or closes after its end: the clip repeats, or its "
        "first and last pose are held. Automatic repeats a clip whose end joins its start.",
        {"auto", "on", "off"});
    if (looping) request.looping = static_cast<Looping>(*looping);
}

void drawRecording(Session& session, Widgets& widgets) {
    Recording& recording = session.recording;
    const std::string text =
        recording.on() ? fmt::format("Stop recording ({} frames)", recording.frames()) : "Record (Ctrl-R)";
    if (widgets.button("record", text, ImGui::GetContentRegionAvail().x)) session.requests.recording = true;
    widgets.paragraph("Frame by frame from the one that is shown, each drawn whole, as H.264.", theme::quiet);
}

}  // namespace

void drawTimePanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.time", "Time and recording", true)) return;
    drawInstant(session, widgets);
    drawMotionSteps(session, widgets);
    drawPart(session, widgets);
    drawRecording(session, widgets);
}

}  // namespace timeshade
