// Every shader that any frame is drawn with, in every variant, is handed to an independent compiler, glslang:
// drivers forgive much that the language does not allow.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>

#include "cases/changed_scene.h"
#include "shader_validator.h"
#include "support/cutout_scene.h"
#include "support/gl_environment.h"
#include "support/moving_scene.h"
#include "support/no_drawing.h"
#include "support/striped_technique.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

namespace fs = std::filesystem;

/// Of a choice, every value; of a number, its least and the one after it: more is more of the same.
std::vector<double> variedValues(const Setting& setting) {
    std::vector<double> values;
    for (double value = setting.minimum; value <= setting.maximum; value += 1.0)
        if (setting.isChoice() || value <= setting.minimum + 1.0) values.push_back(value);
    return values;
}

/// Every combination of a technique's switches, with each of its choices and whole numbers of few values varied in turn
/// (the others at their defaults), or all together where that makes few. All other settings are uniforms; the number of
/// renders is the least, since it changes no shader.
void forEveryCombination(Technique& technique, const std::function<void()>& draw) {
    std::vector<Setting> switches, numbers;
    std::size_t together = 1;
    for (Setting& setting : settingsOf(technique)) {
        if (setting.isSwitch() || (setting.isWhole() && setting.maximum - setting.minimum <= 8.0)) {
            (setting.isSwitch() ? switches : numbers).push_back(setting);
            together *= variedValues(setting).size();
        } else if (setting.key == "renders") {
            setting.set(2.0);
        }
    }
    const auto vary = [](std::vector<Setting>& settings, const std::function<void()>& then) {
        const std::function<void(std::size_t)> from = [&](std::size_t index) {
            if (index == settings.size()) return then();
            for (const double value : variedValues(settings[index])) {
                settings[index].set(value);
                from(index + 1);
            }
        };
        from(0);
    };
    vary(switches, [&] {
        if (together <= 48) return vary(numbers, draw);
        for (Setting& number : numbers) {
            std::vector<Setting> alone{number};
            vary(alone, draw);
            number.set(number.defaultValue);
        }
    });
}

/// Two frames in a row, for a technique with a history.
void drawNextFrame(FrameRenderer& renderer, FramePlanner& planner, const std::string& name) {
    const std::unique_ptr<Technique> technique = makeTechnique(name, renderer.programs());
    FrameRequest request = ProceduralScene::request(16, 12, 2, 16, 1);
    for (; request.frame < 2.0; request.frame += 1.0) renderer.draw(planner.plan(request), *technique, View::Final);
}

/// Frames with a static camera: beside something dynamic, with and without the sample pass's cache, and where nothing
/// moves.
void drawStaticCamera(FrameRenderer& renderer, const ProceduralScene& scene, const std::string& name) {
    FramePlanner planner(scene);
    FrameRequest request = ProceduralScene::request(16, 12, 2, 16, 1);
    request.cameraPose = scene.cameraOpen;
    for (const double shutter : {1.0, 0.0})
        for (const bool keeps : {true, false}) {
            const std::unique_ptr<Technique> technique = makeTechnique(name, renderer.programs());
            request.shutter.length = shutter;
            request.useCaches = keeps;
            for (int frame = 0; frame < 5; ++frame) {
                request.frame = shutter > 0.0 ? frame : 0.0;
                renderer.draw(planner.plan(request), *technique, View::Visibility);
            }
        }
}

