#include "closed_form_cases.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace timeshade {

namespace {

constexpr double outerCone = 0.62;  // radians; covers every receiver below

LightPose lightAt(double x) {
    LightPose light;
    light.position = {x, 0.0, 10.0};  // axes: identity, so that it shines along -z
    light.outerConeAngle = outerCone;
    light.innerConeAngle = 0.9 * outerCone;
    light.intensity = glm::dvec3(100.0);
    return light;
}

/// Looks straight down on the receiver from `height` above it. The picture is a column: narrow in x, so that all
/// pixels have the same answer, and tall in y, along which nothing depends, so that they see many map texels.
CameraPose cameraAbove(const glm::dvec3& receiver, double height) {
    CameraPose camera;
    camera.eye = receiver + glm::dvec3(0.0, 0.0, height);
    camera.verticalFieldOfView = 2.0 * std::atan(0.7);
    camera.nearDistance = 0.01;
    return camera;
}

struct Motion {
    double receiverOpen = 0.0, receiverClose = 0.0;  // x
    double lightOpen = 0.0, lightClose = 0.0;        // x
};

std::shared_ptr<ProceduralScene> setUpC(const std::vector<MovingQuad>& casters, const Motion& motion) {
    auto scene = std::make_shared<ProceduralScene>();
    scene->quads = casters;
    const glm::dvec3 open(motion.receiverOpen, 0.0, 0.0), close(motion.receiverClose, 0.0, 0.0);
    scene->quads.push_back(slidingQuad(open, close, 0.2, -0.8, 0.8));
    scene->cameraOpen = cameraAbove(open, 1.0);
    scene->cameraClose = cameraAbove(close, 1.0);
    scene->lightOpen = lightAt(motion.lightOpen);
    scene->lightClose = lightAt(motion.lightClose);
    scene->finish();
    return scene;
}

/// The quad Q(c) at z = 5, its centre going from c0 to c1.
MovingQuad caster(double c0, double c1) { return slidingQuad({c0, 0.0, 5.0}, {c1, 0.0, 5.0}, 0.5, -0.4, 0.6); }

/// Share of the shutter that a texel of a 1024 map at z = 5 takes to pass the shadow's edge at this speed.
double texelShare(double speed) { return 5.0 * 2.0 * std::tan(outerCone) / 1024.0 / speed; }

ClosedFormCase makeCase(std::string name, double exact, std::shared_ptr<ProceduralScene> scene, double speed, int ends) {
    ClosedFormCase c;
    c.name = std::move(name);
    c.exact = exact;
    c.scene = std::move(scene);
    c.texelShare = speed > 0.0 ? texelShare(speed) : 0.0;
    c.ends = ends;
    return c;
}

/// Row 9: the receiver is the quad itself, which comes straight towards the light.
std::shared_ptr<ProceduralScene> approachingSelf() {
    auto scene = std::make_shared<ProceduralScene>();
    scene->quads.push_back(slidingQuad({0.0, 0.0, 1.0}, {0.0, 0.0, 9.0}, 0.5, -0.4, 0.6));
    scene->cameraOpen = cameraAbove({0.0, 0.1, 1.0}, 0.5);
    scene->cameraClose = cameraAbove({0.0, 0.1, 9.0}, 0.5);
    scene->lightOpen = scene->lightClose = lightAt(0.0);
    scene->finish();
    return scene;
}

std::vector<ClosedFormCase> makeCases() {
    std::vector<ClosedFormCase> cases;
    cases.push_back(makeCase("quad_sweeps_point", 0.6, sweptPointScene(0.0), 2.5, 2));
    cases.back().predictedFailures["static"] = 0.0;  // dark at u = 0.5
    cases.push_back(makeCase("quad_enters", 0.6, setUpC({caster(-1.25, 0.0)}, {}), 1.25, 1));
    cases.back().predictedFailures["static"] = 1.0;
    // The shadow segment's middle moves at half the light's or the receiver's speed of 8.
    cases.push_back(makeCase("light_slides", 0.75, setUpC({caster(0.0, 0.0)}, {0.0, 0.0, -4.0, 4.0}), 4.0, 2));
    cases.back().predictedFailures["static"] = 0.0;
    cases.push_back(makeCase("receiver_slides", 0.75, setUpC({caster(0.0, 0.0)}, {-4.0, 4.0, 0.0, 0.0}), 4.0, 2));
    cases.back().predictedFailures["static"] = 0.0;
    cases.push_back(makeCase("light_and_receiver_slide", 0.75, setUpC({caster(0.0, 0.0)}, {-2.0, 2.0, -2.0, 2.0}), 4.0, 2));
    cases.back().predictedFailures["static"] = 0.0;
    cases.push_back(makeCase("approaching_self", 1.0, approachingSelf(), 0.0, 0));
    cases.back().predictedFailures["tsm"] = 0.5;  // without a bias, whatever the number of strata
    cases.push_back(makeCase("triplicate", 0.6, setUpC({caster(-1.25, 1.25), caster(-1.25, 1.25), caster(-1.25, 1.25)}, {}), 2.5, 2));
    cases.back().predictedFailures["static"] = 0.0;
    cases.push_back(makeCase("static_all", 0.0, setUpC({caster(0.0, 0.0)}, {}), 0.0, 0));
    cases.push_back(makeCase("bullet", 0.9999, setUpC({caster(-5000.0, 5000.0)}, {}), 10000.0, 2));
    cases.back().predictedFailures["static"] = 0.0;
    cases.push_back(makeCase("bucket_border", 0.75, setUpC({caster(-1.5, 2.5)}, {}), 4.0, 2));
    cases.back().undetermined.push_back("static");  // the quad's edge is over the receiver at u = 0.5
    return cases;
}

} // namespace

std::shared_ptr<ProceduralScene> sweptPointScene(double shift) { return setUpC({caster(-1.25 + shift, 1.25 + shift)}, {}); }

const std::vector<ClosedFormCase>& closedFormCases() {
    static const std::vector<ClosedFormCase> cases = makeCases();
    return cases;
}

const ClosedFormCase& closedFormCase(const std::string& name) {
    const auto& cases = closedFormCases();
    const auto found = std::find_if(cases.begin(), cases.end(), [&](const ClosedFormCase& c) { return c.name == name; });
    if (found == cases.end()) throw std::logic_error("no closed-form case " + name);
    return *found;
}

} // namespace timeshade
