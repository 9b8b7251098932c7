#include "window/session.h"

#include <algorithm>
#include <utility>

#include "frame_setup.h"
#include "measure/technique_variant.h"
#include "options_text.h"
#include "scene_catalogue.h"
#include "window/settings_io.h"

namespace timeshade {

Session::Session(const PictureOptions& givenOptions, std::unique_ptr<Scene> firstScene, std::string backEndName)
    : options(givenOptions),
      backEnd(std::move(backEndName)),
      technique(techniqueFor(options, renderer.programs())),
      view{options.view, options.techniqueView, options.diagnostic},
      driver(renderer) {
    compareAsOptions(partnerOf(options));
    show(std::move(firstScene), options.scene);
}

void Session::show(std::unique_ptr<Scene> newScene, const std::string& name) {
    scene.show(std::move(newScene), name, options.settings);
    showMoment(scene.current());
    recentFiles.add(name);
}

/// Time, shutter, sampling and camera as the options say.
void Session::showMoment(const Scene& shown) {
    FrameOptions ofShutter = options;
    ofShutter.instant.reset();  // kept apart
    const FrameRequest first = requestFor(ofShutter, shown);
    moment.begin(first, shown.duration());
    moment.instant = options.instant;
    camera.orbit.reset();
    if (first.cameraPose) camera.orbit.emplace(*first.cameraPose, shown.bounds());
    invalidateAll();
}

void Session::rebuildScene() {
    scene.rebuild();
    invalidateAll();
    moment.playback.setLoop(scene.current().duration(), moment.request.shutter.framesPerSecond);
}

void Session::openScene(const std::string& name) {
    loading.cancel();
    try {
        if (std::unique_ptr<Scene> computed = scene.computed(name, options.settings)) {
            showOther(std::move(computed), name);
            return;
        }
    } catch (const std::exception& error) {
        panels.sceneError = error.what();
        return;
    }
    load(
        name, [name](const LoadingWatch& watch) { return timeshade::openScene(name, SceneChoice{}, {}, watch); },
        [this, name](std::unique_ptr<Scene> opened) { showOther(std::move(opened), name); });
}

void Session::load(const std::string& name, SceneLoading::Load load, std::function<void(std::unique_ptr<Scene>)> then) {
    loading.begin(name, std::move(load));
    whenLoaded_ = std::move(then);
    finishLoading();
}

void Session::finishLoading() {
    try {
        if (std::unique_ptr<Scene> opened = loading.take()) whenLoaded_(std::move(opened));
    } catch (const std::exception& error) {
        panels.sceneError = error.what();
    }
}

void Session::showOther(std::unique_ptr<Scene> opened, const std::string& name) {
    // The next scene gets its own time, shutter and cameras; what is about the picture stays as it is.
    options.camera.clear();
    options.pose.reset();
    options.clip.clear();
    options.lightName.clear();
    options.light = {};
    options.ground = {};
    options.framesPerSecond.reset();
    options.shutterLength.reset();
    keepPicture();
    options.instant.reset();  // it was one of the other scene's shutter
    camera.savedViews.clear();
    show(std::move(opened), name);
    panels.sceneError.clear();
}

void Session::keepPicture() {
    const FrameRequest& request = moment.request;
    options.frame.reset();
    options.seconds.reset();
    options.samples = request.samples;
    options.samplesPerPixel = request.samplesPerPixel;
    options.timeStrata = request.timeStrata;
    options.mapSize = request.mapSize;
    options.seed = request.seed;
    options.pixelCentres = request.pixelCentres;
    options.motionSteps = request.motionSteps;
    options.looping = request.looping;
    options.look = request.look;
    options.instant = moment.instant;
    options.shutterPosition = request.shutter.position;
    setResponse(options, request.shutter);
}

void Session::openChoice(const SceneChoice& choice) {
    load(
        scene.name(),
        [sceneName = scene.name(), choice](const LoadingWatch& watch) {
            return timeshade::openScene(sceneName, choice, {}, watch);
        },
        [this, choice](std::unique_ptr<Scene> opened) { showChoice(std::move(opened), choice); });
}

void Session::showChoice(std::unique_ptr<Scene> opened, const SceneChoice& choice) {
    options.camera.clear();
    options.pose.reset();
    options.clip = choice.clip;
    options.lightName = choice.light;
    options.light = moment.request.light;
    if (opened->light(0.0).kind == LightKind::Directional) {  // what only a spot has
        options.light.distance.reset();
        options.light.cone.reset();
        options.light.move = glm::dvec3(0.0);
    }
    options.framesPerSecond = moment.request.shutter.framesPerSecond;
    options.shutterLength = moment.request.shutter.length;
    keepPicture();
    // The same scene, seen from where it was; only its time is another.
    const std::optional<OrbitCamera> held = camera.orbit;
    const std::size_t cameraIndex = moment.request.cameraIndex;
    const std::string sceneName = scene.name();
    show(std::move(opened), sceneName);
    camera.orbit = held;
    moment.request.cameraIndex = std::min(cameraIndex, scene.current().cameras().size() - 1);
    panels.sceneError.clear();
}

void Session::setGround(const GroundSettings& ground) {
    options.ground = ground;
    if (!scene.setGround(ground)) return;
    invalidateAll();
}

void Session::reloadShaders() {
    std::vector<std::string> log = renderer.reloadShaders();
    for (const std::string& complaint : comparison.reloadShaders())
        if (std::find(log.begin(), log.end(), complaint) == log.end()) log.push_back(complaint);
    shaders.log = std::move(log);
    ++shaders.number;
    if (shaders.log.empty()) notify("Shaders reloaded");
}

void Session::invalidateAll() {
    renderer.invalidateAll();
    comparison.invalidateAll();
}

void Session::become(const PictureOptions& wanted) {
    requireStrata(wanted, "the window");
    std::unique_ptr<Scene> opened = timeshade::openScene(wanted.scene, choiceOf(wanted), wanted.settings);
    showAs(wanted, std::move(opened));
}

void Session::restore(const PictureOptions& wanted) {
    std::unique_ptr<Scene> opened;
    if (!hasScene(wanted)) opened = timeshade::openScene(wanted.scene, choiceOf(wanted), wanted.settings);
    const double frame = moment.playback.frame();
    showAs(wanted, std::move(opened));
    moment.playback.jump(frame);
}

/// Is it the one that is shown, with all of its settings?
bool Session::hasScene(const PictureOptions& wanted) const {
    if (wanted.scene != scene.name() || choiceOf(wanted) != choiceOf(options)) return false;
    if (scene.recipe() == nullptr) return true;
    const std::string prefix = scene.recipe()->settingsPrefix() + ".";
    SettingTexts ours, theirs;
    for (const Setting& setting : settingsOf(*scene.recipe()))
        if (isChanged(setting)) ours.emplace_back(prefix + setting.key, textOf(setting));
    for (const auto& setting : wanted.settings)
        if (setting.first.starts_with(prefix)) theirs.push_back(setting);
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    return ours == theirs;
}

/// `opened`: the scene; null for the one that is shown.
void Session::showAs(const PictureOptions& wanted, std::unique_ptr<Scene> opened) {
    requestFor(wanted, opened ? *opened : scene.current());  // throws for a camera that is not there
    std::unique_ptr<Technique> made = techniqueFor(wanted, renderer.programs());
    Comparison::Partner partner = partnerOf(wanted);
    loading.cancel();
    options = wanted;
    technique.replace(std::move(made));
    technique.forgetSettings();
    view = {options.view, options.techniqueView, options.diagnostic};
    camera.savedViews.clear();
    if (opened) {
        scene.forgetRecipes();
        show(std::move(opened), options.scene);
    } else {
        showMoment(scene.current());
    }
    compareAsOptions(std::move(partner));
    panels.sceneError.clear();
}

Comparison::Partner Session::partnerOf(const PictureOptions& wanted) {
    if (wanted.compared.size() != 2) return {};
    return Comparison::partnerOf(wanted.compared[1], wanted.settings, renderer.programs());
}

void Session::compareAsOptions(Comparison::Partner partner) {
    comparison.choose(std::move(partner));
    comparison.mode = options.compareMode;
    comparison.seam = options.seam;
    comparison.gain = options.compareGain;
    comparison.flip = false;
    if (options.compared.size() == 2)
        technique.replace(TechniqueVariant::of(options.compared[0]).make(options.settings, renderer.programs()));
}

void Session::applyComparison() {
    std::optional<std::string> wanted = requests.comparison;
    if (requests.snapshot) wanted = wholeVariantOf(technique.current());
    if (wanted) {
        try {
            comparison.choose(Comparison::partnerOf(*wanted, options.settings, renderer.programs()));
        } catch (const std::exception& error) {
            notify(error.what(), true);  // as of a file
        }
    }
    if (requests.swap) comparison.swap(*this);
    if (!comparison.on()) return;
    view.diagnostic = Diagnostic::None;
    view.ofTechnique.clear();
}

void Session::addOtherSettings(SettingTexts& settings) {
    const auto has = [](const SettingTexts& texts, const std::string& name) {
        return std::any_of(texts.begin(), texts.end(), [&](const auto& s) { return s.first == name; });
    };
    const auto isOf = [](const std::string& name, const std::string& owner) { return name.starts_with(owner + "."); };
    SettingTexts others = technique.settingsOfOthers(renderer.programs());
    const SettingTexts ofScenes = scene.settingsOfOthers();
    others.insert(others.end(), ofScenes.begin(), ofScenes.end());
    // Those that were never shown in this window are still as the options say.
    const SceneRecipe* recipe = scene.recipe();
    for (const auto& [name, value] : options.settings) {
        const bool shown = isOf(name, technique.name()) || (recipe != nullptr && isOf(name, recipe->settingsPrefix()));
        if (!shown && !has(others, name) && !has(settings, name)) settings.emplace_back(name, value);
    }
    settings.insert(settings.end(), others.begin(), others.end());
}

void Session::applyUndo() {
    if (!requests.undo && !requests.redo) return;
    const std::optional<std::string> text = requests.undo ? undo.undo() : undo.redo();
    if (!text) return notify(requests.undo ? "There is nothing to undo" : "There is nothing to redo");
    try {
        applySettingsText(*this, *text);
    } catch (const std::exception& error) {
        notify(error.what(), true);  // as where a scene's file is gone
    }
    undo.replaceCurrent(settingsText(*this));
}

void Session::keepForUndo() {
    if (!moment.playback.playing() && !loading.on() && !requests.replaces() && !recording.on())
        undo.keep(settingsText(*this));
}

std::optional<double> Session::progress() const {
    const std::optional<double> first = driver.progress(), second = comparison.progress();
    if (!comparison.on()) return first;
    if (first) return 0.5 * *first;
    return second ? std::optional(0.5 + 0.5 * *second) : std::nullopt;
}

void Session::applyRequests() {
    finishLoading();
    applyUndo();
    if (requests.scene)
        openScene(*requests.scene);
    else if (requests.choice)
        openChoice(*requests.choice);
    else if (requests.rebuild)
        rebuildScene();
    if (requests.technique) technique.choose(*requests.technique, options.settings, renderer.programs());
    applyComparison();
    if (requests.reload) reloadShaders();
    if (requests.full) {
        driver.hurry();
        comparison.hurry();
    }
    if (requests.uncached) {
        invalidateAll();
        driver.drawUncached();
        comparison.drawUncached();
    }
    driver.setPreview(panels.preview);
    comparison.setPreview(panels.preview);
    if (requests.forget) {
        technique.current().forget();
        if (comparison.technique() != nullptr) comparison.technique()->forget();
    }
    requests.scene.reset();
    requests.choice.reset();
    if (const auto ground = std::exchange(requests.ground, std::nullopt)) setGround(*ground);
    requests.technique.reset();
    requests.comparison.reset();
    requests.full = requests.uncached = requests.undo = requests.redo = false;
    requests.reload = requests.forget = requests.rebuild = requests.snapshot = requests.swap = false;
}

void Session::advance(double newNow, bool atWork) {
    now = newNow;
    // A picture that was asked for is that of the frame shown when it was.
    if (!atWork && !requests.screenshot) moment.advance(now - playedUntil);
    if (!atWork) playedUntil = now;
    notices.advance(now);
}

FrameRequest Session::askedRequest() const {
    const FrameRequest request = technique.current().asked(moment.request);
    return comparison.technique() != nullptr ? comparison.technique()->asked(request) : request;
}

FrameDriver::Wanted Session::wanted(bool mouseHeld) {
    FrameRequest& request = moment.request;
    request.frame = moment.playback.frame();
    request.cameraPose.reset();
    if (camera.orbit) request.cameraPose = camera.orbit->pose();
    view.keepTo(technique.current());
    const FrameRequest whole = askedRequest();
    const FrameRequest drawn = moment.instant ? atInstant(whole, *moment.instant) : whole;
    return {&scene.planner(),
            &technique.current(),
            scene.number(),
            drawn,
            view.light,
            view.ofTechnique,
            shaders.number,
            moment.playback.playing() || mouseHeld,
            requests.screenshot || recording.on(),
            recording.on(),
            moment.instant};
}

}  // namespace timeshade
