#include "scene/gltf_views.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "core/one_line.h"
#include "scene/fitted_views.h"

namespace timeshade::gltf {

namespace {

constexpr double widestCone = 1.48;       // 85 degrees: see LightPose
constexpr double pointLightCone = 1.396;  // 80 degrees

/// Makes names of cameras or lights unique: "eye", "eye 2", "eye 3", ...
class NameList {
  public:
    std::string unused(const std::string& wanted) {
        std::string name = wanted;
        while (!taken_.insert(name).second) name = fmt::format("{} {}", wanted, ++copies_[wanted] + 1);
        return name;
    }

  private:
    std::set<std::string> taken_;
    std::map<std::string, int> copies_;
};

CameraPose cameraPose(const Camera& camera, const std::string& name, const Bounds& bounds,
                      std::vector<std::string>& notes) {
    CameraPose pose = fittedCamera(bounds);
    if (camera.verticalFieldOfView > 0.01 && camera.verticalFieldOfView < 3.0) {
        pose.verticalFieldOfView = camera.verticalFieldOfView;
    } else {
        notes.push_back(fmt::format("camera \"{}\" has a field of view of {} radians and gets {}", name,
                                    camera.verticalFieldOfView, pose.verticalFieldOfView));
    }
    if (camera.nearDistance > 0.0 && std::isfinite(camera.nearDistance)) pose.nearDistance = camera.nearDistance;
    return pose;
}

void readCameras(const Model& model, const Bounds& bounds, Views& views, std::vector<std::string>& notes) {
    NameList list;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const Node& node = model.nodes[n];
        if (!node.inScene || node.camera < 0) continue;
        const Camera& camera = model.cameras[static_cast<std::size_t>(node.camera)];
        const std::string wanted = !node.name.empty()     ? node.name
                                   : !camera.name.empty() ? camera.name
                                                          : fmt::format("camera {}", views.cameras.size() + 1);
        if (!camera.perspective) {
            notes.push_back(fmt::format("camera \"{}\" is orthographic and is left out", wanted));
            continue;
        }
        views.names.push_back({list.unused(wanted)});
        views.cameras.push_back({static_cast<int>(n), cameraPose(camera, wanted, bounds, notes)});
    }
    if (!views.cameras.empty()) return;
    views.names.push_back({"fitted"});
    views.cameras.push_back({-1, fittedCamera(bounds)});
}

bool isOfKnownType(const Light& light) {
    return light.type == "spot" || light.type == "directional" || light.type == "point";
}

bool isDriven(const Clip& clip, int light) {
    return std::any_of(clip.lightTracks.begin(), clip.lightTracks.end(), [&](const Track& track) {
        return track.light == light && (track.path == TargetPath::Intensity || track.path == TargetPath::Colour);
    });
}

/// driven: its intensity or colour is animated, so that what it is at rest says little.
bool usable(const Light& light, bool driven) {
    const glm::dvec3 amount = light.colour * light.intensity;
    const bool sane =
        std::min({amount.x, amount.y, amount.z}) >= 0.0 && std::max({amount.x, amount.y, amount.z}) < 1e30;
    return isOfKnownType(light) && (driven || (sane && std::max({amount.x, amount.y, amount.z}) > 0.0));
}

/// Intensity, cone and range of a light, held to what LightPose allows.
void setProperties(LightPose& pose, const Light& light) {
    pose.kind = light.type == "directional" ? LightKind::Directional : LightKind::Spot;
    pose.intensity = glm::clamp(light.colour * light.intensity, 0.0, 1e30);
    pose.range = light.range > 0.0 && std::isfinite(light.range) ? light.range : 0.0;
    if (light.type == "point") {
        pose.outerConeAngle = pointLightCone;
        pose.innerConeAngle = pointLightCone * 0.95;
        return;
    }
    pose.outerConeAngle =
        light.outerConeAngle > 1e-3 ? std::min(light.outerConeAngle, widestCone) : LightPose{}.outerConeAngle;
    const double widestInner = pose.outerConeAngle * 0.999;
    pose.innerConeAngle = light.innerConeAngle >= 0.0 ? std::min(light.innerConeAngle, widestInner) : 0.0;
}

void set(Light& light, TargetPath path, const double* value) {
    if (path == TargetPath::Colour) light.colour = {value[0], value[1], value[2]};
    if (path == TargetPath::Intensity) light.intensity = value[0];
    if (path == TargetPath::Range) light.range = value[0];
    if (path == TargetPath::InnerConeAngle) light.innerConeAngle = value[0];
    if (path == TargetPath::OuterConeAngle) light.outerConeAngle = std::max(value[0], 2e-3);
}

void noteProperties(const PlacedLight& light, const std::string& name, std::vector<std::string>& notes) {
    if (light.aimed)
        notes.push_back(
            fmt::format("point light \"{}\" is treated as a spot of 80 degrees aimed at the scene's centre", name));
    const double given = light.properties.outerConeAngle;
    if (!light.aimed && !(given > 1e-3 && given <= widestCone))
        notes.push_back(fmt::format("spot light \"{}\" has an outer angle of {} radians and gets {}", name, given,
                                    light.pose.outerConeAngle));
    if (light.tracks.empty()) return;
    notes.push_back(
        fmt::format("light \"{}\" has animated intensity, colour, range or cone: each frame (or motion step) has them "
                    "as they are in the middle of its shutter",
                    name));
    for (const Track& track : light.tracks)
        if (track.path == TargetPath::OuterConeAngle &&
            std::any_of(track.values->begin(), track.values->end(),
                        [](float angle) { return static_cast<double>(angle) > widestCone; }))
            notes.push_back(
                fmt::format("spot light \"{}\" opens wider than {} radians and is held there", name, widestCone));
}

PlacedLight placed(const Model& model, const Clip& clip, int node, const std::string& name,
                   std::vector<std::string>& notes) {
    const int number = model.nodes[static_cast<std::size_t>(node)].light;
    PlacedLight to;
    to.node = node;
    to.properties = model.lights[static_cast<std::size_t>(number)];
    to.aimed = to.properties.type == "point";
    for (const Track& track : clip.lightTracks)
        if (track.light == number) to.tracks.push_back(track);
    setProperties(to.pose, to.properties);
    noteProperties(to, name, notes);
    return to;
}

/// The lights of the shown scene, by node.
class LightList {
  public:
    explicit LightList(const Model& model) : model_(model) {
        for (std::size_t n = 0; n < model.nodes.size(); ++n)
            if (model.nodes[n].inScene && model.nodes[n].light >= 0) nodes_.push_back(static_cast<int>(n));
    }

