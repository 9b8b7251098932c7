// What draws a picture, as text: a command line and a settings file give back the very options that they were made
// from.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "options/command.h"
#include "options_text.h"
#include "scene_catalogue.h"
#include "scenes/scene_recipe.h"
#include "settings_file.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

/// The words that a shell makes of a command.
std::vector<std::string> wordsOf(const std::string& command) {
    std::unique_ptr<FILE, int (*)(FILE*)> shell(
        popen(("for word in " + command + "; do printf '%s\\0' \"$word\"; done").c_str(), "r"), pclose);
    std::vector<std::string> words;
    std::string word;
    for (int c = std::fgetc(shell.get()); c != EOF; c = std::fgetc(shell.get())) {
        if (c != 0) {
            word += static_cast<char>(c);
            continue;
        }
        words.push_back(word);
        word.clear();
    }
    return words;
}

/// Numbers without order, the same in every run.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 1) {}
    double share() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    int below(int count) { return static_cast<int>(share() * count); }
    bool yes() { return below(2) == 1; }

  private:
    std::uint64_t next() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return state_ * 0x2545f4914f6cdd1du;
    }
    std::uint64_t state_;
};

/// Settings anywhere in their ranges, ends included, as the window's sliders leave them.
void changeSettings(HasSettings& owner, Dice& dice, SettingTexts& texts) {
    for (Setting setting : settingsOf(owner)) {
        if (dice.yes()) continue;
        const double share = dice.below(5) == 0 ? dice.below(2) : dice.share();
        setting.set(setting.minimum + share * (setting.maximum - setting.minimum));
        texts.emplace_back(owner.settingsPrefix() + "." + setting.key, textOf(setting));
    }
}

CameraPose randomPose(Dice& dice) {
    const auto number = [&] { return 20.0 * dice.share() - 10.0; };
    CameraPose pose = lookAt({number(), number(), number()}, {number(), number(), number()}, {0.0, 1.0, 0.0},
                             0.1 + 2.0 * dice.share(), 1e-4 + dice.share());
    return pose;
}

/// Light, ground and display, anywhere in their ranges.
void changeLight(PictureOptions& options, Dice& dice) {
    const auto between = [&](double low, double high) { return low + (high - low) * dice.share(); };
    LightChange& light = options.light;
    if (dice.yes()) options.lightName = dice.yes() ? "lamp 2" : "fitted";
    if (dice.yes()) light.direction = LightDirection{between(-360.0, 360.0), between(-90.0, 90.0)};
    if (dice.yes()) light.distance = between(1e-6, 100.0);
    if (dice.yes()) light.cone = between(LightChange::leastCone, LightChange::mostCone);
    if (dice.yes()) light.intensity = between(0.0, 1e5);
    if (dice.yes()) light.move = {between(-9.0, 9.0), between(-9.0, 9.0), between(-1e9, 1e9)};
    if (dice.yes()) light.turn = between(-360.0, 360.0);
    if (dice.yes()) light.rise = between(-360.0, 360.0);
    options.ground.choice = static_cast<GroundChoice>(dice.below(3));
    if (dice.yes()) options.ground.height = between(-100.0, 100.0);
    if (dice.yes()) options.ground.size = between(1e-3, 1e3);
    if (dice.yes()) options.look.exposure = between(DisplayLook::leastExposure, DisplayLook::mostExposure);
    options.look.toneMap = static_cast<ToneMap>(dice.below(3));
}

