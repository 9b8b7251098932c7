#include "report.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "frame/warm_up.h"
#include "light_text.h"
#include "measure/map_size_json.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {

std::string deviceLine(const gl::DeviceInfo& device) {
    return fmt::format("{}{} ({})", device.software ? "SOFTWARE RENDERER: " : "", device.renderer, device.version);
}

std::string inMebibytes(std::size_t bytes) {
    return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1024.0 * 1024.0));
}

namespace {

/// How instants count, and whether that makes a difference.
std::string responseWords(const FramePlan& plan, const Technique& technique) {
    const Shutter& shutter = plan.request.shutter;
    std::string words = shutter.response == ShutterResponse::Tent
                            ? "tent: instants count in proportion to their distance from the shutter's nearer end"
                            : fmt::format(
                                  "Gaussian about the shutter's middle, cut at its ends: a standard deviation "
                                  "of {:.4g} of the shutter",
                                  shutter.width);
    if (plan.block.response == SHUTTER_BOX) return words + "; without effect, as nothing moves";
    const bool single = plan.block.wholeStrata == 1 && technique.renders() == 1;
    return words + (single ? "; without effect on one sample a pixel, which is its own mean" : "");
}

}  // namespace

std::vector<PlanLine> explainedLines(const FramePlan& plan, const Technique& technique, const gl::DeviceInfo& device) {
    std::vector<PlanLine> lines{
        {"device", deviceLine(device)},
        {"technique", technique.description().title},
        {"shutter", fmt::format("frame {:g}, open {:g} frames at {:g} frames per second", plan.request.frame,
                                plan.request.shutter.length, plan.request.shutter.framesPerSecond)},
    };
    if (plan.request.shutter.response != ShutterResponse::Box)
        lines.push_back({"response", responseWords(plan, technique)});
    if (const std::string words = inWords(plan.request.light); !words.empty()) lines.push_back({"light", words});
    if (plan.ground)
        lines.push_back({"ground", fmt::format("added at the height {:.4g}, {:.4g} wide", plan.ground->centre.y,
                                               plan.ground->side)});
    if (const std::string words = inWords(plan.request.look); !words.empty()) lines.push_back({"look", words});
    const MotionSummary& motion = plan.motion;
    lines.push_back({"motion", fmt::format("{} of {} meshes move in the light's frame, {} of them turn or deform; "
                                           "known from the frame before: {} of {} triangles",
                                           motion.movingInstances, motion.instances, motion.nonTranslatingInstances,
                                           motion.triangles - motion.reclassified, motion.triangles)});
    if (plan.request.forceDynamic)
        lines.push_back({"force dynamic", "every triangle is treated as dynamic, and nothing is cached"});
    if (plan.request.pixelCentres)
        lines.push_back(
            {"samples", "at pixel centres instead of one random place of the pixel each; their times stay"});
    if (const std::string words = warmUpWords(technique, plan.request); !words.empty())
        lines.push_back({"first", words});
    const auto add = [&](const PassDecision& pass) {
        lines.push_back(
            {pass.name,
             (pass.triangles > 0 ? fmt::format("{} of {} triangles: ", pass.triangles, plan.motion.triangles) : "") +
                 pass.reason});
    };
    for (const PassDecision& pass : plan.passes) add(pass);
    for (const PassDecision& pass : technique.passes(plan)) add(pass);
    if (const auto reason = technique.unsupported(plan)) lines.push_back({"unsupported", *reason});
    for (const std::string& warning : plan.warnings) lines.push_back({"warning", warning});
    for (const std::string& warning : technique.warnings(plan)) lines.push_back({"warning", warning});
    return lines;
}

std::string responseInTitle(const Shutter& shutter) {
    switch (shutter.response) {
    case ShutterResponse::Box: break;
    case ShutterResponse::Tent: return ", response tent";
    case ShutterResponse::Gaussian: return fmt::format(", response gaussian of {:.4g}", shutter.width);
    }
    return "";
}

std::string explain(const FramePlan& plan, const Technique& technique, const gl::DeviceInfo& device) {
    std::string text;
    for (const PlanLine& line : explainedLines(plan, technique, device))
        text += fmt::format("{:<15} {}\n", line.word, line.text);
    return text;
}

std::string inWords(const TechniqueStatistic& figure) {
    const double size = std::abs(figure.value);
    const bool whole =
        size < 1e15 && (size >= 1e4 || figure.value == std::floor(figure.value));  // no share of so many matters
    std::string text = whole ? fmt::format("{:.0f}", figure.value) : fmt::format("{:.4g}", figure.value);
    for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(text.size()) - 3; whole && at > (text.front() == '-' ? 1 : 0);
         at -= 3)
        text.insert(static_cast<std::size_t>(at), ",");
    return figure.unit.empty() ? text : text + " " + figure.unit;
}

