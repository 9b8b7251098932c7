// The plan simulates only what a scene calls for, without any effect on pictures: those drawn in sequence with the plan
// and the caches are those drawn alone with --force-dynamic; of techniques that average, those with --no-cache.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/procedural_scene.h"
#include "core/hash.h"
#include "scene_catalogue.h"
#include "support/awkward_numbers.h"
#include "support/drawn_here.h"
#include "support/eventful_scene.h"
#include "support/gl_environment.h"
#include "support/has_setting.h"
#include "support/thorough.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

/// Techniques whose picture depends on the frame alone.
const std::vector<std::string> techniques = [] {
    std::vector<std::string> names;
    gl::ProgramCache programs;
    for (const TechniqueDescription& description : techniqueDescriptions())
        if (makeTechnique(description.name, programs)->settlingFrames() == 0) names.push_back(description.name);
    return names;
}();

/// Two renderers, so that neither disturbs the other's caches.
FrameRenderer& plannedRenderer() { return sharedRenderer(); }
FrameRenderer& forcedRenderer() {
    static FrameRenderer renderer;
    return renderer;
}

struct Difference {
    std::size_t samples = 0, ids = 0, lit = 0;
    std::size_t colours = 0;  ///< pixels that look different though all their samples are alike
    void add(FrameRenderer& a, FrameRenderer& b) {
        const std::vector<std::uint32_t> idsA = a.readSampleIds(), idsB = b.readSampleIds();
        const std::vector<float> litA = a.readVisibility(), litB = b.readVisibility();
        ASSERT_EQ(litA.size(), litB.size());
        for (std::size_t i = 0; i < litA.size(); ++i) {
            ++samples;
            ids += idsA[i] != idsB[i] ? 1u : 0u;
            lit += litA[i] != litB[i] ? 1u : 0u;
        }
        const LinearImage colourA = a.readRadiance(), colourB = b.readRadiance();
        const auto width = static_cast<std::size_t>(colourA.width), height = static_cast<std::size_t>(colourA.height);
        for (std::size_t pixel = 0; pixel < width * height; ++pixel) {
            const std::size_t stored = (height - 1 - pixel / width) * width + pixel % width;  // rows go upwards there
            bool alike = true;
            for (std::size_t i = stored; i < litA.size(); i += width * height)
                alike = alike && idsA[i] == idsB[i] && litA[i] == litB[i];
            const auto* x = &colourA.rgb[3 * pixel];
            colours += alike && !std::equal(x, x + 3, &colourB.rgb[3 * pixel]) ? 1u : 0u;
        }
    }
};

/// Everything dynamic; or, of a technique whose values are averages of its own, and which therefore answers more
/// exactly by what stands still, the same plan with nothing cached.
FramePlan unplanned(const Scene& scene, FrameRequest request, const Technique& technique) {
    if (technique.footprint().isInstantAtPoint())
        request.forceDynamic = true;
    else
        request.useCaches = false;
    return FramePlanner(scene).plan(request);
}

struct Sequence {
    std::unique_ptr<EventfulScene> scene;
    std::unique_ptr<FramePlanner> planner;
    FrameRequest request;
    std::string techniqueName;
    std::unique_ptr<Technique> planned, plain;

    void choose(const std::string& name) {
        techniqueName = name;
        planned = makeTechnique(name, plannedRenderer().programs());
        plain = makeTechnique(name, forcedRenderer().programs());
        if (hasSetting(*planned, "renders")) set("renders", "3");
        if (hasSetting(*planned, "times")) set("times", "16");
    }
    void set(const std::string& key, const std::string& text) {
        setFromText(*planned, key, text);
        setFromText(*plain, key, text);
    }
    void choose(std::uint32_t seed, bool directional) {
        scene = std::make_unique<EventfulScene>(seed, directional);
        planner = std::make_unique<FramePlanner>(*scene);
    }
};

/// A change that a user makes between two frames.
std::string disturb(Sequence& s, AwkwardNumbers& numbers) {
    switch (numbers.below(16)) {
    case 0: s.request.frame = static_cast<double>(numbers.below(EventfulScene::frames)); return "seek";
    case 1: s.request.shutter.length = numbers.oneIn(2) ? 0.0 : 0.6; return "shutter";
    case 2: s.request.width = numbers.oneIn(2) ? 40 : 33; return "size";
    case 3: s.request.mapSize = numbers.oneIn(2) ? MapSize(256) : MapSize(192, 128); return "map";
    case 4: s.request.samplesPerPixel = numbers.oneIn(2) ? 4 : 2; return "spp";
    case 5: s.request.seed = numbers.below(3); return "seed";
    case 6: s.choose(techniques[numbers.below(static_cast<std::uint32_t>(techniques.size()))]); return "technique";
    case 7: s.choose(numbers.word(), numbers.oneIn(4)); return "scene";
    case 8:
        if (hasSetting(*s.planned, "pcf_radius")) s.set("pcf_radius", numbers.oneIn(2) ? "1" : "0");
        if (hasSetting(*s.planned, "dynamic_bias")) s.set("dynamic_bias", std::to_string(numbers.below(3)));
        if (hasSetting(*s.planned, "as_published")) s.set("as_published", numbers.oneIn(3) ? "on" : "off");
        if (hasSetting(*s.planned, "bias")) s.set("bias", numbers.oneIn(2) ? "0.5" : "1.5");
        return "setting";
    case 9: s.request.useCaches = !s.request.useCaches; return "keeping";
    case 10: return "held";  // the same moment again
    default:
        s.request.frame = std::fmod(s.request.frame + 1.0, static_cast<double>(EventfulScene::frames));
        return "next";
    }
}

