// The order in which triangles come into a technique's lists decides nothing: reversed or shuffled, every value is the
// same to the last bit.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "support/gl_environment.h"
#include "support/has_setting.h"
#include "support/moving_scene.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

std::vector<float> litOf(const FramePlan& plan, const std::string& name, bool asPublished) {
    const std::unique_ptr<Technique> technique = makeTechnique(name, sharedRenderer().programs());
    if (asPublished) setFromText(*technique, "as_published", "on");
    sharedRenderer().draw(plan, *technique, View::Visibility);
    return sharedRenderer().readVisibility();
}

bool hasPublishedForm(const std::string& name) {
    const std::unique_ptr<Technique> technique = makeTechnique(name, sharedRenderer().programs());
    return hasSetting(*technique, "as_published");
}

TEST(ListOrder, DecidesNothing) {
    const std::unique_ptr<ProceduralScene> scene = makeMovingScene({.quads = 300, .seed = 4});
    FramePlanner planner(*scene);
    FramePlan plan = planner.plan(ProceduralScene::request(48, 36, 4, 96, 4));
    ASSERT_GT(plan.casters.dynamicCasters.size(), 100u);
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        for (const bool asPublished : {false, true}) {
            if (asPublished && !hasPublishedForm(description.name)) continue;
            std::sort(plan.casters.dynamicCasters.begin(), plan.casters.dynamicCasters.end());
            const std::vector<float> ascending = litOf(plan, description.name, asPublished);
            std::reverse(plan.casters.dynamicCasters.begin(), plan.casters.dynamicCasters.end());
            EXPECT_EQ(litOf(plan, description.name, asPublished), ascending)
                << description.name << (asPublished ? " as published" : "") << ", reversed";
            std::shuffle(plan.casters.dynamicCasters.begin(), plan.casters.dynamicCasters.end(), std::mt19937(3));
            EXPECT_EQ(litOf(plan, description.name, asPublished), ascending)
                << description.name << (asPublished ? " as published" : "") << ", shuffled";
        }
    }
}

}  // namespace
}  // namespace timeshade
