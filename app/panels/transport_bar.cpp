#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "panels/fitting_text.h"
#include "panels/panels.h"
#include "panels/theme.h"
#include "window/status_line.h"

namespace timeshade {

namespace {

void drawTransport(Session& session, Widgets& widgets) {
    Playback& playback = session.moment.playback;
    if (!playback.moves()) {
        ImGui::AlignTextToFramePadding();
        widgets.paragraph("Static scene: nothing moves", theme::quiet);
        return;
    }
    const float side = 24.0f * widgets.scale();
    if (widgets.iconButton("play", playback.playing() ? Icon::Pause : Icon::Play,
                           playback.playing() ? "Pause (space)" : "Play (space)", side))
        playback.play(!playback.playing());
    ImGui::SameLine(0.0f, 2.0f * widgets.scale());
    if (widgets.iconButton("step.back", Icon::StepBack, "Previous frame (left)", side)) playback.step(-1);
    ImGui::SameLine(0.0f, 2.0f * widgets.scale());
    if (widgets.iconButton("step.forward", Icon::StepForward, "Next frame (right)", side)) playback.step(1);
    ImGui::SameLine();
    int frame = playback.frameInLoop();
    // A frame from the command line may lie anywhere; it is shown as it is until it is moved.
    const std::string format = fmt::format("Frame {:.6g} of {}", playback.frame(), playback.loopFrames());
    ImGui::SetNextItemWidth(std::max(20.0f * widgets.scale(), ImGui::GetContentRegionAvail().x));
    if (ImGui::SliderInt("##scrub", &frame, 0, playback.loopFrames() - 1, format.c_str(),
                         ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput)) {
        playback.play(false);
        playback.jump(frame);
        session.requests.forget = true;
    }
    widgets.dump().lastItem("scrub", playback.frame());
}

void drawProgress(Session& session, Widgets& widgets) {
    const int done = session.renderer.rendersDone(), all = session.renderer.renders();
    const bool stopped = session.driver.state() == FrameDriver::State::Cancelled;
    const float width = 90.0f * widgets.scale();
    const float bar = ImGui::GetContentRegionAvail().x - width - ImGui::GetStyle().ItemSpacing.x;
    const std::string text = stopped ? fmt::format("Stopped: average of {} of {} renders", done, all)
                                     : fmt::format("Render {} of {}", done, all);
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram,
                          stopped ? ImVec4(0.35f, 0.37f, 0.40f, 1.0f) : ImVec4(0.23f, 0.38f, 0.53f, 1.0f));
    ImGui::ProgressBar(static_cast<float>(done) / static_cast<float>(std::max(1, all)),
                       {std::max(bar, 20.0f * widgets.scale()), 0.0f}, text.c_str());
    ImGui::PopStyleColor();
    widgets.dump().lastItem("progress", text);
    ImGui::SameLine();
    if (stopped) {
        if (widgets.button("continue", "Continue", width)) session.driver.resume();
    } else if (widgets.button("cancel", "Cancel", width)) {
        session.driver.cancel();
    }
}

}  // namespace

void drawTransportBar(Session& session, Widgets& widgets, const Area& area) {
    if (area.empty()) return;
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
    if (ImGui::Begin("transport", nullptr, flags)) {
        drawTransport(session, widgets);
        const FrameDriver::State state = session.driver.state();
        const bool partial = state == FrameDriver::State::Drawing || state == FrameDriver::State::Cancelled;
        if (partial && session.driver.hasPlan() && session.renderer.renders() > 1)
            drawProgress(session, widgets);
        else {
            ImGui::AlignTextToFramePadding();
            const std::string status = statusOf(session);
            const std::string building = session.building.empty() ? "" : " (" + session.building + ")";
            const std::string shown = fittingText(status, building, ImGui::GetContentRegionAvail().x);
            ImGui::TextColored(session.driver.preview() ? theme::warning : theme::quiet, "%s", shown.c_str());
            widgets.dump().lastItem("status", status + building);
        }
    }
    ImGui::End();
}

}  // namespace timeshade
