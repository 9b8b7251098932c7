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
      view(options.view), techniqueView(options.techniqueView) {
    adopt(std::move(firstScene), options.scene);
}

void Session::adopt(std::unique_ptr<Scene> newScene, const std::string& name) {
    const FrameRequest newRequest = requestFor(options, *newScene);
    planner.reset();
    scene = std::move(newScene);
    recipe = keptRecipe(name);
    planner = std::make_unique<FramePlanner>(*scene);
    sceneName = name;
    ++sceneNumber;
    request = newRequest;
    camera.reset();
    technique->forget();
    savedViews.clear();
    const bool playing = playback.playing();
    playback.setLoop(scene->duration(), request.shutter.framesPerSecond);
    playback.jump(request.frame);
    playback.play(playing);
}

SceneRecipe* Session::keptRecipe(const std::string& name) {
    std::unique_ptr<SceneRecipe>& kept = recipes_[name];
    if (!kept) kept = recipeFor(name, options.settings);
    return kept.get();
}

void Session::rebuild() {
    if (recipe == nullptr) return;
    std::unique_ptr<Scene> built = recipe->make();
    planner.reset();
    scene = std::move(built);
    planner = std::make_unique<FramePlanner>(*scene);
    ++sceneNumber;
    playback.setLoop(scene->duration(), request.shutter.framesPerSecond);
}

void Session::openWished(const std::string& name) {
    try {
        SceneRecipe* computed = keptRecipe(name);
        std::unique_ptr<Scene> opened = computed != nullptr ? computed->make() : openScene(name, "");
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
    figures_.clear();
    const auto known = keptSettings.find(name);
    if (known == keptSettings.end()) return;
    std::vector<Setting> settings = settingsOf(*technique);
    for (std::size_t i = 0; i < std::min(settings.size(), known->second.size()); ++i) settings[i].set(known->second[i]);
}

void Session::applyWishes() {
    if (wishedScene)
        openWished(*wishedScene);
    else if (wishedRebuild)
        rebuild();
    if (wishedTechnique) chooseWished(*wishedTechnique);
    wishedScene.reset();
    wishedRebuild = false;
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
    const std::vector<std::string> names = viewNames();
    // Another technique, or another setting of it, may not have the view.
    if (std::find(names.begin(), names.end(), viewName()) == names.end()) techniqueView.clear();
    return {planner.get(), technique.get(), sceneNumber, request, view, techniqueView, playback.playing() || mouseHeld, wishedScreenshot};
}

CameraPose Session::currentPose() const {
    return camera ? camera->pose() : scene->camera(request.cameraIndex, request.shutter.openSeconds(playback.frame()));
}

OrbitCamera& Session::freeCamera() {
    if (!camera) camera.emplace(currentPose(), scene->bounds());
    return *camera;
}

std::vector<std::string> Session::viewNames() const {
    std::vector<std::string> names{"final", "visibility"};
    for (const TechniqueView& own : technique->views()) names.push_back(own.name);
    return names;
}

std::string Session::viewName() const {
    if (!techniqueView.empty()) return techniqueView;
    return view == View::Visibility ? "visibility" : "final";
}

void Session::showView(const std::string& name) {
    diagnostic = Diagnostic::None;
    view = name == "visibility" ? View::Visibility : View::Final;
    techniqueView = name == "final" || name == "visibility" ? "" : name;
}

const std::vector<TechniqueFigure>& Session::figures() {
    if (driver.state() == FrameDriver::State::Complete && driver.hasPlan() && figuresOf_ != driver.begun()) {
        figures_ = technique->figures();
        figuresOf_ = driver.begun();
    }
    return figures_;
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
