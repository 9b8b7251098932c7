#include "plan/frame_plan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/check.h"
#include "core/error.h"
#include "plan/mesh_texels.h"
#include "plan/path_warnings.h"
#include "plan/planned_light.h"
#include "plan/seen_cutouts.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {

namespace {

ViewPlan planCamera(const Scene& scene, const FrameRequest& request, const glm::dvec3& origin, double open,
                    double close) {
    const auto [first, last] = request.cameraPose ? ShutterEnds<CameraPose>{*request.cameraPose, *request.cameraPose}
                                                  : scene.cameraEnds(request.cameraIndex, open, close);
    const double aspect = static_cast<double>(request.width) / request.height;
    ViewPlan view;
    view.open = viewEndOf(first, origin, aspect);
    view.close = viewEndOf(last, origin, aspect);
    finishView(view, {request.width, request.height}, first.nearDistance, 0.0);
    return view;
}

/// Of the scene's diagonal: a lamp one unit above a ground of 100,000 still sees all of it.
constexpr double spotNearShare = 1e-4 / 128.0;

/// How far a light may turn within a shutter: its direction is interpolated, and near 180 degrees there is none
/// halfway.
constexpr double largestLightTurn = 90.0;

double turnDegrees(const LightPose& open, const LightPose& close) {
    if (open.axes[2] == close.axes[2]) return 0.0;
    return glm::degrees(2.0 * std::asin(std::min(1.0, 0.5 * glm::length(open.axes[2] - close.axes[2]))));
}

/// The axes of the light's map: those in the middle of the shutter; where the light turns, with the third one turned
/// onto the mean direction, to which that of both ends has the same angle.
glm::dmat3 mapAxes(const LightPose& open, const LightPose& middle, const LightPose& close) {
    if (open.axes[2] == close.axes[2]) return middle.axes;
    const glm::dvec3 back = glm::normalize(open.axes[2] + close.axes[2]);
    glm::dvec3 up = middle.axes[1] - back * glm::dot(middle.axes[1], back);
    if (glm::length(up) < 1e-3) up = middle.axes[2] - back * glm::dot(middle.axes[2], back);
    up = glm::normalize(up);
    return {glm::cross(up, back), up, back};
}

/// The way that a sun's light travels, as long as makes its component along the map's axis 1.
glm::dvec3 directionOf(const LightPose& light, const glm::dmat3& axes) {
    if (light.axes[2] == axes[2]) return -light.axes[2];
    return -light.axes[2] / glm::dot(light.axes[2], axes[2]);
}

/// The shadow map of a spot light covers its outer cone, where the spot turns at both ends. Its near plane has to be
/// nearer than any geometry, since what lies before it casts no shadow: a small lamp on a large ground. Stored depth
/// has relative precision, so that this costs none.
ViewPlan planSpotMap(const FramePlan& plan, double sceneDiagonal) {
    const LightPose &open = plan.lightOpen, &close = plan.lightClose;
    constexpr double widest = 1.48;  // radians, as of a cone that stands still
    const double turn = glm::radians(turnDegrees(open, close)), half = open.outerConeAngle + 0.5 * turn;
    if (turn > 0.0 && half > widest)
        throw Error(
            fmt::format("the spot light turns by {:.1f} degrees within the shutter, with a cone of {:.1f} degrees "
                        "from its axis; expected a cone and half of the turn of at most {:.1f} degrees together",
                        glm::degrees(turn), glm::degrees(open.outerConeAngle), glm::degrees(widest)));
    const double side = 2.0 * std::tan(half);
    const glm::dmat3& axes = plan.lightAxes;
    ViewPlan view;
    view.open.eye = open.position - plan.origin;
    view.close.eye = close.position - plan.origin;
    view.open.right = view.close.right = axes[0] * side;
    view.open.up = view.close.up = axes[1] * side;
    view.open.corner = view.close.corner = -axes[2] - 0.5 * side * (axes[0] + axes[1]);
    finishView(view, plan.request.mapSize.sides(), spotNearShare * sceneDiagonal, 0.0);
    return view;
}

/// Bounds of all vertices in the map's axes, along the light's direction at both ends; of what moves while a sun turns,
/// also of the control points between, within whose hull its parabola lies.
Bounds boundsInMap(const FramePlan& plan, const glm::dvec3 (&directions)[2]) {
    const glm::dmat3 mapFromWorld = glm::transpose(plan.lightAxes);
    const auto slanted = [&](const glm::dvec3& position, const glm::dvec3& direction) {
        const glm::dvec3 p = mapFromWorld * (position - plan.origin), d = mapFromWorld * direction;
        return glm::dvec3(p.x + d.x * p.z, p.y + d.y * p.z, p.z);  // d.z is -1
    };
    const bool turns = directions[0] != directions[1];
    const std::vector<glm::dvec3>&open = plan.mesh->positionsOpen, &close = plan.mesh->positionsClose;
    Bounds bounds;
    for (std::size_t v = 0; v < open.size(); ++v) {
        bounds.add(turns ? slanted(open[v], directions[0]) : mapFromWorld * (open[v] - plan.origin));
        bounds.add(turns ? slanted(close[v], directions[1]) : mapFromWorld * (close[v] - plan.origin));
        if (turns) bounds.add(0.5 * (slanted(open[v], directions[1]) + slanted(close[v], directions[0])));
    }
    return bounds;
}

/// The shadow map of a directional light is fitted to all vertices at both ends of the shutter. Where the light turns,
/// its plane stays across the mean direction, and what is projected slants: that keeps map coordinates of what stands
/// still linear in u, and depth linear for all.
ViewPlan planDirectionalMap(const FramePlan& plan) {
    const glm::dmat3& axes = plan.lightAxes;
    const glm::dvec3 directions[2] = {directionOf(plan.lightOpen, axes), directionOf(plan.lightClose, axes)};
    Bounds bounds = boundsInMap(plan, directions);
    const double margin = 1e-3 * std::max(bounds.diagonal(), 1e-9);
    bounds.low -= margin;
    bounds.high += margin;
    // Square texels, so that a bias in texels means one length.
    const double side = std::max(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y);
    const bool turns = directions[0] != directions[1];
    ViewPlan view;
    view.projection = Projection::Orthographic;
    const auto endOf = [&](const glm::dvec3& direction) {
        ViewEnd end;
        end.corner = glm::dvec3(0.0);
        end.right = axes[0] * side;
        end.up = axes[1] * side;
        end.direction = turns ? direction : glm::normalize(glm::cross(end.up, end.right));
        // The corner is where it is on the plane through the origin, and lies upstream on the nearest plane.
        end.eye = axes[0] * bounds.low.x + axes[1] * bounds.low.y - direction * bounds.high.z;
        return end;
    };
    view.open = endOf(directions[0]);
    view.close = endOf(directions[1]);
    finishView(view, plan.request.mapSize.sides(), 0.0, bounds.high.z - bounds.low.z);
    return view;
}

void fillLight(shared::FrameBlock& block, const FramePlan& plan, double exposure) {
    const LightPose& light = plan.lightOpen;
    const double cosOuter = std::cos(light.outerConeAngle);
    const double cosInner = std::max(std::cos(light.innerConeAngle), cosOuter + 1e-4);
    block.lightPositionOpen = glm::vec4(glm::dvec4(plan.lightOpen.position - plan.origin, 0.0));
    block.lightPositionClose = glm::vec4(glm::dvec4(plan.lightClose.position - plan.origin, 0.0));
    block.cameraPositionOpen = glm::vec4(glm::dvec4(plan.camera.open.eye, 0.0));
    block.cameraPositionClose = glm::vec4(glm::dvec4(plan.camera.close.eye, 0.0));
    const bool directional = light.kind == LightKind::Directional;
    const auto direction = [&](const LightPose& end) {
        return directional ? directionOf(end, plan.lightAxes) : -end.axes[2];
    };
    block.lightDirection = glm::vec4(glm::dvec4(direction(plan.lightOpen), directional ? 1.0 : 0.0));
    block.lightDirectionClose = glm::vec4(glm::dvec4(direction(plan.lightClose), directional ? 1.0 : 0.0));
    const double fading = !directional && light.range > 0.0 ? 1.0 / (light.range * light.range) : 0.0;
    block.lightIntensity = glm::vec4(glm::dvec4(light.intensity * exposure, fading));
    // Width of a map texel, of its longer side: at distance 1 from a spot, at any distance from a directional light.
    const double texel = glm::length(plan.light.open.right) / plan.request.mapSize.shorterSide();
    block.lightCone = glm::vec4(glm::dvec4(cosOuter, cosInner, 1.0 / (cosInner - cosOuter), texel));
    block.ambientSky = glm::vec4(0.17f, 0.19f, 0.23f, 0.0f);
    block.ambientGround = glm::vec4(0.07f, 0.06f, 0.05f, 0.0f);
    block.background = glm::vec4(0.045f, 0.052f, 0.065f, 0.0f);
}

/// Counts instances by the strongest motion of any of their triangles.
void countInstances(const FramePlan& plan, MotionSummary& motion) {
    const MeshTopology& topology = *plan.mesh->topology;
    enum : char { isStatic, isMoving, isNonTranslating };
    std::vector<char> motionOf(topology.instanceCount, isStatic);
    for (std::size_t id = 0; id < plan.triangles->size(); ++id) {
        const TriangleMotion& triangle = (*plan.triangles)[id];
        char& instance = motionOf[topology.triangleInstances[id]];
        instance = std::max(instance, static_cast<char>(triangle.nonTranslating ? isNonTranslating
                                                        : triangle.light.moves  ? isMoving
                                                                                : isStatic));
    }
    const auto count = [&](char kind) {
        return static_cast<std::size_t>(std::count(motionOf.begin(), motionOf.end(), kind));
    };
    motion.instances = motionOf.size();
    motion.nonTranslatingInstances = count(isNonTranslating);
    motion.movingInstances = motion.nonTranslatingInstances + count(isMoving);
}

bool lightMoves(const FramePlan& plan) {
    return turnDegrees(plan.lightOpen, plan.lightClose) > 0.0 ||
           (plan.lightOpen.kind == LightKind::Spot && plan.lightOpen.position != plan.lightClose.position);
}

bool cameraMoves(const FramePlan& plan) { return plan.camera.turns || plan.camera.open.eye != plan.camera.close.eye; }

static_assert(static_cast<std::uint32_t>(ShutterResponse::Box) == SHUTTER_BOX &&
              static_cast<std::uint32_t>(ShutterResponse::Tent) == SHUTTER_TENT &&
              static_cast<std::uint32_t>(ShutterResponse::Gaussian) == SHUTTER_GAUSSIAN);

void fillResponse(shared::FrameBlock& block, const Shutter& shutter, bool somethingMoves) {
    block.response = somethingMoves ? static_cast<std::uint32_t>(shutter.response) : SHUTTER_BOX;
    block.responseWidth = block.response == SHUTTER_GAUSSIAN ? static_cast<float>(shutter.width) : 0.0f;
}

/// Where nothing moves all instants are alike: one sample a position is all that there is to see of it.
void fillSamples(shared::FrameBlock& block, const FrameRequest& request, bool somethingMoves) {
    const bool intervals = request.samples == CameraSamples::Intervals && somethingMoves;
    const int strata = intervals ? request.timeStrata : request.samplesPerPixel;
    block.positions = intervals ? static_cast<std::uint32_t>(request.samplesPerPixel) : 0;
    block.timeBase = 0.0f;
    block.timeScale = 1.0f / static_cast<float>(strata);
    block.strata = block.wholeStrata = static_cast<std::uint32_t>(strata);
    block.wholeTimeScale = block.timeScale;
}

MotionSummary summarise(const FramePlan& plan, std::size_t movingTriangles) {
    MotionSummary motion = plan.motion;
    countInstances(plan, motion);
    motion.triangles = plan.mesh->topology->triangles.size();
    motion.movingTriangles = movingTriangles;
    motion.lightTurnDegrees = turnDegrees(plan.lightOpen, plan.lightClose);
    motion.lightMoves = lightMoves(plan);
    motion.cameraMoves = cameraMoves(plan);
    motion.largestTurnDegrees = plan.mesh->largestTurnDegrees;
    return motion;
}

void checkRequest(const FrameRequest& request) {
    for (const int side : {request.width, request.height}) {
        CHECK_GE(side, 1);
        CHECK_LE(side, maximumImageSide);
    }
    CHECK_GE(request.samplesPerPixel, 1);
    CHECK_LE(request.samplesPerPixel, maximumSamplesPerPixel);
    CHECK_GE(request.timeStrata, 1);
    CHECK_LE(request.timeStrata, maximumSamplesPerPixel);
    CHECK_GE(request.mapSize.shorterSide(), 1);
    CHECK_LE(request.mapSize.longerSide(), maximumMapSide);
    CHECK_GE(request.motionSteps, 1);
    CHECK_LE(request.motionSteps, maximumMotionSteps);
    CHECK(std::has_single_bit(static_cast<unsigned>(request.motionSteps)));
    CHECK(request.motionSteps == 1 || request.samples == CameraSamples::Strata);
    CHECK_GT(request.shutter.framesPerSecond, 0.0);
    CHECK_GE(request.shutter.length, 0.0);
    CHECK_GE(request.shutter.width, Shutter::leastWidth);
    CHECK_LE(request.shutter.width, Shutter::mostWidth);
}

std::string lightWords(const MotionSummary& motion) {
    if (motion.lightTurnDegrees > 0.0) return fmt::format("turns by {:.3g} degrees", motion.lightTurnDegrees);
    return motion.lightMoves ? "moves" : "stands still";
}

std::string motionWords(const MotionSummary& motion) {
    return fmt::format("{} of {} triangles move, the light {}, the camera {}", motion.movingTriangles, motion.triangles,
                       lightWords(motion), motion.cameraMoves ? "moves" : "stands still");
}

}  // namespace

