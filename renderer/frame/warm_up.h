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

/// Leaves nothing in any cache of the renderer and the technique, and no history: the next frame is drawn as the first
/// of a sequence. Programs stay compiled.
void emptyCaches(FrameRenderer& renderer, Technique& technique);

/// Draws what a sequence that arrives at the requested frame would meet: a frame with nothing cached, the one in which
/// caches fill or the frames of a warm-up, and one that uses them. So every program that such frames need is compiled,
/// by us and by the driver, and every buffer is there. Of brute force some renders of each. What is drawn and its times
/// are dropped.
void drawVariants(FrameRenderer& renderer, FramePlanner& planner, Technique& technique, const FrameRequest& request,
                  View view, const std::string& techniqueView = {});

}  // namespace timeshade