    const std::vector<int>& nodes() const { return nodes_; }
    int numberOf(int node) const { return model_.nodes[static_cast<std::size_t>(node)].light; }
    const Light& lightOf(int node) const { return model_.lights[static_cast<std::size_t>(numberOf(node))]; }
    std::string nameOf(int node) const {
        const std::string& name = model_.nodes[static_cast<std::size_t>(node)].name;
        return !name.empty() ? name : !lightOf(node).name.empty() ? lightOf(node).name : fmt::format("node {}", node);
    }

  private:
    const Model& model_;
    std::vector<int> nodes_;
};

/// The one that is used unless another is wanted: lights with a direction are preferred to point lights, for which one
/// has to be chosen. An index into `usable`; its size for none.
std::size_t usualLight(const LightList& list, const std::vector<int>& usable) {
    std::size_t chosen = usable.size();
    for (std::size_t i = 0; i < usable.size(); ++i)
        if (chosen == usable.size() ||
            (list.lightOf(usable[chosen]).type == "point" && list.lightOf(usable[i]).type != "point"))
            chosen = i;
    return chosen;
}

/// By name, or by number where no light has that name. The number of names for "fitted".
std::size_t wantedLightOf(const std::string& wanted, const std::vector<std::string>& names) {
    const auto named = std::find(names.begin(), names.end(), wanted);
    if (named != names.end()) return static_cast<std::size_t>(named - names.begin());
    if (wanted == "fitted") return names.size();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (wanted == std::to_string(i + 1)) return i;
    throw Error(fmt::format("has no light \"{}\"; {}", oneLine(wanted),
                            names.empty() ? std::string("it has none at all, and gets a fitted one")
                                          : fmt::format("it has: {}", fmt::join(names, ", "))));
}

void noteRest(const LightList& list, int chosen, std::vector<std::string>& notes) {
    std::vector<std::string> rest;
    for (const int node : list.nodes())
        if (node != chosen) rest.push_back(list.nameOf(node));
    if (rest.empty()) return;
    const std::size_t count = rest.size();
    if (count > 8) rest.resize(8);
    notes.push_back(fmt::format("one light is used; {} left out: {}{} (--light)", count, fmt::join(rest, ", "),
                                count > 8 ? ", ..." : ""));
}

void readLight(const Model& model, const Clip& clip, const Bounds& bounds, const std::string& wanted, Views& views,
               std::vector<std::string>& notes) {
    const LightList list(model);
    std::vector<int> usableNodes;
    NameList names;
    for (const int node : list.nodes()) {
        if (!isOfKnownType(list.lightOf(node)))
            notes.push_back(
                fmt::format("light \"{}\" has the type \"{}\" and is left out; expected spot, "
                            "directional or point",
                            list.nameOf(node), oneLine(list.lightOf(node).type, 30)));
        if (!usable(list.lightOf(node), isDriven(clip, list.numberOf(node)))) continue;
        usableNodes.push_back(node);
        views.lightNames.push_back(names.unused(list.nameOf(node)));
    }
    views.chosenLight = wanted.empty() ? usualLight(list, usableNodes) : wantedLightOf(wanted, views.lightNames);
    const int chosen = views.chosenLight < usableNodes.size() ? usableNodes[views.chosenLight] : -1;
    if (chosen >= 0)
        views.light = placed(model, clip, chosen, list.nameOf(chosen), notes);
    else
        views.light.pose = fittedLight(bounds);
    noteRest(list, chosen, notes);
}

}  // namespace

LightPose PlacedLight::at(const ClipInstant& instant) const {
    if (tracks.empty()) return pose;
    Light now = properties;
    for (const Track& track : tracks) {
        double value[3];
        track.sample(ClipInstant::of(instant.steps), value);
        set(now, track.path, value);
    }
    LightPose then = pose;
    setProperties(then, now);
    return then;
}

Views readViews(const Model& model, const Clip& clip, const Bounds& bounds, const std::string& wantedLight,
                std::vector<std::string>& notes) {
    Views views;
    readCameras(model, bounds, views, notes);
    readLight(model, clip, bounds, wantedLight, views, notes);
    return views;
}

}  // namespace timeshade::gltf