/// A frame that is drawn again, with static triangles: the cached part of a lookup, and the part that is tested anew.
void drawOntoCached() {
    FrameRenderer& renderer = sharedRenderer();
    for (const bool directional : {false, true}) {
        ProceduralScene scene;
        scene.quads = {slidingQuad({0, 0, 0}, {0, 0, 0}, 4, -4, 4),
                       slidingQuad({0, 0, 2}, {0.3, 0, 2}, 0.5, -0.5, 0.5)};
        scene.lightOpen.kind = directional ? LightKind::Directional : LightKind::Spot;
        scene.lightOpen.position = {0, 0, 10};
        scene.lightClose = scene.lightOpen;
        scene.cameraOpen = scene.cameraClose = lookAt({2, -9, 7}, {0, 0, 0}, {0, 0, 1}, 0.7, 0.01);
        scene.finish();
        FramePlanner planner(scene);
        const FramePlan plan = planner.plan(ProceduralScene::request(16, 12, 2, 16, 1));
        ASSERT_NE(plan.versions.lit, 0u);
        for (const TechniqueDescription& description : techniqueDescriptions()) {
            const std::unique_ptr<Technique> technique = makeTechnique(description.name, renderer.programs());
            forEveryCombination(*technique, [&] {
                for (int again = 0; again < 3; ++again) renderer.draw(plan, *technique, View::Visibility);
            });
            if (technique->warmUpFrames() > 0) drawStaticCamera(renderer, scene, description.name);
        }
    }
}

/// Interval samples with what moves before the camera and without, by every technique that has them.
void drawIntervalSamples(FrameRenderer& renderer, FramePlanner& planner, Technique& technique) {
    if (technique.hasOwnLookup() || technique.renders() > 1) return;
    FrameRequest request = ProceduralScene::request(16, 12, 2, 16, 1);
    request.samples = CameraSamples::Intervals;
    for (const View view : {View::Final, View::Visibility}) {
        renderer.draw(planner.plan(request), technique, view);
        renderer.readPicture();
    }
}

/// What shading reads of vertices beside: colours, and more texture coordinates.
void drawLooks(FrameRenderer& renderer, Technique& technique, bool turns) {
    const std::shared_ptr<const Scene> plain = makeMovingScene({.quads = 1, .cameraTurns = turns});
    for (const bool colours : {false, true})
        for (const bool coordinates : {false, true}) {
            const ChangedScene scene(plain, {}, [&](MotionMesh mesh) {
                auto topology = std::make_shared<MeshTopology>(*mesh.topology);
                if (colours) topology->colours.resize(topology->vertexCount, glm::vec4(0.5f));
                if (coordinates) topology->moreCoordinates.resize(topology->vertexCount, glm::vec4(0.5f));
                mesh.topology = topology;
                return mesh;
            });
            FrameRequest request = ProceduralScene::request(16, 12, 2, 16, 1);
            for (const CameraSamples samples : {CameraSamples::Strata, CameraSamples::Intervals}) {
                request.samples = samples;
                FramePlan plan = FramePlanner(scene).plan(request);
                if (!technique.unsupported(plan)) renderer.draw(std::move(plan), technique, View::Final);
            }
        }
}

/// Materials that are cut out by their alpha, by every technique and its published form.
void drawCutouts(FrameRenderer& renderer) {
    for (const bool sun : {false, true}) {
        const std::unique_ptr<Scene> scene = makeCutoutScene({.sun = sun, .cameraMoves = sun});
        const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(16, 12, 2, 16, 1));
        ASSERT_NE(plan.cutouts, nullptr);
        FrameRequest request = plan.request;
        request.samples = CameraSamples::Intervals;
        request.cameraPose = belowTheCards();
        const FramePlan solved = FramePlanner(*scene).plan(request);
        for (const TechniqueDescription& description : techniqueDescriptions()) {
            const std::unique_ptr<Technique> technique = makeTechnique(description.name, renderer.programs());
            std::vector<Setting> settings = settingsOf(*technique);
            std::erase_if(settings, [](const Setting& setting) { return !setting.isSwitch(); });
            settings.insert(settings.begin(), Setting{});  // none of them changed
            for (std::size_t i = 0; i < settings.size(); ++i) {
                if (sun && i > 0 && settings[i].key != "as_published") continue;  // a sun makes no other difference
                if (i > 0) settings[i].set(1.0 - settings[i].get());
                if (!technique->unsupported(plan)) {
                    renderer.draw(plan, *technique, View::Visibility);
                    if (technique->solvesIntervals() && !sun) renderer.draw(solved, *technique, View::Visibility);
                    if (i == 0 && !sun)
                        for (const TechniqueView& view : technique->views())
                            renderer.draw(plan, *technique, View::Final, view.name);
                }
                if (i > 0) settings[i].set(1.0 - settings[i].get());
            }
        }
    }
}

