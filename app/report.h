#pragma once

#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "gl/pass_timer.h"

namespace timeshade {

/// The plan in words: what moves, which passes run, why, and what to beware of.
std::string explain(const FramePlan& plan, const Technique& technique, const gl::DeviceInfo& device);

/// What --json writes: everything needed to draw the frame again, its times and its memory.
std::string manifest(const FrameRenderer& renderer, Technique& technique, const std::string& scene, const std::string& backEnd,
                     const std::vector<gl::PassTimer::Reading>& times);

/// "NVIDIA ... (4.5)" or the same with "SOFTWARE RENDERER" in front.
std::string deviceLine(const gl::DeviceInfo& device);

/// "12.3 MiB".
std::string inMebibytes(std::size_t bytes);

} // namespace timeshade
