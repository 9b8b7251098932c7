#include "plan/path_warnings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>

#include <fmt/format.h>

#include "core/parallel.h"
#include "plan/mesh_texels.h"

namespace timeshade {

namespace {

constexpr double threshold = 0.5;  // pixels, and texels of the shadow map
constexpr double turnWorthNaming = 15.0;

/// A view at one instant: from positions relative to the plan's origin to places in the image.
class Projector {
  public:
    Projector(const ViewPlan& view, const ViewEnd& end)
        : perspective_(view.projection == Projection::Perspective),
          nearest_(static_cast<double>(view.block.nearDistance)),
          size_(view.block.size),
          from_(perspective_ ? end.eye : end.eye + end.corner),
          imageFromWorld_(glm::inverse(glm::dmat3(end.right, end.up, perspective_ ? end.corner : end.direction))) {}

    /// In pixels or texels; nothing where the point is not in front of the view.
    std::optional<glm::dvec2> operator()(const glm::dvec3& position) const {
        const glm::dvec3 p = imageFromWorld_ * (position - from_);
        if (!perspective_) return glm::dvec2(p) * size_;
        if (p.z <= nearest_) return std::nullopt;
        return glm::dvec2(p) / p.z * size_;
    }
    const glm::dvec2& size() const { return size_; }

  private:
    bool perspective_;
    double nearest_;
    glm::dvec2 size_;
    glm::dvec3 from_;
    glm::dmat3 imageFromWorld_;
};

ViewEnd between(const ViewEnd& open, const ViewEnd& close, double u) {
    return {glm::mix(open.eye, close.eye, u), glm::mix(open.corner, close.corner, u),
            glm::mix(open.right, close.right, u), glm::mix(open.up, close.up, u),
            glm::mix(open.direction, close.direction, u)};
}

/// A place where something is and the place where it is drawn.
struct Apart {
    glm::dvec3 actual, drawn;
};

/// The largest distance in the image; 0 where all of it lies outside.
double distanceIn(const Projector& view, std::span<const Apart> points) {
    glm::dvec2 low(1e300), high(-1e300);
    double farthest = 0.0;
    for (const Apart& point : points) {
        const auto actual = view(point.actual), drawn = view(point.drawn);
        if (!actual || !drawn) continue;
        low = glm::min(low, glm::min(*actual, *drawn));
        high = glm::max(high, glm::max(*actual, *drawn));
        farthest = std::max(farthest, glm::length(*actual - *drawn));
    }
    const bool inside = low.x < view.size().x && low.y < view.size().y && high.x > 0.0 && high.y > 0.0;
    return inside ? farthest : 0.0;
}

/// How far things are from where they are drawn.
struct Farthest {
    double pixels = 0.0, texels = 0.0;
    double u = 0.0;           ///< of the larger of the two, where it counts most
    std::uint32_t thing = 0;  ///< then
    std::set<std::uint32_t> things;