class PlanOfTechnique : public DrawnHere<std::string> {};

/// Up to 36 sequences of 6 frames for each technique. Where two differ, rounding decided: a texel whose centre lies
/// on an edge, a depth that nearly equals the receiver's.
TEST_P(PlanOfTechnique, RandomSequencesLookAsIfNothingWerePlanned) {
    const std::uint32_t sequences = usualOrAll(4u, 36u);
    constexpr int framesEach = 6;
    Difference difference;
    std::size_t cachedFrames = 0;
    for (std::uint32_t i = 0; i < sequences; ++i) {
        // Not by its place among the techniques, so that a new one changes few sequences.
        AwkwardNumbers numbers(static_cast<std::uint32_t>(Hash().add(GetParam()).add(i).value()));
        Sequence s;
        s.request = ProceduralScene::request(40, 30, 4, 256, 1);
        s.choose(numbers.word(), numbers.oneIn(4));
        s.choose(GetParam());
        std::string story;
        for (int frame = 0; frame < framesEach; ++frame) {
            const FramePlan plan = s.planner->plan(s.request);
            plannedRenderer().draw(plan, *s.planned, View::Final);
            forcedRenderer().draw(unplanned(*s.scene, s.request, *s.plain), *s.plain, View::Final);
            const std::size_t before = difference.lit + difference.ids;
            difference.add(plannedRenderer(), forcedRenderer());
            EXPECT_LE(difference.lit + difference.ids, before + 12)
                << "sequence " << i << ", frame " << frame << ", " << s.techniqueName << ", after" << story;
            cachedFrames += plan.versions.lit != 0 ? 1u : 0u;
            story += " " + disturb(s, numbers);
        }
    }
    EXPECT_GE(cachedFrames, sequences) << "too few frames in which anything could be cached";
    const auto ppm = [&](std::size_t count) {
        return 1e6 * static_cast<double>(count) / static_cast<double>(difference.samples);
    };
    fmt::print("{}: {:.2f} ppm of {} samples see another triangle, {:.2f} another light; cached in {} frames\n",
               GetParam(), ppm(difference.ids), difference.samples, ppm(difference.lit), cachedFrames);
    EXPECT_LE(ppm(difference.ids), 5.0);
    EXPECT_LE(ppm(difference.lit), 5.0);
    EXPECT_EQ(difference.colours, 0u);
}

/// The scenes that come with the program, at up to 20 settings drawn at random: frame, samples, map, shutter, seed,
/// bias. Each frame is drawn three times, so that the caches are used.
TEST_P(PlanOfTechnique, ScenesLookAsIfNothingWerePlanned) {
    AwkwardNumbers numbers(4711);
    const std::vector<std::string> names{"chess", "octopus", "pillars", "cubes", "rising"};
    std::vector<std::unique_ptr<Scene>> scenes;
    for (const std::string& name : names) scenes.push_back(openScene(name, "", {{"cubes.count", "60"}}));
    Difference difference;
    for (int i = 0; i < usualOrAll(3, 20); ++i) {
        Sequence s;
        s.choose(GetParam());
        const Scene& scene = *scenes[static_cast<std::size_t>(i) % scenes.size()];
        s.request = ProceduralScene::request(160, 120, 1 + static_cast<int>(numbers.below(4)),
                                             numbers.oneIn(2) ? 256 : 512, numbers.below(100));
        s.request.shutter = {scene.defaults().framesPerSecond, static_cast<double>(numbers.unit()),
                             ShutterPosition::Start};
        s.request.frame = scene.defaults().frame + static_cast<double>(numbers.below(8));
        if (hasSetting(*s.planned, "bias") && numbers.oneIn(2)) s.set("bias", "1");
        FramePlanner planner(scene);
        for (int again = 0; again < 3; ++again)
            plannedRenderer().draw(planner.plan(s.request), *s.planned, View::Final);
        forcedRenderer().draw(unplanned(scene, s.request, *s.plain), *s.plain, View::Final);
        difference.add(plannedRenderer(), forcedRenderer());
    }
    const auto ppm = [&](std::size_t count) {
        return 1e6 * static_cast<double>(count) / static_cast<double>(difference.samples);
    };
    fmt::print("{}: {:.2f} ppm of {} samples see another triangle, {:.2f} another light\n", GetParam(),
               ppm(difference.ids), difference.samples, ppm(difference.lit));
    EXPECT_LE(ppm(difference.ids), 5.0);
    EXPECT_LE(ppm(difference.lit), 5.0);
    EXPECT_EQ(difference.colours, 0u);
}

INSTANTIATE_TEST_SUITE_P(Techniques, PlanOfTechnique, testing::ValuesIn(techniques),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace timeshade
