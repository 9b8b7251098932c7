#include "core/setting.h"
#include "window/session.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "frame_setup.h"
#include "measure/technique_variant.h"
#include "options_text.h"
#include "scene_catalogue.h"
#include "techniques/registry.h"

namespace timeshade {

Session::Session(const PictureOptions& givenOptions, std::unique_ptr<Scene> firstScene, std::string backEndName)
    : options(givenOptions),
      backEnd(std::move(backEndName)),
      driver(renderer),
      technique(techniqueFor(options, renderer.programs())),
      view(options.view),
      techniqueView(options.techniqueView),
      diagnostic(options.diagnostic) {
    adoptComparison();
    adopt(std::move(firstScene), options.scene);
}

void Session::adopt(std::unique_ptr<Scene> newScene, const std::string& name) {
    FrameOptions ofShutter = options;
    ofShutter.instant.reset();  // kept apart
    const FrameRequest newRequest = requestFor(ofShutter, *newScene);
    instant = options.instant;
    planner.reset();
    scene = std::move(newScene);
    recipe = cachedRecipe(name);
    planner = std::make_unique<FramePlanner>(*scene);
    sceneName = name;
    ++sceneNumber;
    request = newRequest;
    camera.reset();
    if (request.cameraPose) camera.emplace(*request.cameraPose, scene->bounds());
    technique->forget();
    if (comparison.on()) comparison.technique()->forget();
    const bool playing = playback.playing();
    playback.setLoop(scene->duration(), request.shutter.framesPerSecond);
    playback.jump(request.frame);
    playback.play(playing);
    remember(name);
}

void Session::remember(const std::string& name) {
    if (!name.ends_with(".gltf") && !name.ends_with(".glb")) return;
    const std::string path = std::filesystem::absolute(name).lexically_normal().string();
    std::erase(recentScenes, path);
    recentScenes.insert(recentScenes.begin(), path);
    recentScenes.resize(std::min<std::size_t>(recentScenes.size(), 8));
}

SceneRecipe* Session::cachedRecipe(const std::string& name) {
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
        SceneRecipe* computed = cachedRecipe(name);
        std::unique_ptr<Scene> opened = computed != nullptr ? computed->make() : openScene(name, "");
        // The next scene gets its own time, shutter and cameras; what is about the picture stays as it is.
        options.camera.clear();
        options.pose.reset();
        options.clip.clear();
        options.framesPerSecond.reset();
        options.shutterLength.reset();
        keepPicture();
        savedViews.clear();
        adopt(std::move(opened), name);
        sceneError.clear();
    } catch (const std::exception& error) {
        sceneError = error.what();
    }
}

void Session::keepPicture() {
    options.frame.reset();
    options.seconds.reset();
    options.samplesPerPixel = request.samplesPerPixel;
    options.mapSize = request.mapSize;
    options.seed = request.seed;
    options.instant = instant;
    options.shutterPosition = request.shutter.position;
}

void Session::openClip(const std::string& name) {
    try {
        std::unique_ptr<Scene> opened = openScene(sceneName, name);
        options.camera.clear();
        options.pose.reset();
        options.clip = name;
        options.framesPerSecond = request.shutter.framesPerSecond;
        options.shutterLength = request.shutter.length;
        keepPicture();
        // The same scene, seen from where it was; only its time is another.
        const std::optional<OrbitCamera> held = camera;
        const std::size_t cameraIndex = request.cameraIndex;
        adopt(std::move(opened), sceneName);
        camera = held;
        request.cameraIndex = std::min(cameraIndex, scene->cameras().size() - 1);
        sceneError.clear();
    } catch (const std::exception& error) {
        sceneError = error.what();
    }
}

void Session::reloadShaders() {
    shaderLog = renderer.reloadShaders();
    for (const std::string& complaint : comparison.reloadShaders())
        if (std::find(shaderLog.begin(), shaderLog.end(), complaint) == shaderLog.end()) shaderLog.push_back(complaint);
    ++shaderNumber;
    technique->forget();
    if (shaderLog.empty()) notify("Shaders loaded anew");
}

void Session::become(const PictureOptions& wanted) {
    std::unique_ptr<Scene> opened = openScene(wanted.scene, wanted.clip, wanted.settings);
    requestFor(wanted, *opened);  // throws for a camera that is not there
    std::unique_ptr<Technique> made = techniqueFor(wanted, renderer.programs());
    options = wanted;
    technique = std::move(made);
    statistics_.clear();
    cachedSettings.clear();
    recipe = nullptr;
    recipes_.clear();
    view = options.view;
    techniqueView = options.techniqueView;
    diagnostic = options.diagnostic;
    savedViews.clear();
    adopt(std::move(opened), options.scene);
    adoptComparison();
    sceneError.clear();
}

