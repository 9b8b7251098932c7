#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gl/program_cache.h"
#include "measure/held_scene.h"
#include "plan/frame_request.h"

namespace timeshade {

/// One scene with something left out, or put in: what an effect costs is the difference to the scene as it is.
struct EffectRow {
    std::string effect;                              ///< for people: "unchanged", "light held"
    std::string technique;                           ///< a TechniqueVariant
    std::size_t dynamicCasters = 0, movingSeen = 0;  ///< most of any frame: triangles that move for the light and for
                                                     ///< the camera, as far as they are drawn
    std::vector<std::string> passes;                 ///< of the last frame
    std::map<std::string, double>
        milliseconds;  ///< medians over the frames: "plan", "decide", "sample", "build", "lookup", "shade", "frame"
    std::map<std::string, double> statistics;  ///< of the last frame: entries of lists
    std::size_t bytes = 0;
    double forcedShare = 0.0;  ///< frame time over that of --force-dynamic, medians of the same frames
};

struct EffectOptions {
    std::string technique;              ///< a TechniqueVariant: whose effects are measured
    std::vector<std::string> compared;  ///< TechniqueVariants that play the scene as it is, for what they cost
    int frames = 8;                     ///< of a sequence, the first two of which are not counted
    std::function<void(int done, int total)> progress;
};

/// Plays the scene from the request's frame on, row by row in turn, frame by frame: each row has a renderer of its own,
/// so that each has its own caches, and every program is compiled before the first frame. Times are those of steady
/// frames. Rows: nothing planned; as it is; deformation, objects, light, camera held, each where it moves at all;
/// shutter closed; nothing moves; and the compared techniques.
std::vector<EffectRow> measureEffects(const Scene& scene, const FrameRequest& request, const EffectOptions& options);

/// As a table in Markdown, one line a row.
std::string effectsTable(const std::vector<EffectRow>& rows);

}  // namespace timeshade
