#include "window/settings_io.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "frame_setup.h"
#include "image/image_file.h"
#include "options/command.h"
#include "options_text.h"
#include "scene_catalogue.h"
#include "settings_file.h"
#include "techniques/registry.h"
#include "window/session.h"

namespace timeshade {

namespace {

void addChanged(HasSettings& owner, SettingTexts& settings) {
    for (const Setting& setting : settingsOf(owner))
        if (isChanged(setting)) settings.emplace_back(owner.settingsPrefix() + "." + setting.key, textOf(setting));
}

std::string windowState(const Session& session) {
    nlohmann::ordered_json json;
    json["text_size"] = session.panels.textScale;
    json["panels"] = session.panels.visible;
    json["preview"] = nameOf(session.panels.preview);
    json["flip"] = session.comparison.flip;
    const Playback& playback = session.moment.playback;
    json["speed"] = playback.speed();
    json["loop"] = {playback.firstFrame(), playback.lastFrame()};
    for (const SavedView& view : session.camera.savedViews)
        json["views"].push_back({{"name", view.name}, {"pose", textOf(view.camera.pose())}});
    return json.dump();
}

/// What is the window's alone. Values that make no sense are named.
struct WindowState {
    double textScale = 1.0;
    bool panels = true, flip = false;
    PreviewQuality::Choice preview = PreviewQuality::Choice::Automatic;
    double speed = 1.0;
    std::optional<std::pair<int, int>> loop;
    std::vector<std::pair<std::string, CameraPose>> views;
};

bool isPart(const nlohmann::json& value) {
    constexpr int most = 1000000;
    if (!value.is_array() || value.size() != 2) return false;
    for (const nlohmann::json& frame : value)
        if (!frame.is_number_integer() || frame.get<long long>() < 0 || frame.get<long long>() > most) return false;
    return value[0].get<int>() <= value[1].get<int>();
}

WindowState windowStateOf(const std::string& text, const std::string& path) {
    WindowState state;
    const nlohmann::json whole = nlohmann::json::parse(text);
    if (!whole.contains("window")) return state;
    for (const auto& [key, value] : whole["window"].items()) {
        if (key == "text_size" && value.is_number() && value.get<double>() >= 0.75 && value.get<double>() <= 2.5) {
            state.textScale = value.get<double>();
        } else if (key == "panels" && value.is_boolean()) {
            state.panels = value.get<bool>();
        } else if (key == "flip" && value.is_boolean()) {
            state.flip = value.get<bool>();
        } else if (key == "preview" && value.is_string() && previewOf(value.get<std::string>())) {
            state.preview = *previewOf(value.get<std::string>());
        } else if (key == "speed" && value.is_number() && value.get<double>() >= 0.01 && value.get<double>() <= 1.0) {
            state.speed = value.get<double>();
        } else if (key == "loop" && isPart(value)) {
            state.loop = {value[0].get<int>(), value[1].get<int>()};
        } else if (key == "views" && value.is_array()) {
            for (const nlohmann::json& view : value)
                if (view.is_object() && view.contains("name") && view["name"].is_string() && view.contains("pose") &&
                    view["pose"].is_string())
                    state.views.emplace_back(view["name"].get<std::string>(),
                                             poseFromText(view["pose"].get<std::string>()));
        } else {
            throw Error(fmt::format(
                "{}: \"window\" holds \"{}\": {}; expected text_size from 0.75 to 2.5, panels, preview, flip, "
                "speed from 0.01 to 1, loop or views",
                path, key, value.dump()));
        }
    }
    return state;
}

}  // namespace

PictureOptions pictureOptions(Session& session) {
    const FrameRequest& request = session.moment.request;
    PictureOptions options = session.options;
    options.scene = session.scene.name();
    options.technique = session.technique.name();
    options.settings.clear();
    addChanged(session.technique.current(), options.settings);
    if (session.scene.recipe() != nullptr) addChanged(*session.scene.recipe(), options.settings);
    options.width = request.width;
    options.height = request.height;
    options.samples = request.samples;
    options.samplesPerPixel = request.samplesPerPixel;
    options.timeStrata = request.timeStrata;
    options.mapSize = request.mapSize;
    options.seed = request.seed;
    options.pixelCentres = request.pixelCentres;
    options.motionSteps = request.motionSteps;
    options.looping = request.looping;
    options.frame = session.moment.playback.frame();
    options.seconds.reset();
    options.framesPerSecond = request.shutter.framesPerSecond;
    options.shutterLength = request.shutter.length;
    options.instant = session.moment.instant;
    options.shutterPosition = request.shutter.position;
    setResponse(options, request.shutter);
    options.camera = request.cameraIndex == 0 ? "" : session.scene.current().cameras()[request.cameraIndex].name;
    options.light = request.light;
    options.look = request.look;
    options.pose.reset();
    if (session.camera.orbit) options.pose = session.camera.orbit->pose();
    options.view = session.view.light;
    options.techniqueView = session.view.ofTechnique;
    options.diagnostic = session.view.diagnostic;
    options.compared.clear();
    if (session.comparison.on()) {
        options.compared = session.comparison.variants(session);
        // Each of the two says by itself what it is set to.
        std::erase_if(options.settings,
                      [&](const auto& setting) { return setting.first.starts_with(session.technique.name() + "."); });
        options.compareMode = session.comparison.mode;
        options.seam = session.comparison.seam;
        options.compareGain = session.comparison.gain;
        options.techniqueView.clear();
        options.diagnostic = Diagnostic::None;
    }
    return options;
}

std::string commandOf(Session& session) {
    const std::filesystem::path scene(session.scene.name());
    PictureOptions options = pictureOptions(session);
    // A path is meant from where the window was started, and is to hold elsewhere too.
    if (scene.has_extension() && std::filesystem::exists(scene))
        options.scene = std::filesystem::absolute(scene).lexically_normal().string();
    return shotCommand(options, screenshotName(session));
}

namespace {

/// With the settings of others. These are of techniques by their names, and so of the two that are compared, unless
/// those name all of theirs.
PictureOptions savedOptions(Session& session) {
    PictureOptions options = pictureOptions(session);
    session.addOtherSettings(options.settings);
    if (!session.comparison.on()) return options;
    options.compared = {wholeVariantOf(session.technique.current()), session.comparison.wholeVariant()};
    return options;
}

}  // namespace

void saveSettings(Session& session, const std::string& path) {
    PictureOptions options = savedOptions(session);
    const std::string text = settingsJson(options, windowState(session));
    writeFileAtomically(path, text);
}

std::string settingsText(Session& session) {
    PictureOptions options = savedOptions(session);
    // Settings of others come in the order in which they were shown.
    std::sort(options.settings.begin(), options.settings.end());
    const FrameOptions defaults;
    options.width = defaults.width;
    options.height = defaults.height;
    options.frame.reset();
    return settingsJson(options, windowState(session));
}

namespace {

void applyWindowState(Session& session, const WindowState& state) {
    session.panels.textScale = state.textScale;
    session.panels.visible = state.panels;
    session.panels.preview = state.preview;
    session.comparison.flip = state.flip;
    Playback& playback = session.moment.playback;
    playback.setSpeed(state.speed);
    if (state.loop && state.loop->second < playback.loopFrames())
        playback.setPart(state.loop->first, state.loop->second);
    for (const auto& [name, pose] : state.views)
        session.camera.savedViews.push_back({name, OrbitCamera(pose, session.scene.current().bounds())});
}

}  // namespace

void applySettingsText(Session& session, const std::string& text) {
    const std::string name = "undo";
    const WindowState state = windowStateOf(text, name);
    session.restore(std::get<ViewOptions>(parseWithSettings({"view"}, settingsOfJson(text, name))));
    applyWindowState(session, state);
}

void loadSettings(Session& session, const std::string& path) {
    const std::string text = textOfFile(path, "settings");
    const std::vector<FileSetting> settings = settingsOfJson(text, path);
    const WindowState state = windowStateOf(text, path);
    session.become(std::get<ViewOptions>(parseWithSettings({"view"}, settings)));
    applyWindowState(session, state);
}

}  // namespace timeshade