    void add(double inPicture, double inMap, double at, std::uint32_t which) {
        if (!(std::max(inPicture, inMap) > threshold)) return;
        if (std::max(inPicture, inMap) > std::max(pixels, texels)) {
            u = at;
            thing = which;
        }
        pixels = std::max(pixels, inPicture);
        texels = std::max(texels, inMap);
        things.insert(which);
    }
    std::string distance() const {
        if (texels <= threshold) return fmt::format("{:.1f} pixels", pixels);
        if (pixels <= threshold) return fmt::format("{:.1f} texels of the shadow map", texels);
        return fmt::format("{:.1f} pixels and {:.1f} texels of the shadow map", pixels, texels);
    }
};

std::string named(const Farthest& farthest, const InnerMotion& inner, const char* verbOfOne, const char* verbOfMany) {
    const std::string name = fmt::format("\"{}\"", (*inner.things)[farthest.thing]);
    const std::size_t more = farthest.things.size() - 1;
    if (more == 0) return fmt::format("{} {}", name, verbOfOne);
    return fmt::format("{} and {} more {} {}", name, more, more == 1 ? "thing" : "things", verbOfMany);
}

/// As many groups as are worth a thread.
constexpr std::size_t groupsTogether = 64;

struct ViewsAtInstant {
    Projector picture, map;
};

/// Where the group's vertices are and are drawn; none where that is the same for all.
std::vector<Apart> pointsApart(const FramePlan& plan, const InnerMotion& inner, const InnerMotion::Group& group) {
    const std::vector<glm::dvec3>&open = plan.mesh->positionsOpen, &close = plan.mesh->positionsClose;
    std::vector<Apart> points;
    points.reserve(group.count);
    bool apart = false;
    for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
        const std::uint32_t v = inner.vertices[i];
        const glm::dvec3 straight = open[v] == close[v] ? open[v] : glm::mix(open[v], close[v], group.u);
        points.push_back({inner.positions[i] - plan.origin, straight - plan.origin});
        apart = apart || inner.positions[i] != straight;
    }
    if (!apart) points.clear();
    return points;
}

void addThings(const FramePlan& plan, const InnerMotion& inner, std::vector<PathWarning>& warnings) {
    std::map<double, ViewsAtInstant> views;  // few instants, many things
    for (const InnerMotion::Group& group : inner.groups)
        if (!views.contains(group.u))
            views.emplace(group.u, ViewsAtInstant{{plan.camera, between(plan.camera.open, plan.camera.close, group.u)},
                                                  {plan.light, between(plan.light.open, plan.light.close, group.u)}});
    std::vector<glm::dvec2> distances(inner.groups.size(), glm::dvec2(0.0));
    forEachOf(inner.groups.size(), groupsTogether, [&](std::size_t i) {
        const InnerMotion::Group& group = inner.groups[i];
        const std::vector<Apart> points = pointsApart(plan, inner, group);
        if (points.empty()) return;
        const ViewsAtInstant& at = views.at(group.u);
        distances[i] = {distanceIn(at.picture, points), distanceIn(at.map, points)};
    });
    Farthest bent, jumped;
    for (std::size_t i = 0; i < inner.groups.size(); ++i) {
        const InnerMotion::Group& group = inner.groups[i];
        (group.jumped ? jumped : bent).add(distances[i].x, distances[i].y, group.u, group.thing);
    }
    if (!bent.things.empty()) {
        const double turn = plan.mesh->largestTurnDegrees;
        warnings.push_back(
            {PathWarning::Kind::Bent, std::max(bent.pixels, bent.texels),
             fmt::format(
                 "{} the straight path between the shutter's ends, which is drawn, by up to {} (at u = {:.2g}){}",
                 named(bent, inner, "leaves", "leave"), bent.distance(), bent.u,
                 turn > turnWorthNaming ? fmt::format("; something turns by {:.0f} degrees", turn) : "")});
    }
    if (!jumped.things.empty())
        warnings.push_back(
            {PathWarning::Kind::Jump, std::max(jumped.pixels, jumped.texels),
             fmt::format("{} inside the shutter: drawn throughout as in its middle, off by up to {} at other instants",
                         named(jumped, inner, "jumps", "jump"), jumped.distance())});
}

double secondsAt(const ShutterTimes& times, double u) { return times.open + u * (times.close - times.open); }

void addCamera(const Scene& scene, const FramePlan& plan, const InnerMotion& inner, const ShutterTimes& times,
               std::vector<PathWarning>& warnings) {
    if (plan.request.cameraPose) return;
    const double aspect = static_cast<double>(plan.request.width) / plan.request.height;
    // Measured at the distance of the scene's centre.
    const double distance = std::max(glm::length(plan.camera.open.eye + plan.origin - scene.bounds().centre()),
                                     2.0 * static_cast<double>(plan.camera.block.nearDistance));
    double pixels = 0.0;
    for (const double u : inner.instants) {
        const ViewEnd drawn = between(plan.camera.open, plan.camera.close, u);
        const ViewEnd actual =
            viewEndOf(scene.camera(plan.request.cameraIndex, secondsAt(times, u)), plan.origin, aspect);
        if (drawn.eye == actual.eye && drawn.corner == actual.corner && drawn.right == actual.right) continue;
        const Projector seen(plan.camera, drawn), truly(plan.camera, actual);
        for (const auto& [s, t] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {0.5, 0.5}}) {
            const glm::dvec3 point = drawn.eye + distance * (drawn.corner + s * drawn.right + t * drawn.up);
            const auto here = seen(point), there = truly(point);
            const double most = glm::length(seen.size());  // what has left the picture has left it
            pixels = std::max(pixels, here && there ? std::min(most, glm::length(*here - *there)) : most);
        }
    }
    if (!(pixels > threshold)) return;
    const auto first = viewEndOf(scene.camera(plan.request.cameraIndex, times.open), plan.origin, aspect);
    const bool cuts = glm::length(first.eye - plan.camera.open.eye) > 1e-9 * scene.bounds().diagonal() ||
                      glm::length(first.corner - plan.camera.open.corner) > 1e-9;
    const auto last = viewEndOf(scene.camera(plan.request.cameraIndex, times.close), plan.origin, aspect);
    const bool cutsLate = glm::length(last.eye - plan.camera.close.eye) > 1e-9 * scene.bounds().diagonal() ||
                          glm::length(last.corner - plan.camera.close.corner) > 1e-9;
    warnings.push_back(
        {PathWarning::Kind::Camera, pixels,
         cuts || cutsLate
             ? fmt::format("the camera cuts inside the shutter: drawn throughout as in its middle, off by up to {:.1f} "
                           "pixels at other instants",
                           pixels)
             : fmt::format("the camera leaves the straight path between the shutter's ends, which is drawn, by up to "
                           "{:.1f} pixels at the distance of the scene's centre",
                           pixels)});
}