ShutterTimes shutterTimes(const Scene& scene, const FrameRequest& request, int piece, int pieces) {
    const double open = request.shutter.openSeconds(request.frame), close = request.shutter.closeSeconds(request.frame);
    // Neighbours share the very same time.
    const auto border = [&](int k) { return k == pieces ? close : open + (close - open) * k / pieces; };
    return loopedTimes(scene, request.looping, {border(piece), border(piece + 1)});
}

FramePlanner::FramePlanner(const Scene& scene)
    : scene_(scene),
      origin_(scene.bounds().centre()),
      exposure_(exposureOf(scene, {})),
      rest_(std::make_shared<const RestPose>(scene)),
      cutouts_(Cutouts::of(scene.materials(), scene.images())) {}

double FramePlanner::exposureFor(const LightChange& change) {
    if (change.direction != placed_.direction || change.distance != placed_.distance)
        exposure_ = exposureOf(scene_, change);
    placed_ = change;
    return exposure_;
}

void FramePlanner::deform(Shape& shape, double openSeconds, double closeSeconds) const {
    if (shape.mesh && openSeconds == shape.openSeconds && closeSeconds == shape.closeSeconds) return;
    shape.mesh = std::make_shared<const MotionMesh>(scene_.motionMesh(openSeconds, closeSeconds));
    shape.texels = std::make_shared<const MeshTexels>(packMesh(*shape.mesh, scene_.materials(), origin_));
    shape.extent = {};
    for (const auto* positions : {&shape.mesh->positionsOpen, &shape.mesh->positionsClose})
        for (const glm::dvec3& position : *positions) shape.extent.add(position - origin_);
    shape.movingTriangles = countMovingTriangles(*shape.mesh);
    shape.inner = scene_.innerMotion(openSeconds, closeSeconds);
    shape.openSeconds = openSeconds;
    shape.closeSeconds = closeSeconds;
}

