// A shadow map that is not square covers what a square one does, in texels that are not square. Where an answer depends
// on the map's columns alone, the number of its rows changes nothing.
#include <algorithm>

#include <gtest/gtest.h>

#include "cases/procedural_scene.h"
#include "support/drawn_here.h"
#include "support/gl_environment.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

struct Form {
    std::string name;
    bool asPublished;
};

bool isPublished(const Setting& setting) { return setting.key == "as_published"; }

/// Every technique in every form whose answers follow from one map that covers the light: not those that draw random
/// times for its texels, nor those that look their own way.
std::vector<Form> forms() {
    std::vector<Form> all;
    gl::ProgramCache programs;
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        const std::unique_ptr<Technique> technique = makeTechnique(description.name, programs);
        if (technique->hasOwnLookup() || technique->samplingTraits().times == SamplingTraits::Times::RandomInStratum)
            continue;
        all.push_back({description.name, false});
        const std::vector<Setting> settings = settingsOf(*technique);
        if (std::any_of(settings.begin(), settings.end(), isPublished)) all.push_back({description.name, true});
    }
    return all;
}

/// Slats that slide across their length, which runs along the map's columns and over all of the floor that is seen; at
/// places that are nowhere near the borders of texels.
std::shared_ptr<ProceduralScene> slats() {
    auto scene = std::make_shared<ProceduralScene>();
    // One triangle: where a floor of two has its diagonal, rounding decides whether one shadows the other without a
    // bias.
    MovingQuad floor{};
    const glm::dvec3 corners[4] = {{-12.0, -6.0, 0.0}, {12.0, -6.0, 0.0}, {0.0, 18.0, 0.0}, {0.0, 18.0, 0.0}};
    for (int i = 0; i < 4; ++i) floor.open[i] = floor.close[i] = corners[i];
    scene->quads.push_back(floor);
    for (int i = -3; i <= 3; ++i) {
        const double x = 0.3137 * i + 0.0419, way = i % 2 == 0 ? 0.2171 : -0.1733;
        scene->quads.push_back(slidingQuad({x, 0.0, 5.0}, {x + way, 0.0, 5.0}, 0.0577, -3.0, 3.0));
    }
    scene->cameraOpen.eye = scene->cameraClose.eye = {0.0, 0.0, 4.5};
    scene->cameraOpen.verticalFieldOfView = scene->cameraClose.verticalFieldOfView = 0.6;
    scene->lightOpen.position = scene->lightClose.position = {0.0, 0.0, 10.0};
    scene->lightOpen.outerConeAngle = scene->lightClose.outerConeAngle = 0.62;
    scene->lightOpen.innerConeAngle = scene->lightClose.innerConeAngle = 0.55;
    scene->finish();
    return scene;
}

std::vector<float> visibilityOf(const Form& form, const MapSize& size) {
    const std::unique_ptr<Technique> technique = makeTechnique(form.name, sharedRenderer().programs());
    if (form.asPublished) setFromText(*technique, "as_published", "on");
    const auto scene = slats();
    sharedRenderer().draw(FramePlanner(*scene).plan(ProceduralScene::request(96, 32, 4, size, 3)), *technique,
                          View::Visibility);
    return sharedRenderer().readVisibility();
}

class MapSizes : public DrawnHere<Form> {};

TEST_P(MapSizes, RowsDoNotMatterWhereColumnsDecide) {
    const std::vector<float> square = visibilityOf(GetParam(), 1024);
    const std::vector<float> narrow = visibilityOf(GetParam(), {1024, 64});
    std::size_t different = 0;
    for (std::size_t i = 0; i < square.size(); ++i) different += square[i] != narrow[i] ? 1u : 0u;
    EXPECT_EQ(different, 0u) << "of " << square.size();
    const auto dark = std::count(square.begin(), square.end(), 0.0f);
    EXPECT_GT(dark, 300);
    EXPECT_LT(dark, static_cast<std::ptrdiff_t>(square.size()) - 300);
}

/// And columns do: that the test above could fail.
TEST_P(MapSizes, ColumnsMatter) {
    if (!makeTechnique(GetParam().name, sharedRenderer().programs())->samplingTraits().texelCentres)
        return;  // no map decides what it says
    EXPECT_FALSE(visibilityOf(GetParam(), 1024) == visibilityOf(GetParam(), {64, 1024}));
}

INSTANTIATE_TEST_SUITE_P(Techniques, MapSizes, testing::ValuesIn(forms()), [](const auto& each) {
    return each.param.name + (each.param.asPublished ? "_published" : "");
});

}  // namespace

}  // namespace timeshade