/// What a device has counted decides about some programs: with nothing drawn, lists are empty.
void drawOnce() {
    FrameRenderer& renderer = sharedRenderer();
    const std::unique_ptr<ProceduralScene> scene = makeMovingScene({.quads = 8, .seed = 3});
    const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(16, 12, 2, 16, 1));
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        const std::unique_ptr<Technique> technique = makeTechnique(description.name, renderer.programs());
        renderer.draw(plan, *technique, View::Visibility);
        for (Setting& setting : settingsOf(*technique)) {
            if (setting.key != "as_published") continue;
            setting.set(1.0);
            renderer.draw(plan, *technique, View::Visibility);
        }
    }
}

/// Draws every case that makes a difference to a shader, on the shared renderer.
void drawEverything() {
    FrameRenderer& renderer = sharedRenderer();
    drawCutouts(renderer);
    StripedTechnique striped;  // a view, whether or not any technique has one
    renderer.draw(FramePlanner(*makeMovingScene({.quads = 1})).plan(ProceduralScene::request(16, 12, 1, 16, 1)),
                  striped, View::Final, "columns");
    renderer.readPicture();
    for (const bool turns : {false, true}) {
        drawLooks(renderer, *makeTechnique(techniqueDescriptions().front().name, renderer.programs()), turns);
        for (const bool directional : {false, true}) {
            const std::unique_ptr<ProceduralScene> scene =
                makeMovingScene({.quads = 8, .seed = 3, .cameraTurns = turns, .directionalLight = directional});
            FramePlanner planner(*scene);
            const FramePlan plan = planner.plan(ProceduralScene::request(16, 12, 2, 16, 1));
            ASSERT_EQ(plan.camera.turns, turns);
            ASSERT_EQ(plan.light.projection == Projection::Orthographic, directional);
            for (const TechniqueDescription& description : techniqueDescriptions()) {
                const std::unique_ptr<Technique> technique = makeTechnique(description.name, renderer.programs());
                // Where the camera turns under a sun, nothing is compiled that is not met apart.
                if (!turns || !directional) drawIntervalSamples(renderer, planner, *technique);
                forEveryCombination(*technique, [&] {
                    if (technique->unsupported(plan)) return;
                    for (const View view : {View::Final, View::Visibility}) {
                        renderer.draw(plan, *technique, view);
                        renderer.readPicture();
                    }
                    for (const TechniqueView& view : technique->views()) {
                        renderer.draw(plan, *technique, View::Final, view.name);
                        renderer.readPicture();
                    }
                });
                if (technique->warmUpFrames() > 0) drawNextFrame(renderer, planner, description.name);
            }
            FrameRequest tent = ProceduralScene::request(16, 12, 2, 16, 1);
            tent.shutter.response = ShutterResponse::Tent;
            for (const View view : {View::Final, View::Visibility}) renderer.draw(planner.plan(tent), striped, view);
        }
    }
}

std::string nameOf(const gl::ProgramDescription& program) {
    std::string name;
    for (const std::string& stage : program.stages()) name += (name.empty() ? "" : " + ") + stage;
    for (const auto& [define, value] : program.defines) name += " " + define + "=" + value;
    return name;
}

