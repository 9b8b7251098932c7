#include "measure/made_with.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "core/error.h"
#include "core/file_bytes.h"
#include "gl/shader_source.h"
#include "measure/reference_digest.h"

namespace timeshade {

namespace {

namespace fs = std::filesystem;

std::string programDigest() {
    ReferenceDigest digest;
    digest.values(readFileBytes("/proc/self/exe"));
    return digest.text();
}

std::string shadersDigest() {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(gl::shaderDirectory()))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    ReferenceDigest digest;
    for (const fs::path& file : files) {
        const std::string name = file.lexically_relative(gl::shaderDirectory()).generic_string();
        digest.bytes(name.data(), name.size() + 1);
        digest.values(readFileBytes(file));
    }
    return digest.text();
}

std::string textOf(const std::optional<CameraPose>& pose) {
    if (!pose) return "the scene's";
    const auto& [eye, axes, fieldOfView, nearDistance] = *pose;
    std::string text = fmt::format("{} {} {} fov {} near {} axes", eye.x, eye.y, eye.z, fieldOfView, nearDistance);
    for (int c = 0; c < 3; ++c) text += fmt::format(" {} {} {}", axes[c].x, axes[c].y, axes[c].z);
    return text;
}

// Taken apart as wholes, so that a field that is added later cannot be left out.

std::string textOf(const Shutter& shutter) {
    const auto& [framesPerSecond, length, position, response, width] = shutter;
    std::string text = fmt::format("{} of {} at {}", length, framesPerSecond, static_cast<int>(position));
    if (response == ShutterResponse::Tent) text += " tent";
    if (response == ShutterResponse::Gaussian) text += fmt::format(" gaussian {}", width);
    return text;
}

std::string textOf(const LightChange& change) {
    if (change == LightChange{}) return "";
    const auto& [direction, distance, cone, intensity, move, turn, rise, heldAt] = change;
    std::string text =
        fmt::format(", light times {} moves {} {} {} turns {} {}", intensity, move.x, move.y, move.z, turn, rise);
    if (direction) text += fmt::format(" from {} {}", direction->azimuth, direction->elevation);
    if (distance) text += fmt::format(" at {}", *distance);
    if (cone) text += fmt::format(" cone {}", *cone);
    if (heldAt) text += fmt::format(" held at {}", *heldAt);
    return text;
}

std::string textOf(const FrameRequest& request) {
    const auto& [width, height, source, samples, timeStrata, map, seed, frame, shutter, steps, looping, camera,
                 forceDynamic, caches, centres, pose, light, look] = request;
    static_cast<void>(look);  // no measurement depends on it
    const std::string intervals =
        source == CameraSamples::Intervals ? fmt::format("intervals in {} strata, ", timeStrata) : "";
    const std::string inSteps = steps == 1 ? "" : fmt::format("in {} steps, ", steps);
    const std::string loop = looping == Looping::Auto ? "" : looping == Looping::On ? "loop on, " : "loop off, ";
    return fmt::format("{} x {}, {}{} spp, map {}, seed {}, frame {}, shutter {}, {}{}camera {}, {}{}{}pose {}{}",
                       width, height, intervals, samples, map.text(), seed, frame, textOf(shutter), inSteps, loop,
                       camera, forceDynamic ? "force dynamic, " : "", caches ? "" : "no cache, ",
                       centres ? "pixel centres, " : "", textOf(pose), textOf(light));
}

}  // namespace

MadeWith madeWithBinary(const std::string& commit) {
    return {{"program", commit + " " + programDigest()}, {"shaders", shadersDigest()}};
}

MadeWith madeWithProgram(const std::string& commit, const gl::DeviceInfo& device) {
    MadeWith parts = madeWithBinary(commit);
    parts.emplace_back("device", device.vendor + ", " + device.renderer + ", " + device.version);
    return parts;
}

MadeWith madeWithScene(const Scene& scene, const FrameRequest& request) {
    const std::string clip = scene.clips().empty() ? "" : scene.clips().at(scene.clip());
    return {{"model", scene.contentDigest()}, {"clip", clip}, {"frame", textOf(request)}};
}

std::string settingsText(Technique& technique) {
    std::string text;
    for (const Setting& setting : settingsOf(technique)) text += fmt::format("{}={} ", setting.key, setting.get());
    return text;
}

std::vector<std::string> differingParts(const MadeWith& a, const MadeWith& b) {
    std::vector<std::string> names;
    const auto add = [&](const MadeWith& one, const MadeWith& other) {
        for (const auto& part : one)
            if (std::find(other.begin(), other.end(), part) == other.end() &&
                std::find(names.begin(), names.end(), part.first) == names.end())
                names.push_back(part.first);
    };
    add(a, b);
    add(b, a);
    return names;
}

}  // namespace timeshade
