#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plan/frame_request.h"

namespace timeshade {

/// What a picture on the screen is, as it was drawn: whatever has been set since, figures beside it are these.
struct ShownPicture {
    int number = 0;         ///< of the picture; 0 while there is none
    FrameRequest drawn;     ///< size, samples and map as drawn
    bool preview = false;   ///< drawn with less than was asked for
    std::string technique;  ///< "tsm"
    std::string label;      ///< "TSM (bias 2), 8 spp", "Accumulation, 64 renders"
    int instants = 1;       ///< renders of the technique: of brute force the sample count
    int rendersDone = 0, renders = 1;
    std::optional<double> instant;  ///< u, where it is of one instant
    bool cached = false;            ///< something of the frame before was used again
    double milliseconds = 0.0;      ///< median of the frames that were drawn alike; 0 while there is none
    double newest = 0.0;            ///< of this one
    std::vector<double> settings;   ///< of the technique
    std::vector<double> moment;     ///< what the camera saw and when, as momentKeyOf

    bool complete() const { return rendersDone == renders; }
};

}  // namespace timeshade