/// In texels, of what the light throws anywhere within the extent of the frame.
double lightApart(const FramePlan& plan, const LightPose& actual, double u) {
    const ViewEnd drawn = between(plan.light.open, plan.light.close, u);
    const double texel = static_cast<double>(plan.block.lightCone.w);
    const glm::dvec3 axis =
        glm::normalize(glm::mix(plan.lightOpen.axes[2], plan.lightClose.axes[2], u)) - actual.axes[2];
    if (plan.light.projection == Projection::Orthographic)
        return glm::length(axis) * 0.5 * plan.extent.diagonal() / texel;
    double texels = glm::length(axis) / texel;
    ViewEnd moved = drawn;
    moved.eye = actual.position - plan.origin;
    const Projector seen(plan.light, drawn), truly(plan.light, moved);
    for (int corner = 0; corner < 9; ++corner) {
        const glm::dvec3 share = corner == 8 ? glm::dvec3(0.5) : glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::dvec3 point = plan.extent.low + share * (plan.extent.high - plan.extent.low);
        const auto here = seen(point), there = truly(point);
        if (here && there && glm::all(glm::greaterThan(*here, glm::dvec2(0.0))) &&
            glm::all(glm::lessThan(*here, seen.size())))
            texels = std::max(texels, glm::length(*here - *there));
    }
    return texels;
}

void addLight(const FramePlan& plan, const InnerMotion& inner, const PlannedLight& light,
              std::vector<PathWarning>& warnings) {
    // A scene in which nothing moves names no instants; its light may move nevertheless.
    const bool none = inner.instants.empty() && plan.request.light.moves();
    double texels = 0.0;
    for (const double u : none ? innerInstants({}) : inner.instants)
        texels = std::max(texels, lightApart(plan, light.at(u), u));
    if (texels > threshold)
        warnings.push_back(
            {PathWarning::Kind::Light, texels,
             fmt::format(
                 "the light leaves the straight path between the shutter's ends, which is drawn, by up to {:.1f} "
                 "texels of the shadow map; a jump is drawn as in the shutter's middle",
                 texels)});
}

}  // namespace

std::vector<PathWarning> pathWarnings(const Scene& scene, const FramePlan& plan, const InnerMotion& inner,
                                      const ShutterTimes& times, const PlannedLight& light) {
    std::vector<PathWarning> warnings;
    addThings(plan, inner, warnings);
    addCamera(scene, plan, inner, times, warnings);
    addLight(plan, inner, light, warnings);
    return warnings;
}

std::optional<PathWarning> bentPathWarning(const FramePlan& plan) {
    if (plan.light.projection != Projection::Orthographic || plan.motion.lightTurnDegrees == 0.0) return std::nullopt;
    const glm::mat3 turn =
        glm::mat3(plan.light.block.viewFromWorldClose) - glm::mat3(plan.light.block.viewFromWorldOpen);
    float largest = 0.0f;
    for (std::size_t v = 0; v + 1 < plan.texels->vertices.size(); v += 2) {
        const glm::vec3 off = glm::abs(turn * (plan.texels->vertices[v + 1] - plan.texels->vertices[v]));
        largest = std::max({largest, off.x, off.y});
    }
    const double texels = 0.25 * static_cast<double>(largest) * plan.request.mapSize.longerSide();
    if (texels < 0.5) return std::nullopt;
    return PathWarning{
        PathWarning::Kind::Map, texels,
        fmt::format(
            "casters move while the sun turns: shadow maps take their paths as straight, which is off by up to {:.1f} "
            "texels",
            texels)};
}

}  // namespace timeshade
