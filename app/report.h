#pragma once

#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "gl/pass_timer.h"
#include "scene/scene.h"

namespace timeshade {

/// What the plan says about one thing: "build/static map", and why it is there.
struct PlanLine {
    std::string word;
    std::string text;
};
std::vector<PlanLine> explainedLines(const FramePlan& plan, const Technique& technique, const gl::DeviceInfo& device);

/// ", response tent" for a heading that has named the shutter; empty for a box, which is usual.
std::string responseInTitle(const Shutter& shutter);

/// The plan in words: what moves, which passes run, why, and warnings.
std::string explain(const FramePlan& plan, const Technique& technique, const gl::DeviceInfo& device);

/// What the technique counted in the frame drawn last, a line each, with what it means where that is not right; empty
/// if it counted nothing.
std::string countedInWords(const Technique& technique);
/// Of interval samples: positions, parts, and the bytes a position takes, samples and visibility; empty of others.
std::string countedOfPositions(const FrameRenderer& renderer);

/// "12,345", "0.25", with the unit.
std::string inWords(const TechniqueStatistic& figure);

/// What --json writes: everything needed to draw the frame again, its times and its memory.
/// `sceneName` is the scene's as on the command line.
std::string manifest(const FrameRenderer& renderer, Technique& technique, const std::string& sceneName,
                     const Scene& scene, const std::string& backEnd, const std::vector<gl::PassTimer::Reading>& times);

/// "NVIDIA ... (4.5)" or the same with "SOFTWARE RENDERER" in front.
std::string deviceLine(const gl::DeviceInfo& device);

/// "12.3 MiB".
std::string inMebibytes(std::size_t bytes);

}  // namespace timeshade
