// The sample pass against the definition of a camera sample, in double and by brute force: which triangle does the ray
// of (pixel, k) meet first, with everything as it is at the sample's own time?
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scene_catalogue.h"
#include "shared/sample_pattern.shared.h"
#include "support/gl_environment.h"
#include "support/moving_scene.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

using glm::dvec3;

struct Ray {
    dvec3 eye, direction;  ///< the direction's length is 1 along the view's axis
    double u = 0.0;
};

Ray rayOf(const FramePlan& plan, unsigned x, unsigned y, unsigned k) {
    const glm::vec3 pattern = shared::cameraSample({x, y}, k, plan.block.seed, plan.block.pixelCentres);
    Ray ray;
    ray.u = static_cast<double>(shared::sampleTime(plan.block.timeBase, plan.block.timeScale, k, pattern.z));
    const double s = (x + static_cast<double>(pattern.x)) / plan.request.width,
                 t = (y + static_cast<double>(pattern.y)) / plan.request.height;
    const ViewEnd &a = plan.camera.open, &b = plan.camera.close;
    ray.eye = glm::mix(a.eye, b.eye, ray.u);
    ray.direction = glm::mix(a.corner + s * a.right + t * a.up, b.corner + s * b.right + t * b.up, ray.u);
    return ray;
}

struct Hit {
    double distance = 1e300;
    double margin = -1e300;  ///< the least barycentric coordinate: negative outside
    bool front = false;
    bool crossed = false;  ///< the ray meets the triangle's plane in front of the eye
};

Hit intersect(const FramePlan& plan, std::uint32_t triangle, const Ray& ray) {
    const glm::u32vec3 index = plan.mesh->topology->triangles[triangle];
    const auto vertex = [&](std::uint32_t i) {
        return glm::mix(plan.mesh->positionsOpen[i], plan.mesh->positionsClose[i], ray.u) - plan.origin - ray.eye;
    };
    const dvec3 a = vertex(index.x), b = vertex(index.y), c = vertex(index.z);
    const dvec3 e(glm::dot(ray.direction, glm::cross(b, c)), glm::dot(ray.direction, glm::cross(c, a)),
                  glm::dot(ray.direction, glm::cross(a, b)));
    const double sum = e.x + e.y + e.z;
    Hit hit;
    if (sum == 0.0) return hit;
    const dvec3 barycentrics = e / sum;
    hit.margin = std::min({barycentrics.x, barycentrics.y, barycentrics.z});
    const dvec3 point = barycentrics.x * a + barycentrics.y * b + barycentrics.z * c;
    hit.distance = glm::dot(point, ray.direction) / glm::dot(ray.direction, ray.direction);
    hit.crossed = hit.distance > 0.0;
    // Counter-clockwise as seen from the eye.
    hit.front = glm::dot(glm::cross(b - a, c - a), ray.direction) < 0.0;
    return hit;
}

struct Tally {
    std::size_t samples = 0, hits = 0, doubtful = 0, wrong = 0;
    std::string firstWrong;
};

/// Relative to a triangle's size: a sample nearer to an edge than this may fall on either side of it in floats.
constexpr double edgeMargin = 1e-5;
/// Relative to the distance: surfaces nearer to each other than this may be seen in either order.
constexpr double depthMargin = 1e-5;

bool visible(const FramePlan& plan, std::uint32_t triangle, const Hit& hit) {
    const Material& material = (*plan.materials)[plan.mesh->topology->triangleMaterials[triangle]];
    return hit.crossed && (hit.front || material.doubleSided);
}

/// A sample is wrong if the triangle named is clearly missed, or something else is clearly in front of it.
void judge(const FramePlan& plan, const Ray& ray, std::uint32_t named, const std::string& where, Tally& tally) {
    const double nearDistance = static_cast<double>(plan.camera.block.nearDistance);
    ++tally.samples;
    bool doubtful = false, wrong = false;
    double named_distance = 1e300;
    if (named != NO_TRIANGLE) {
        ++tally.hits;
        const Hit hit = intersect(plan, named, ray);
        named_distance = hit.distance;
        wrong =
            !visible(plan, named, hit) || hit.margin < -edgeMargin || hit.distance < nearDistance * (1.0 - depthMargin);
        doubtful = hit.margin < edgeMargin;
    }
    for (std::uint32_t other = 0; other < plan.mesh->topology->triangles.size(); ++other) {
        if (other == named) continue;
        const Hit hit = intersect(plan, other, ray);
        if (hit.margin < -edgeMargin || !visible(plan, other, hit)) continue;
        if (hit.distance < nearDistance * (1.0 - depthMargin) || hit.distance > named_distance * (1.0 + depthMargin))
            continue;
        const bool clearly = hit.margin > edgeMargin && hit.distance > nearDistance * (1.0 + depthMargin) &&
                             hit.distance < named_distance * (1.0 - depthMargin);
        wrong = wrong || clearly;
        doubtful = true;
    }
    tally.doubtful += doubtful && !wrong ? 1u : 0u;
    tally.wrong += wrong ? 1u : 0u;
    if (wrong && tally.firstWrong.empty()) tally.firstWrong = where;
}