PictureOptions randomState(int seed) {
    Dice dice(static_cast<std::uint64_t>(seed) + 1);
    gl::ProgramCache programs;
    PictureOptions options;
    const std::vector<BuiltInScene>& scenes = builtInScenes();
    const std::array<std::string, 3> files{"/models/it's \"here\".glb", "a b/$HOME;ls.gltf", "models/--weird=name.glb"};
    options.scene = dice.below(4) == 0 ? files[std::size_t(dice.below(3))]
                                       : scenes[std::size_t(dice.below(int(scenes.size())))].name;
    options.technique = techniqueDescriptions()[std::size_t(dice.below(int(techniqueDescriptions().size())))].name;
    const std::unique_ptr<Technique> technique = makeTechnique(options.technique, programs);
    changeSettings(*technique, dice, options.settings);
    if (const std::unique_ptr<SceneRecipe> recipe = makeRecipe(options.scene))
        changeSettings(*recipe, dice, options.settings);
    options.width = 1 + dice.below(2000);
    options.height = 1 + dice.below(2000);
    options.samplesPerPixel = 1 + dice.below(32);
    options.mapSize = 16 + dice.below(8000);
    if (dice.yes()) options.mapSize.height = 16 + dice.below(8000);
    options.seed = static_cast<unsigned>(dice.share() * 4294967295.0);
    options.frame = dice.yes() ? dice.below(100) - 50 : 1000.0 * dice.share() - 500.0;
    options.framesPerSecond = 0.1 + 100.0 * dice.share();
    options.shutterLength = 16.0 * dice.share();
    options.shutterPosition = static_cast<ShutterPosition>(dice.below(3));
    options.shutterResponse = static_cast<ShutterResponse>(dice.below(3));
    if (options.shutterResponse == ShutterResponse::Gaussian && dice.yes())
        options.shutterWidth = Shutter::leastWidth + dice.share() * (Shutter::mostWidth - Shutter::leastWidth);
    if (dice.yes()) options.motionSteps = 1 << dice.below(6);
    if (dice.below(4) == 0) options.instant = dice.share();
    if (dice.yes()) options.camera = dice.yes() ? "knight" : "Camera of 'Ann' & \"Bob\"";
    if (dice.yes()) options.pose = randomPose(dice);
    if (dice.below(4) == 0) options.view = View::Visibility;
    options.forceDynamic = dice.below(4) == 0;
    options.noCache = dice.below(4) == 0;
    options.pixelCentres = dice.below(4) == 0;
    options.looping = static_cast<Looping>(dice.below(3));
    if (dice.below(3) == 0) {
        options.compared = {"tsm:bias=2", "ranges"};
        options.compareMode = static_cast<CompareMode>(dice.below(3));
        options.seam = dice.share();
    }
    changeLight(options, dice);
    return options;
}

void expectSamePicture(const PictureOptions& a, const PictureOptions& b) {
    EXPECT_EQ(a.scene, b.scene);
    EXPECT_EQ(a.technique, b.technique);
    EXPECT_EQ(a.camera, b.camera);
    EXPECT_EQ(std::tie(a.width, a.height, a.samplesPerPixel, a.mapSize, a.seed),
              std::tie(b.width, b.height, b.samplesPerPixel, b.mapSize, b.seed));
    EXPECT_EQ(std::tie(a.frame, a.instant, a.framesPerSecond, a.shutterLength, a.shutterPosition),
              std::tie(b.frame, b.instant, b.framesPerSecond, b.shutterLength, b.shutterPosition));
    EXPECT_EQ(std::tie(a.shutterResponse, a.shutterWidth), std::tie(b.shutterResponse, b.shutterWidth));
    EXPECT_EQ(a.motionSteps, b.motionSteps);
    EXPECT_EQ(std::tie(a.forceDynamic, a.noCache, a.pixelCentres, a.looping),
              std::tie(b.forceDynamic, b.noCache, b.pixelCentres, b.looping));
    EXPECT_EQ(std::tie(a.view, a.techniqueView, a.compared, a.compareMode, a.seam),
              std::tie(b.view, b.techniqueView, b.compared, b.compareMode, b.seam));
    EXPECT_EQ(a.lightName, b.lightName);
    EXPECT_EQ(a.light, b.light);
    EXPECT_EQ(a.ground, b.ground);
    EXPECT_EQ(a.look, b.look);
    ASSERT_EQ(a.pose.has_value(), b.pose.has_value());
    if (a.pose) {
        EXPECT_EQ(a.pose->eye, b.pose->eye);
        EXPECT_EQ(a.pose->axes, b.pose->axes);
        EXPECT_EQ(a.pose->verticalFieldOfView, b.pose->verticalFieldOfView);
        EXPECT_EQ(a.pose->nearDistance, b.pose->nearDistance);
    }
    // What counts of settings is what they make of their owners.
    const auto valuesOf = [](const PictureOptions& options) {
        gl::ProgramCache programs;
        std::vector<double> values;
        const std::unique_ptr<Technique> technique = makeTechnique(options.technique, programs);
        const std::unique_ptr<SceneRecipe> recipe = makeRecipe(options.scene);
        for (HasSettings* owner : std::initializer_list<HasSettings*>{technique.get(), recipe.get()}) {
            if (owner == nullptr) continue;
            for (const auto& [name, value] : options.settings)
                if (name.starts_with(owner->settingsPrefix() + "."))
                    setFromText(*owner, name.substr(name.find('.') + 1), value);
            for (const Setting& setting : settingsOf(*owner)) values.push_back(setting.get());
        }
        return values;
    };
    EXPECT_EQ(valuesOf(a), valuesOf(b));
}