std::string countedInWords(const Technique& technique) {
    std::string text;
    for (const TechniqueStatistic& figure : technique.statistics()) {
        text += fmt::format("counted         {}: {}\n", figure.name, inWords(figure));
        if (!figure.warning.empty()) text += fmt::format("warning         {}\n", figure.warning);
    }
    return text;
}

std::string countedOfPositions(const FrameRenderer& renderer) {
    if (!renderer.hasIntervalSamples()) return "";
    const FrameRequest& request = renderer.plan().request;
    const double positions = static_cast<double>(request.width) * request.height * request.samplesPerPixel;
    const GpuMemory memory = renderer.memory();
    return fmt::format("counted         positions: {} with {} parts, {:.1f} bytes each\n",
                       inWords({"", positions, "", ""}),
                       inWords({"", static_cast<double>(renderer.partCount()), "", ""}),
                       static_cast<double>(memory.samples + memory.visibility) / positions);
}

namespace {

/// What is other about the light, the ground and the display than in the scene.
void addLight(nlohmann::ordered_json& json, const FrameRequest& request, const Scene& scene) {
    FrameOptions changed;
    changed.light = request.light;
    changed.look = request.look;
    std::vector<std::pair<std::string, std::string>> words;
    addLightWords(changed, words);
    for (const auto& [key, value] : words) json["changed"][key] = value;
    if (scene.chosenLight() < scene.lights().size()) json["light"] = scene.lights()[scene.chosenLight()];
    if (const auto& ground = scene.ground()) json["ground"] = {{"height", ground->centre.y}, {"size", ground->side}};
}

}  // namespace

std::string manifest(const FrameRenderer& renderer, Technique& technique, const std::string& sceneName,
                     const Scene& scene, const std::string& backEnd, const std::vector<gl::PassTimer::Reading>& times) {
    const FrameRequest& request = renderer.plan().request;
    nlohmann::ordered_json json;
    json["timeshade"] = TIMESHADE_VERSION;
    json["scene"] = sceneName;
    for (const SceneParameter& parameter : scene.parameters()) json["scene_settings"][parameter.key] = parameter.value;
    json["technique"] = technique.description().name;
    for (const Setting& setting : settingsOf(technique)) {
        if (setting.isSwitch())
            json["settings"][setting.key] = setting.get() != 0.0;
        else if (setting.isChoice())
            json["settings"][setting.key] = textOf(setting);
        else
            json["settings"][setting.key] = setting.get();
    }
    json["figures"] = nlohmann::ordered_json::array();
    for (const TechniqueStatistic& figure : technique.statistics())
        json["figures"].push_back(
            {{"name", figure.name}, {"value", figure.value}, {"unit", figure.unit}, {"warning", figure.warning}});
    json["spp"] = request.samplesPerPixel;
    if (request.samples == CameraSamples::Intervals) {
        json["samples"] = "intervals";
        json["time_strata"] = request.timeStrata;
        json["parts"] = renderer.partCount();
    }
    json["size"] = {request.width, request.height};
    json["map"] = asJson(request.mapSize);
    json["seed"] = request.seed;
    json["frame"] = request.frame;
    if (request.forceDynamic) json["force_dynamic"] = true;
    if (!request.useCaches) json["caches"] = false;
    if (request.pixelCentres) json["pixel_centres"] = true;
    if (warmUpCount(technique) > 0)
        json["warm_up"] = {{"frames_before", technique.warmUpFrames()}, {"times_held", technique.heldFrames()}};
    json["fps"] = request.shutter.framesPerSecond;
    json["shutter"] = request.shutter.length;
    if (request.motionSteps > 1) json["motion_steps"] = request.motionSteps;
    if (request.looping != Looping::Auto) json["loop"] = request.looping == Looping::On ? "on" : "off";
    if (request.shutter.response == ShutterResponse::Tent) json["shutter_response"] = "tent";
    if (request.shutter.response == ShutterResponse::Gaussian) {
        json["shutter_response"] = "gaussian";
        json["shutter_width"] = request.shutter.width;
    }
    addLight(json, request, scene);
    json["gl"] = {{"back_end", backEnd},
                  {"vendor", renderer.device().vendor},
                  {"renderer", renderer.device().renderer},
                  {"version", renderer.device().version},
                  {"software", renderer.device().software}};
    for (const auto& reading : times) json["milliseconds"][reading.name] = reading.milliseconds;
    json["milliseconds"]["total"] = gl::totalOf(times);
    const GpuMemory memory = renderer.memory();
    json["bytes"] = {{"mesh", memory.mesh},           {"samples", memory.samples}, {"visibility", memory.visibility},
                     {"technique", memory.technique}, {"picture", memory.picture}, {"total", memory.total()}};
    return json.dump(2) + "\n";
}

}  // namespace timeshade
