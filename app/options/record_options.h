#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options/picture_options.h"
#include "options/run_options.h"
#include "record/video_codec.h"

namespace timeshade {

/// `timeshade record`: a video, or a folder of pictures.
struct RecordOptions : PictureOptions, RunOptions {
    std::string output;                  ///< a video, by its ending (containerOf()), or a folder
    std::optional<int> frames;           ///< one turn of the scene's motion where not given
    std::optional<VideoCodec> codec;     ///< the container's usual one where not given
    int quality = 18;                    ///< the encoder's constant rate factor, less is better
    std::string script;                  ///< JSON file of the parts to draw; empty for the options' own scene
    std::vector<std::string> arguments;  ///< what was parsed, "record" first; settings files replaced by what they say
};

}  // namespace timeshade
