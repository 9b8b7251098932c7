#include "options_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "light_text.h"

namespace timeshade {

namespace {

constexpr std::array<const char*, 3> positions{"start", "centre", "end"};
constexpr std::array<const char*, 3> loopings{"auto", "on", "off"};
constexpr std::array<const char*, 3> responses{"box", "tent", "gaussian"};
constexpr std::array<const char*, 3> compareModes{"wipe", "side", "difference"};

std::string viewOf(const PictureOptions& options) {
    if (options.diagnostic != Diagnostic::None)
        return options.diagnostic == Diagnostic::Error ? "error" : "disagreement";
    if (!options.techniqueView.empty()) return options.techniqueView;
    return options.view == View::Visibility ? "visibility" : "final";
}

/// In quotes where a shell would see more than letters in it.
std::string quoted(const std::string& text) {
    const std::string harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/%@";
    if (!text.empty() && text.find_first_not_of(harmless) == std::string::npos) return text;
    std::string inQuotes = "'";
    for (const char c : text) inQuotes += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return inQuotes + "'";
}

/// Numbers and switches as such, so that people can edit the file.
nlohmann::ordered_json valueOf(const std::string& text) {
    // A switch of a file's own words comes as those.
    if (text == "on" || text == "true") return true;
    if (text == "off" || text == "false") return false;
    double number = 0.0;
    const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc{} || rest != text.data() + text.size()) return text;
    nlohmann::ordered_json json = number;
    if (number == std::floor(number) && std::abs(number) < 1e15) json = static_cast<std::int64_t>(number);
    return json;
}

}  // namespace

bool isChanged(const Setting& setting) {
    return setting.get() !=
           (setting.isWhole() ? setting.defaultValue : static_cast<double>(static_cast<float>(setting.defaultValue)));
}

std::string textOf(const CameraPose& pose) {
    std::string text;
    const auto append = [&](double number) { text += (text.empty() ? "" : ",") + fmt::format("{}", number); };
    for (const glm::dvec3& v : {pose.eye, pose.axes[0], pose.axes[1], pose.axes[2]})
        for (int i = 0; i < 3; ++i) append(v[i]);
    append(pose.verticalFieldOfView);
    append(pose.nearDistance);
    return text;
}

CameraPose poseFromText(const std::string& text) {
    const auto refuse = [&] {
        throw UsageError(
            fmt::format("--pose {}: expected 14 numbers with commas: eye, right, up and back (3 each, the axes at "
                        "right angles and of "
                        "length 1), field of view in radians, nearest distance",
                        text));
    };
    std::array<double, 14> numbers{};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto [rest, failure] = std::from_chars(at, end, numbers[i]);
        const bool last = i + 1 == numbers.size();
        if (failure != std::errc{} || !std::isfinite(numbers[i]) || std::abs(numbers[i]) > 1e9 ||
            (last ? rest != end : rest == end || *rest != ','))
            refuse();
        at = rest + 1;
    }
    CameraPose pose;
    pose.eye = {numbers[0], numbers[1], numbers[2]};
    for (int i = 0; i < 3; ++i)
        pose.axes[i] = {numbers[std::size_t(3 + 3 * i)], numbers[std::size_t(4 + 3 * i)],
                        numbers[std::size_t(5 + 3 * i)]};
    pose.verticalFieldOfView = numbers[12];
    pose.nearDistance = numbers[13];
    const glm::dmat3 product = glm::transpose(pose.axes) * pose.axes;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (std::abs(product[i][j] - (i == j ? 1.0 : 0.0)) > 1e-6) refuse();
    if (glm::determinant(pose.axes) < 0.0 || pose.verticalFieldOfView <= 0.0 || pose.verticalFieldOfView >= 3.14159 ||
        pose.nearDistance <= 0.0)
        refuse();
    return pose;
}

