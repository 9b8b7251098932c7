#pragma once

#include <string>
#include <vector>

#include "options/compare_options.h"
#include "options/frame_options.h"
#include "options/run_options.h"
#include "options/technique_options.h"

namespace timeshade {

/// `timeshade measure`: accuracy against time.
struct MeasureOptions : FrameOptions, TechniqueOptions, CompareOptions, RunOptions {
    /// Small enough to sweep on a software renderer.
    MeasureOptions() {
        width = 320;
        height = 240;
    }

    std::string output;                                     ///< a folder
    std::vector<std::string> measuredScenes;                ///< empty for all built-in ones that are files
    std::vector<std::string> measuredTechniques;            ///< names or TechniqueVariants; empty for all, and Embree
    std::vector<int> measuredSampleCounts{1, 2, 4, 8, 16};  ///< samples per pixel
    std::vector<MapSize> measuredMaps{512};
    std::vector<int> convergenceFrames;     ///< not empty for the convergence of a still picture instead
    std::string variedSetting;              ///< a computed scene's setting, "cubes.count"; empty for none
    std::vector<std::string> variedValues;  ///< the values that it takes, checked
    std::vector<std::string> equalTime;     ///< TechniqueVariants, two or more, for equal time with the first instead
    std::vector<std::string> equalError;    ///< the same for equal error; at most one of the two is not empty
    bool effects = false;                   ///< what each thing that moves costs instead
    bool times = false;                     ///< what frames take instead, without errors
    int sequenceFrames = 0;                 ///< timed as steady ones in a round; 0 for one alone
    int rounds = 3;                         ///< how often each point is timed, each with a seed of its own
    int referenceSamples = 256;             ///< samples per pixel of the reference
    int referenceRays = 1024;               ///< rays per pixel of the shadow error's reference; 0 for none
};

}  // namespace timeshade
