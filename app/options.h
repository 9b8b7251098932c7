#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/compare_mode.h"
#include "contexts/gl_context.h"
#include "passes/shade_pass.h"
#include "plan/frame_request.h"
#include "record/video_codec.h"
#include "scene/camera.h"

namespace timeshade {

struct FileSetting;

enum class Command { View, Shot, Record, Pictures, Verify, Measure, Cases, List };

/// Pictures of what is wrong with a picture: for `shot` alone.
enum class Diagnostic { None, Error, Disagreement };

/// What the command line (and a settings file) asks for, checked as far as that is possible without a scene or OpenGL.
struct Options {
    Command command = Command::View;
    std::string scene = "chess";
    std::string output;
    std::string technique = "tsm";
    std::vector<std::pair<std::string, std::string>> settings;  ///< "tsm.bias", "0.5"
    std::string camera;              ///< name of one of the scene's cameras; empty for the first
    std::optional<CameraPose> pose;  ///< instead: a camera of one's own, held still
    std::string clip;                ///< name of one of the file's animations; empty for the first
    View view = View::Final;
    Diagnostic diagnostic = Diagnostic::None;
    std::string techniqueView;  ///< name of one of the technique's own views, shown instead of `view`; empty for none
    ContextOptions context;

    int width = 640, height = 480;
    int samplesPerPixel = 8;
    int mapSize = 1024;
    unsigned seed = 1;
    std::optional<double> frame;            ///< the scene's own where not given
    std::optional<double> seconds;          ///< instead of a frame number
    std::optional<double> framesPerSecond;  ///< the scene's own where not given
    std::optional<double> shutterLength;    ///< frames; the scene's own where not given
    std::optional<double> instant;          ///< one instant of the shutter, u in [0, 1], instead of all of it
    ShutterPosition shutterPosition = ShutterPosition::Start;
    std::optional<int> frames;  ///< one where not given; for `record` one turn of the scene's motion

    std::vector<std::string> compared;  ///< two TechniqueVariants to draw in one picture; empty for `technique` alone
    CompareMode compareMode = CompareMode::Wipe;
    double seam = 0.5;  ///< share of a wipe's width that is the first's

    VideoCodec codec = VideoCodec::H264;
    int quality = 18;    ///< record: the encoder's constant rate factor, less is better
    std::string script;  ///< record: JSON file of the parts to draw; empty for the options' own scene

    bool explain = false;
    bool forceDynamic = false, noCache = false;
    std::string json;                             ///< path for a machine-readable report
    std::string dump;                             ///< folder for verify's data
    std::optional<double> maxPpm;                 ///< verify: exit code 3 above it
    int referenceRays = 1024;                     ///< verify: rays a pixel of the shadow error's reference; 0 for none
    std::vector<std::string> measuredScenes;      ///< measure: empty for all built-in ones
    std::vector<std::string> measuredTechniques;  ///< measure: names or TechniqueVariants; empty for all, and Embree
    std::vector<int> measuredSampleCounts{1, 2, 4, 8, 16};  ///< measure: samples per pixel
    std::vector<int> measuredMaps{512};
    std::vector<int> historyFrames;         ///< measure: not empty for the convergence of a still picture instead
    std::string variedSetting;              ///< measure: a computed scene's setting, "cubes.count"; empty for none
    std::vector<std::string> variedValues;  ///< the values that it takes, checked
    bool effects = false;                   ///< measure: what each thing that moves costs instead
    int rounds = 3;                         ///< measure: how often each point is timed, each with a seed of its own
    int referenceSamples = 256;             ///< measure: samples per pixel of the reference
    std::string commandLine;                ///< as typed, for manifests
    std::vector<std::string>
        arguments;  ///< what was parsed: the command's name first, settings files replaced by what they say
    bool listDevices = false;
    bool listAsJson = false;
    bool debugGl = false;
    bool windowVisible = true;
};

/// Reads the command line. Prints help or the version and exits with 0 where asked; throws UsageError otherwise.
Options parseCommandLine(int argumentCount, char** arguments);

/// The same for arguments that begin with the command's name and hold no --settings.
Options parseArguments(const std::vector<std::string>& arguments);

/// The same with settings of files behind the command's name; a wrong one is named with its place.
Options parseWithSettings(const std::vector<std::string>& arguments, const std::vector<FileSetting>& settings);

}  // namespace timeshade