void Session::adoptComparison() {
    comparison.choose(nullptr);
    comparison.mode = options.compareMode;
    comparison.seam = options.seam;
    comparison.flip = false;
    if (options.compared.size() != 2) return;
    technique = TechniqueVariant::of(options.compared[0]).make(options.settings, renderer.programs());
    techniqueChanged();
    comparison.choose(TechniqueVariant::of(options.compared[1]).make(options.settings, renderer.programs()));
}

void Session::compareWished() {
    if (wishedPin) {
        comparison.choose(TechniqueVariant::of(variantOf(*technique)).make({}, renderer.programs()));
    } else if (wishedComparison) {
        std::unique_ptr<Technique> second;
        if (!wishedComparison->empty()) {
            TechniqueOptions chosen = options;
            chosen.technique = *wishedComparison;
            second = techniqueFor(chosen, renderer.programs());
        }
        comparison.choose(std::move(second));
    }
    if (wishedSwap) comparison.swap(*this);
    if (comparison.on()) {
        diagnostic = Diagnostic::None;
        techniqueView.clear();
    }
    wishedPin = wishedSwap = false;
    wishedComparison.reset();
}

void Session::addCachedSettings(SettingTexts& settings) {
    // Those that were never touched in this window are still as the options say.
    const auto taken = [&](const std::string& name) {
        return std::any_of(settings.begin(), settings.end(), [&](const auto& s) { return s.first == name; });
    };
    const auto isOf = [](const std::string& name, const std::string& owner) { return name.starts_with(owner + "."); };
    SettingTexts others;
    for (const auto& [name, values] : cachedSettings) {
        if (name == technique->description().name) continue;
        const std::unique_ptr<Technique> other = makeTechnique(name, renderer.programs());
        std::vector<Setting> all = settingsOf(*other);
        for (std::size_t i = 0; i < std::min(all.size(), values.size()); ++i) {
            all[i].set(values[i]);
            others.emplace_back(name + "." + all[i].key, textOf(all[i]));
        }
    }
    for (const auto& [name, other] : recipes_)
        if (other && other.get() != recipe)
            for (const Setting& setting : settingsOf(*other))
                others.emplace_back(name + "." + setting.key, textOf(setting));
    for (const auto& [name, value] : options.settings) {
        const bool shown =
            isOf(name, technique->description().name) || (recipe != nullptr && isOf(name, recipe->settingsPrefix()));
        const bool newer = std::any_of(others.begin(), others.end(), [&](const auto& s) { return s.first == name; });
        if (!shown && !newer && !taken(name)) settings.emplace_back(name, value);
    }
    settings.insert(settings.end(), others.begin(), others.end());
}

void Session::chooseWished(const std::string& name) {
    if (name == technique->description().name) return;
    std::vector<double>& kept = cachedSettings[technique->description().name];
    kept.clear();
    for (const Setting& setting : settingsOf(*technique)) kept.push_back(setting.get());
    TechniqueOptions chosen = options;
    chosen.technique = name;
    technique = techniqueFor(chosen, renderer.programs());
    statistics_.clear();
    const auto known = cachedSettings.find(name);
    if (known == cachedSettings.end()) return;
    std::vector<Setting> settings = settingsOf(*technique);
    for (std::size_t i = 0; i < std::min(settings.size(), known->second.size()); ++i) settings[i].set(known->second[i]);
}

void Session::applyWishes() {
    if (wishedScene)
        openWished(*wishedScene);
    else if (wishedClip)
        openClip(*wishedClip);
    else if (wishedRebuild)
        rebuild();
    if (wishedTechnique) chooseWished(*wishedTechnique);
    compareWished();
    wishedScene.reset();
    wishedClip.reset();
    wishedRebuild = false;
    wishedTechnique.reset();
}

void Session::advance(double newNow) {
    // A picture that was asked for is that of the frame shown when it was.
    if (!wishedScreenshot && instant && playback.playing()) {
        const double seconds = std::max(request.shutter.closeSeconds(0.0) - request.shutter.openSeconds(0.0), 1e-6);
        *instant = std::fmod(*instant + (newNow - now) * playback.speed() / seconds, 1.0);
    } else if (!wishedScreenshot) {
        playback.advance(newNow - now);
    }
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
    const FrameRequest drawn = instant ? atInstant(request, *instant) : request;
    return {planner.get(),
            technique.get(),
            sceneNumber,
            drawn,
            view,
            techniqueView,
            shaderNumber,
            playback.playing() || mouseHeld,
            wishedScreenshot || recording.on(),
            recording.on()};
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

const std::vector<TechniqueStatistic>& Session::statistics() {
    if (driver.state() == FrameDriver::State::Complete && driver.hasPlan() && statisticsOf_ != driver.begun()) {
        statistics_ = technique->statistics();
        statisticsOf_ = driver.begun();
    }
    return statistics_;
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
    const std::string number =
        frame == std::floor(frame) && frame >= 0.0 ? fmt::format("{:04.0f}", frame) : fmt::format("{:g}", frame);
    return fmt::format("timeshade-{}-{}-{}.png", name, technique->description().name, number);
}

}  // namespace timeshade