FramePlan FramePlanner::plan(const FrameRequest& request) {
    checkRequest(request);
    const int steps = motionStepsOf(request);
    shapes_.resize(static_cast<std::size_t>(steps));
    std::vector<FramePlan> pieces;
    for (int piece = 0; piece < steps; ++piece) pieces.push_back(planPiece(request, piece, steps));
    FramePlan plan = steps == 1 ? std::move(pieces.front()) : planOfPieces(request, std::move(pieces));
    if (const std::optional<std::string> lowered = loweredMotionSteps(request)) plan.warnings.push_back(*lowered);
    return plan;
}

FramePlan FramePlanner::planPiece(const FrameRequest& request, int piece, int pieces) {
    const auto [open, close] = shutterTimes(scene_, request, piece, pieces);
    Shape& shape = shapes_[static_cast<std::size_t>(piece)];
    deform(shape, open, close);

    FramePlan plan;
    plan.request = request;
    plan.origin = origin_;
    plan.mesh = shape.mesh;
    plan.texels = shape.texels;
    plan.extent = shape.extent;
    plan.materials = &scene_.materials();
    plan.images = &scene_.images();
    plan.cutouts = cutouts_;
    plan.ground = scene_.ground();
    const PlannedLight light(scene_, request, {open, close}, piece, pieces);
    plan.lightOpen = light.ends().open;
    plan.lightClose = light.ends().close;
    const LightPose middle = light.middle();
    // Rounding, or a spot that rolls about its axis, is no turn.
    if (glm::length(plan.lightOpen.axes[2] - plan.lightClose.axes[2]) < 1e-9)
        plan.lightOpen.axes = plan.lightClose.axes = middle.axes;
    plan.lightAxes = mapAxes(plan.lightOpen, middle, plan.lightClose);
    if (const double turn = turnDegrees(plan.lightOpen, plan.lightClose); turn > largestLightTurn)
        throw Error(
            fmt::format("the light turns by {:.1f} degrees within the shutter; expected at most {:.0f}: shorten "
                        "the shutter",
                        turn, largestLightTurn));
    plan.camera = planCamera(scene_, request, origin_, open, close);
    plan.light = plan.lightOpen.kind == LightKind::Directional ? planDirectionalMap(plan)
                                                               : planSpotMap(plan, scene_.bounds().diagonal());

    fillLight(plan.block, plan, exposureFor(request.light));
    const bool somethingMoves = shape.movingTriangles > 0 || lightMoves(plan) || cameraMoves(plan);
    fillSamples(plan.block, request, somethingMoves);
    plan.block.seed = request.seed;
    plan.block.imageSize = {request.width, request.height};
    plan.block.mapWidth = static_cast<std::uint32_t>(request.mapSize.width);
    plan.block.weight = 1.0f;
    plan.block.pixelCentres = request.pixelCentres ? 1u : 0u;
    fillResponse(plan.block, request.shutter, somethingMoves);

    decideMotion(plan);
    if (plan.block.positions > 0) refuseSeenCutouts(plan);

    plan.motion = summarise(plan, shape.movingTriangles);
    const std::size_t seen = plan.camera.staticTriangles.count() + plan.camera.dynamicTriangles.count();
    plan.passes.push_back(
        {"sample",
         fmt::format("{}; {} triangles face away throughout, {} are never in the picture", motionWords(plan.motion),
                     plan.camera.facingAwayTriangles, plan.camera.outsideTriangles),
         seen});
    plan.pathWarnings = pathWarnings(scene_, plan, shape.inner, {open, close}, light);
    if (const std::optional<PathWarning> bent = bentPathWarning(plan)) plan.pathWarnings.push_back(*bent);
    for (const PathWarning& warning : plan.pathWarnings) plan.warnings.push_back(warning.text);
    return plan;
}