Tally compare(const FramePlan& plan) {
    FrameRenderer& renderer = sharedRenderer();
    const std::unique_ptr<Technique> technique = makeTechnique("static", renderer.programs());
    renderer.draw(plan, *technique, View::Visibility);
    const std::vector<std::uint32_t> ids = renderer.readSampleIds();
    const auto width = static_cast<unsigned>(plan.request.width), height = static_cast<unsigned>(plan.request.height);
    Tally tally;
    std::size_t at = 0;
    for (unsigned k = 0; k < plan.block.strata; ++k)
        for (unsigned y = 0; y < height; ++y)
            for (unsigned x = 0; x < width; ++x)
                judge(plan, rayOf(plan, x, y, k), ids[at++],
                      "pixel " + std::to_string(x) + ", " + std::to_string(y) + ", stratum " + std::to_string(k),
                      tally);
    return tally;
}

/// 20 ppm: room for one sample in a scene whose floats are worse than the margins allow for, not for a mistake.
void expectTrue(const Tally& tally, double leastShareOfHits) {
    EXPECT_LE(static_cast<double>(tally.wrong), 20e-6 * static_cast<double>(tally.samples))
        << tally.wrong << " of " << tally.samples << " samples are wrong, the first at " << tally.firstWrong;
    // The margins must not swallow the test.
    EXPECT_LT(static_cast<double>(tally.doubtful), 2e-3 * static_cast<double>(tally.samples));
    EXPECT_GT(static_cast<double>(tally.hits), leastShareOfHits * static_cast<double>(tally.samples));
}

Tally compareMoving(const MovingSceneOptions& options, const FrameRequest& request) {
    const std::unique_ptr<ProceduralScene> scene = makeMovingScene(options);
    const FramePlan plan = FramePlanner(*scene).plan(request);
    EXPECT_EQ(plan.camera.turns, options.cameraTurns);
    return compare(plan);
}

TEST(SamplePass, StaticCamera) {
    const Tally tally = compareMoving({.quads = 60, .seed = 11}, ProceduralScene::request(160, 120, 4, 16, 1));
    expectTrue(tally, 0.2);
    EXPECT_LT(tally.hits, tally.samples * 9 / 10) << "too little of the background is seen";
}

TEST(SamplePass, ManyStrataAndAnotherSeed) {
    expectTrue(compareMoving({.quads = 60, .seed = 12}, ProceduralScene::request(50, 40, 32, 16, 77)), 0.2);
}

TEST(SamplePass, TurningCamera) {
    expectTrue(
        compareMoving({.quads = 60, .seed = 13, .cameraTurns = true}, ProceduralScene::request(160, 120, 4, 16, 1)),
        0.2);
}

TEST(SamplePass, PixelCentres) {
    for (const bool turns : {false, true}) {
        FrameRequest request = ProceduralScene::request(160, 120, 4, 16, 1);
        request.pixelCentres = true;
        expectTrue(compareMoving({.quads = 60, .seed = 13, .cameraTurns = turns}, request), 0.2);
    }
}

TEST(SamplePass, TrianglesAroundTheEye) {
    for (const bool turns : {false, true})
        expectTrue(compareMoving({.quads = 60, .seed = 14, .cameraTurns = turns, .aroundTheEye = true},
                                 ProceduralScene::request(120, 90, 4, 16, 5)),
                   0.2);
}

TEST(SamplePass, OneInstant) {
    // As accumulation draws it: every sample at one time.
    const std::unique_ptr<ProceduralScene> scene = makeMovingScene({.quads = 60, .seed = 15});
    const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(200, 150, 4, 16, 1));
    const FramePlan instant = planAtInstant(plan, 3, 7);
    EXPECT_FLOAT_EQ(instant.block.timeBase, 0.5f);
    expectTrue(compare(instant), 0.2);
}

TEST(SamplePass, SmallTrianglesOfARealScene) {
    // Thousands of triangles a few pixels wide: the points among the covers.
    const std::unique_ptr<Scene> scene = openScene("pillars", "");
    FrameRequest request;
    request.width = 48;
    request.height = 36;
    request.samplesPerPixel = 2;
    request.mapSize = 16;
    request.frame = scene->defaults().frame;
    request.shutter = {scene->defaults().framesPerSecond, scene->defaults().shutterLength, ShutterPosition::Start};
    const FramePlan plan = FramePlanner(*scene).plan(request);
    EXPECT_GT(plan.camera.staticTriangles.small.size() + plan.camera.dynamicTriangles.small.size(), 100u);
    expectTrue(compare(plan), 0.2);
}

TEST(SamplePass, TheComparisonFindsMistakes) {
    const std::unique_ptr<ProceduralScene> scene = makeMovingScene({.quads = 60, .seed = 11});
    const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(40, 30, 1, 16, 1));
    Tally nothing, another;
    for (unsigned y = 0; y < 30; ++y) {
        for (unsigned x = 0; x < 40; ++x) {
            const Ray ray = rayOf(plan, x, y, 0);
            judge(plan, ray, NO_TRIANGLE, "", nothing);
            judge(plan, ray, (x + 7 * y) % 120, "", another);
        }
    }
    EXPECT_GT(nothing.wrong, 200u);  // wherever there is something
    EXPECT_LT(nothing.wrong, 1200u);
    EXPECT_GT(another.wrong, 1100u);  // nearly everywhere
}

}  // namespace
}  // namespace timeshade