TEST(OptionsText, FiftyRandomStatesComeBackFromTheirCommandLines) {
    for (int seed = 0; seed < 50; ++seed) {
        const PictureOptions state = randomState(seed);
        const std::string command = shotCommand(state, "a picture.png");
        SCOPED_TRACE(command);
        std::vector<std::string> words = wordsOf(command);
        ASSERT_GT(words.size(), 2u);
        EXPECT_EQ(words.front(), "timeshade");
        words.erase(words.begin());
        const ShotOptions read = std::get<ShotOptions>(parseArguments(words));
        EXPECT_EQ(read.output, "a picture.png");
        expectSamePicture(state, read);
    }
}

TEST(OptionsText, AndFromTheirSettingsFiles) {
    for (int seed = 0; seed < 50; ++seed) {
        const PictureOptions state = randomState(seed);
        const std::string json = settingsJson(state, R"({"panels": true})");
        SCOPED_TRACE(json);
        expectSamePicture(state, std::get<ViewOptions>(parseWithSettings({"view"}, settingsOfJson(json, "s.json"))));
    }
}

TEST(OptionsText, OldNamesOfTheYardsticksAreRead) {
    const ShotOptions none = std::get<ShotOptions>(parseArguments({"shot", "chess", "-o", "F.png"}));
    EXPECT_FALSE(none.forceDynamic || none.noCache);
    for (const auto& [dynamic, cache] : {std::pair("force-dynamic", "no-cache"), std::pair("no-plan", "no-keep")}) {
        const ShotOptions typed = std::get<ShotOptions>(
            parseArguments({"shot", "chess", "-o", "F.png", "--" + std::string(dynamic), "--" + std::string(cache)}));
        EXPECT_TRUE(typed.forceDynamic && typed.noCache) << dynamic;
        const std::string json = std::string("{\"") + dynamic + "\": true, \"" + cache + "\": true}";
        const ViewOptions read = std::get<ViewOptions>(parseWithSettings({"view"}, settingsOfJson(json, "s.json")));
        EXPECT_TRUE(read.forceDynamic && read.noCache) << json;
        EXPECT_EQ(settingsJson(read, ""), settingsJson(typed, "")) << json;
    }
}

TEST(OptionsText, EveryFloatSettingSurvives) {
    gl::ProgramCache programs;
    const std::unique_ptr<Technique> technique = makeTechnique("tsm", programs);
    Dice dice(7);
    Setting bias = settingsOf(*technique).front();
    for (int i = 0; i < 20000; ++i) {
        bias.set(bias.minimum + dice.share() * (bias.maximum - bias.minimum));
        const double before = bias.get();
        setFromText(*technique, bias.key, textOf(bias));
        ASSERT_EQ(settingsOf(*technique).front().get(), before);
    }
}

TEST(OptionsText, PosesThatAreNoneAreRefused) {
    const std::string good = textOf(CameraPose{});
    EXPECT_EQ(poseFromText(good).axes, CameraPose{}.axes);
    for (const std::string& bad :
         {std::string(), std::string("1,2,3"), good + ",1", good + ",", "nan" + good.substr(1), good.substr(2),
          " " + good, std::string("0,0,0,1,0,0,0,1,0,0,0,-1,0.8,0.01"), std::string("0,0,0,2,0,0,0,1,0,0,0,1,0.8,0.01"),
          std::string("0,0,0,1,0,0,0,1,0,0,0,1,0,0.01"), std::string("0,0,0,1,0,0,0,1,0,0,0,1,0.8,0")})
        EXPECT_THROW(poseFromText(bad), UsageError) << bad;
}

}  // namespace
}  // namespace timeshade