/// Fragment shader (or vertex shader where there is none) and the sets of defines that it was built with.
std::map<std::string, std::set<std::string>> variantsByFile() {
    std::map<std::string, std::set<std::string>> variants;
    for (const gl::ProgramDescription& program : gl::programsBuilt()) {
        std::vector<std::string> defines;
        for (const auto& [define, value] : program.defines)
            if (define != "TECHNIQUE_SETTINGS") defines.push_back(define + "=" + value);  // a block, no variant
        std::sort(defines.begin(), defines.end());
        std::string all;
        for (const std::string& define : defines) all += (all.empty() ? "" : " ") + define;
        for (const std::string& stage : program.stages()) variants[stage].insert(all);
    }
    return variants;
}

TEST(ShaderVariants, TheValidatorIsThereAndRefuses) {
    const std::string good = "#version 450 core\nvoid main() { gl_Position = vec4(1.0); }\n";
    const std::string wrong = "#version 450 core\nvoid main() { gl_Position = vec4(undeclared); }\n";
    const ShaderVerdict verdict = validateShaders({{"vert", good}});
    ASSERT_TRUE(verdict.good) << "glslang refuses what is right: " << verdict.words;
    EXPECT_FALSE(validateShaders({{"vert", wrong}}).good);
    // An input that no earlier stage writes is found only by linking.
    const std::string orphan =
        "#version 450 core\nflat in uint x;\nlayout(location = 0) out uint y;\nvoid main() { y = x; }\n";
    EXPECT_TRUE(validateShaders({{"frag", orphan}}).good);
    const std::string other =
        "#version 450 core\nflat out vec2 x;\nvoid main() { x = vec2(0.0); gl_Position = vec4(1.0); }\n";
    EXPECT_FALSE(validateShaders({{"vert", other}, {"frag", orphan}}).good);
}

void everyProgramOfEveryFrameIsValid() {
    std::set<std::string> checked;
    for (const gl::ProgramDescription& program : gl::programsBuilt()) {
        if (!checked.insert(nameOf(program)).second) continue;
        std::vector<std::pair<std::string, std::string>> stages;
        for (const std::string& path : program.stages())
            stages.emplace_back(fs::path(path).extension().string().substr(1),
                                gl::readShader(path, program.defines).text);
        const ShaderVerdict verdict = validateShaders(stages);
        EXPECT_TRUE(verdict.good) << nameOf(program) << "\n" << verdict.words;
    }
    EXPECT_GE(checked.size(), 40u);
}