std::vector<PictureWord> pictureWords(const PictureOptions& options) {
    const PictureOptions defaults;
    std::vector<PictureWord> words;
    const auto add = [&](const std::string& key, const std::string& value) { words.emplace_back(key, value); };
    if (!options.clip.empty()) add("clip", options.clip);
    add("technique", options.technique);
    add("size", fmt::format("{}x{}", options.width, options.height));
    if (options.samplesPerPixel != defaults.samplesPerPixel) add("spp", fmt::format("{}", options.samplesPerPixel));
    if (options.samples == CameraSamples::Intervals) {
        add("samples", "intervals");
        if (options.timeStrata != defaults.timeStrata) add("time-strata", fmt::format("{}", options.timeStrata));
    }
    if (options.mapSize != defaults.mapSize) add("map", options.mapSize.text());
    if (options.pixelCentres) add("pixel-centres", "on");
    if (options.seed != defaults.seed) add("seed", fmt::format("{}", options.seed));
    if (options.frame) add("frame", fmt::format("{}", *options.frame));
    if (options.seconds) add("time", fmt::format("{}", *options.seconds));
    if (options.framesPerSecond) add("fps", fmt::format("{}", *options.framesPerSecond));
    if (options.looping != defaults.looping) add("loop", loopings[static_cast<std::size_t>(options.looping)]);
    if (options.shutterLength) add("shutter", fmt::format("{}", *options.shutterLength));
    if (options.shutterPosition != defaults.shutterPosition)
        add("shutter-position", positions[static_cast<std::size_t>(options.shutterPosition)]);
    if (options.shutterResponse != defaults.shutterResponse)
        add("shutter-response", responses[static_cast<std::size_t>(options.shutterResponse)]);
    if (options.shutterWidth) add("shutter-width", fmt::format("{}", *options.shutterWidth));
    if (options.motionSteps != defaults.motionSteps) add("motion-steps", fmt::format("{}", options.motionSteps));
    if (options.instant) add("instant", fmt::format("{}", *options.instant));
    if (!options.camera.empty()) add("camera", options.camera);
    if (options.pose) add("pose", textOf(*options.pose));
    addLightWords(options, words);
    if (viewOf(options) != "final") add("view", viewOf(options));
    if (options.compared.size() == 2) {
        add("compare", options.compared[0] + "," + options.compared[1]);
        if (options.compareMode != defaults.compareMode)
            add("compare-mode", compareModes[static_cast<std::size_t>(options.compareMode)]);
        if (options.seam != defaults.seam) add("seam", fmt::format("{}", options.seam));
        if (options.compareGain != defaults.compareGain) add("compare-gain", fmt::format("{}", options.compareGain));
    }
    if (options.forceDynamic) add("force-dynamic", "on");
    if (options.noCache) add("no-cache", "on");
    return words;
}

std::string shotCommand(const PictureOptions& options, const std::string& output) {
    std::string command = "timeshade shot " + quoted("--scene=" + options.scene);
    for (const auto& [key, value] : pictureWords(options)) command += " " + quoted("--" + key + "=" + value);
    for (const auto& [key, value] : options.settings) command += " --set " + quoted(key + "=" + value);
    return command + " -o " + quoted(output);
}

std::string settingsJson(const PictureOptions& options, const std::string& windowState) {
    nlohmann::ordered_json json;
    json["scene"] = options.scene;
    for (const auto& [key, value] : pictureWords(options)) {
        const bool plain = key == "spp" || (key == "map" && options.mapSize.isSquare()) || key == "seed" ||
                           key == "frame" || key == "time" || key == "fps" || key == "shutter" ||
                           key == "shutter-width" || key == "seam" || key == "compare-gain" || key == "instant" ||
                           key == "force-dynamic" || key == "no-cache" || key == "motion-steps" ||
                           key == "pixel-centres" || key == "time-strata" || isNumberOfLight(key);
        json[key] = plain ? valueOf(value) : nlohmann::ordered_json(value);
    }
    for (const auto& [key, value] : options.settings) json["set"][key] = valueOf(value);
    if (!windowState.empty()) json["window"] = nlohmann::ordered_json::parse(windowState);
    return json.dump(2) + "\n";
}

}  // namespace timeshade
