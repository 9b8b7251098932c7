#pragma once

#include <string>

#include "frame/frame_renderer.h"

namespace timeshade {

/// Frames that drawWarmUp draws for this technique.
int warmUpCount(const Technique& technique);

/// Which frames they are, for people; empty where there are none.
std::string warmUpWords(const Technique& technique, const FrameRequest& request);

/// Brings a technique with a history to where it would be in a sequence that arrives at the requested frame: forgets
/// everything, draws the frames before it in order, then the frame itself as often as the technique holds it. The
/// frame's own draw is still to come. So a picture depends on its request alone, wherever a sequence begins. Draws
/// nothing for other techniques.
void drawWarmUp(FrameRenderer& renderer, FramePlanner& planner, Technique& technique, const FrameRequest& request,
                View view);

}  // namespace timeshade
