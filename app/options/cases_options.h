#pragma once

#include <string>
#include <vector>

#include "options/run_options.h"
#include "plan/map_size.h"
#include "scene_catalogue.h"

namespace timeshade {

/// `timeshade cases`: techniques on the analytic cases.
struct CasesOptions : RunOptions {
    std::string output;                           ///< F.png of the matrix; empty for none
    std::vector<std::string> measuredTechniques;  ///< empty for all
    SettingTexts settings;                        ///< "tsm.bias", "0.5"
    int samplesPerPixel = 8;
    MapSize mapSize = 512;  ///< of the shadow map
};

}  // namespace timeshade
