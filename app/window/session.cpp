#include "window/session.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "frame_setup.h"
#include "scene/error.h"
#include "scene_catalogue.h"
#include "techniques/registry.h"

namespace timeshade {

Session::Session(const Options& givenOptions, std::unique_ptr<Scene> firstScene, std::string backEndName)
    : options(givenOptions), backEnd(std::move(backEndName)), driver(renderer), technique(techniqueFor(options, renderer.programs())),
      view(options.view) {
    adopt(std::move(firstScene), options.scene);
}

void Session::adopt(std::unique_ptr<Scene> newScene, const std::string& name) {
    const FrameRequest newRequest = requestFor(options, *newScene);
    planner.reset();
    scene = std::move(newScene);
    planner = std::make_unique<FramePlanner>(*scene);
    sceneName = name;
    ++sceneNumber;
    request = newRequest;
    camera.reset();
    savedViews.clear();
    const bool playing = playback.playing();
    playback.setLoop(scene->duration(), request.shutter.framesPerSecond);
    playback.jump(request.frame);
    playback.play(playing);
}

void Session::openWished(const std::string& name) {
    try {
        std::unique_ptr<Scene> opened = openScene(name, "");
        // The next scene gets its own time, shutter and cameras; what is about the picture stays as it is.
        options.camera.clear();
        options.clip.clear();
        options.frame.reset();
        options.seconds.reset();
        options.framesPerSecond.reset();
        options.shutterLength.reset();
        options.samplesPerPixel = request.samplesPerPixel;
        options.mapSize = request.mapSize;
        options.seed = request.seed;
        options.shutterPosition = request.shutter.position;
        adopt(std::move(opened), name);
        sceneError.clear();
    } catch (const std::exception& error) {
        sceneError = error.what();
    }
}

void Session::chooseWished(const std::string& name) {
    if (name == technique->description().name) return;
    std::vector<double>& kept = keptSettings[technique->description().name];
    kept.clear();
    for (const Setting& setting : settingsOf(*technique)) kept.push_back(setting.get());
    Options chosen = options;
    chosen.technique = name;
    technique = techniqueFor(chosen, renderer.programs());
    const auto known = keptSettings.find(name);
    if (known == keptSettings.end()) return;
    std::vector<Setting> settings = settingsOf(*technique);
    for (std::size_t i = 0; i < std::min(settings.size(), known->second.size()); ++i) settings[i].set(known->second[i]);
}

void Session::applyWishes() {
    if (wishedScene) openWished(*wishedScene);
    if (wishedTechnique) chooseWished(*wishedTechnique);
    wishedScene.reset();
    wishedTechnique.reset();
}

void Session::advance(double newNow) {
    // A picture that was asked for is that of the frame shown when it was.
    if (!wishedScreenshot) playback.advance(newNow - now);
    now = newNow;
    if (notice && now > notice->shownUntil) notice.reset();
}

FrameDriver::Wanted Session::wanted(bool mouseHeld) {
    request.frame = playback.frame();
    request.cameraPose.reset();
    if (camera) request.cameraPose = camera->pose();
    return {planner.get(), technique.get(), sceneNumber, request, view, playback.playing() || mouseHeld, wishedScreenshot};
}

CameraPose Session::currentPose() const {
    return camera ? camera->pose() : scene->camera(request.cameraIndex, request.shutter.openSeconds(playback.frame()));
}

OrbitCamera& Session::freeCamera() {
    if (!camera) camera.emplace(currentPose(), scene->bounds());
    return *camera;
}

void Session::useSceneCamera(std::size_t index) {
    camera.reset();
    request.cameraIndex = index;
}

void Session::setShutter(const Shutter& shutter) {
    request.shutter = shutter;
    playback.setLoop(scene->duration(), shutter.framesPerSecond);
}

void Session::notify(std::string text, bool bad) { notice = Notice{std::move(text), bad, now + (bad ? 12.0 : 6.0)}; }

std::string Session::screenshotName() const {
    std::string name = std::filesystem::path(sceneName).stem().string();
    for (char& c : name)
        if (c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20) c = '_';
    const double frame = playback.frame();
    const std::string number = frame == std::floor(frame) && frame >= 0.0 ? fmt::format("{:04.0f}", frame) : fmt::format("{:g}", frame);
    return fmt::format("timeshade-{}-{}-{}.png", name, technique->description().name, number);
}

} // namespace timeshade