void FramePlanner::decideMotion(FramePlan& plan) {
    const MotionClassifier::Motion motion = memory_.update(plan.texels, {plan.camera, plan.light, plan.block});
    plan.triangles = motion.triangles;
    plan.motion.reclassified = motion.reclassified;
    const bool planned = !plan.request.forceDynamic;
    listTriangles(plan.camera, *plan.triangles, &TriangleMotion::camera, {.dropFacingAway = true, .allMove = !planned});
    // One-sided triangles cast shadows with both sides.
    const ListRules lightRules{.dropUnseenShadows = planned, .allMove = !planned};
    listTriangles(plan.light, *plan.triangles, &TriangleMotion::light, lightRules);
    plan.casters = casterLists(*plan.triangles, lightRules);
    plan.rest = rest_;
    if (!planned || !plan.request.useCaches) return;
    plan.versions = motion.versions;
    const bool lightMoves = plan.block.lightPositionOpen != plan.block.lightPositionClose ||
                            plan.block.lightDirection != plan.block.lightDirectionClose;
    if (plan.camera.staticTriangles.empty()) plan.versions.samples = 0;
    if (plan.versions.samples == 0 || lightMoves) plan.versions.lit = plan.versions.shading = 0;
    if (plan.versions.lit != 0 && !plan.casters.nothingMoves())
        plan.reached = maskOfDynamicCasters(plan.casters, *motion.inMap, plan.request.mapSize.shorterSide());
}

}  // namespace timeshade