void theFramesDrawnHadEveryVariant() {
    const std::map<std::string, std::set<std::string>> variants = variantsByFile();
    const auto has = [&](const std::string& file, const std::string& defines) {
        const auto found = variants.find(file);
        std::ostringstream all;
        if (found != variants.end())
            for (const std::string& one : found->second) all << "  {" << one << "}\n";
        EXPECT_TRUE(found != variants.end() && found->second.count(defines) > 0)
            << file << " {" << defines << "} is missing of\n"
            << all.str();
    };
    const auto joined = [](std::vector<std::string> defines) {
        defines.erase(std::remove(defines.begin(), defines.end(), ""), defines.end());
        std::sort(defines.begin(), defines.end());
        std::string all;
        for (const std::string& define : defines) all += (all.empty() ? "" : " ") + define;
        return all;
    };
    for (const std::string turns : {"", "CAMERA_TURNS=1"}) {
        for (const std::string orthographic : {"", "LIGHT_ORTHOGRAPHIC=1"}) {
            for (const std::string radius : {"0", "1"})
                has("passes/shadow_map_lookup.frag", joined({turns, orthographic, "PCF_RADIUS=" + radius}));
            if (turns.empty())
                has("techniques/exact/lookup.frag", joined({orthographic, "CACHE_STATIC=1", "STATIC_CASTERS_ONLY=1",
                                                            "DYNAMIC_TRIANGLES=1", "STATIC_TRIANGLES=1"}));
            if (orthographic.empty())  // all moves in the spot's frame
                for (const std::string over : {"FOOTPRINT_STRATUM=1", "FOOTPRINT_SHUTTER=1"})
                    has("techniques/integral/lookup.frag", joined({turns, over, "DYNAMIC_TRIANGLES=1", "MOTION=3u"}));
            for (const std::string radius : {"PCF_RADIUS=0", "PCF_RADIUS=1"})
                for (const auto& [bias, times] :
                     {std::pair{"", ""}, {"DYNAMIC_BIAS=1", ""}, {"DYNAMIC_BIAS=1", "BOTH_TIMES=1"}})
                    has("techniques/tsm/lookup.frag",
                        joined({turns, orthographic, bias, times, "DYNAMIC_CASTERS=1", radius}));
            // What the turning camera looks at all moves in the spot's frame.
            const std::string still = turns.empty() || !orthographic.empty() ? "STATIC_CASTERS=1" : "";
            for (const std::string radius : {"PCF_RADIUS=0", "PCF_RADIUS=1"}) {
                has("techniques/tsm/plane_test.frag", joined({turns, orthographic, "DYNAMIC_CASTERS=1", radius}));
                for (const std::string side : {"PATTERN=1", "PATTERN=2"})
                    for (const std::string plane : {"", "PLANE_TEST=1"})
                        has("techniques/interleaved/lookup.frag",
                            joined({turns, orthographic, side, plane, still, "FOOTPRINT_STRATUM=1", "DYNAMIC_CASTERS=1",
                                    radius}));
            }
        }
        for (const std::string view : {"", "VIEW_VISIBILITY=1"})
            for (const std::string weights : {"", "SHUTTER_WEIGHTS=1"})
                has("passes/shade.frag", joined({turns, view, weights}));
        for (const std::string looks : {"VERTEX_COLOURS=1", "MORE_COORDINATES=1"})
            has("passes/shade.frag", joined({turns, looks}));
    }
    for (const std::string cover : {"passes/stochastic_points.vert", "passes/stochastic_rectangles.vert"}) {
        for (const std::string turns : {"", "VIEW_TURNS=1"}) has(cover, joined({"OUTPUT_ID=1", turns}));
        for (const std::string orthographic : {"", "VIEW_ORTHOGRAPHIC=1"})
            for (const std::string output : {"", "OUTPUT_DEPTH_RATE=1", "OUTPUT_DEPTH_VELOCITY=1"})
                has(cover, joined({"VIEW_LIGHT=1", orthographic, output}));
        for (const std::string orthographic : {"", "VIEW_ORTHOGRAPHIC=1"})
            has(cover, joined({"VIEW_LIGHT=1", "OUTPUT_ID=1", orthographic, "TIME_PATTERN=2"}));
    }
    for (const std::string orthographic : {"", "LIGHT_ORTHOGRAPHIC=1"}) has("passes/shadow_map.vert", orthographic);
}

void noShaderFileIsLeftOut() {
    std::set<std::string> used;
    for (const gl::ProgramDescription& program : gl::programsBuilt())
        for (const std::string& path : program.stages())
            for (const std::string& file : gl::readShader(path, program.defines).files) used.insert(file);
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(gl::shaderDirectory())) {
        if (!entry.is_regular_file()) continue;
        const std::string path = fs::relative(entry.path(), gl::shaderDirectory()).string();
        // Shared numerics that no technique needs yet are compiled and run by the parity tests.
        if (path.rfind("shared/", 0) == 0) continue;
        EXPECT_TRUE(used.count(path)) << "shaders/" << path << " is in no program that a frame is drawn with";
    }
}

/// One test, since planning and linking it all is what takes long.
TEST(ShaderVariants, AreValidCompleteAndLeaveNoFileOut) {
    drawOnce();
    {
        const NoDrawing linkingIsEnough;
        drawEverything();
        drawOntoCached();
    }
    everyProgramOfEveryFrameIsValid();
    theFramesDrawnHadEveryVariant();
    noShaderFileIsLeftOut();
}

}  // namespace
}  // namespace timeshade
