#include "scene/gltf_views.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/one_line.h"
#include "scene/fitted_views.h"

namespace timeshade::gltf {

namespace {

constexpr double widestCone = 1.48;       // 85 degrees: see LightPose
constexpr double pointLightCone = 1.396;  // 80 degrees

/// Makes names of cameras unique: "eye", "eye 2", "eye 3", ...
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

bool usable(const Light& light) {
    const glm::dvec3 amount = light.colour * light.intensity;
    const bool known = isOfKnownType(light);
    const bool sane =
        std::min({amount.x, amount.y, amount.z}) >= 0.0 && std::max({amount.x, amount.y, amount.z}) < 1e30;
    return known && sane && std::max({amount.x, amount.y, amount.z}) > 0.0;
}

PlacedLight placed(const Light& light, int node, const std::string& name, std::vector<std::string>& notes) {
    PlacedLight to;
    to.node = node;
    to.aimed = light.type == "point";
    to.pose.kind = light.type == "directional" ? LightKind::Directional : LightKind::Spot;
    to.pose.intensity = light.colour * light.intensity;
    to.pose.outerConeAngle = to.aimed ? pointLightCone : light.outerConeAngle;
    to.pose.innerConeAngle = to.aimed ? pointLightCone * 0.95 : light.innerConeAngle;
    if (to.aimed)
        notes.push_back(
            fmt::format("point light \"{}\" is treated as a spot of 80 degrees aimed at the scene's centre", name));
    if (!(to.pose.outerConeAngle > 1e-3 && to.pose.outerConeAngle <= widestCone)) {
        const double given = to.pose.outerConeAngle;
        to.pose.outerConeAngle = given > widestCone ? widestCone : LightPose{}.outerConeAngle;
        notes.push_back(fmt::format("spot light \"{}\" has an outer angle of {} radians and gets {}", name, given,
                                    to.pose.outerConeAngle));
    }
    const double widestInner = to.pose.outerConeAngle * 0.999;
    to.pose.innerConeAngle = to.pose.innerConeAngle >= 0.0 ? std::min(to.pose.innerConeAngle, widestInner) : 0.0;
    return to;
}

void readLight(const Model& model, const Bounds& bounds, Views& views, std::vector<std::string>& notes) {
    // Lights with a direction are preferred to point lights, for which one has to be chosen.
    int chosen = -1;
    const auto lightOf = [&](int node) -> const Light& {
        return model.lights[static_cast<std::size_t>(model.nodes[static_cast<std::size_t>(node)].light)];
    };
    const auto nameOf = [&](int node) {
        const std::string& name = model.nodes[static_cast<std::size_t>(node)].name;
        return !name.empty() ? name : !lightOf(node).name.empty() ? lightOf(node).name : fmt::format("node {}", node);
    };
    std::vector<int> all;
    for (std::size_t n = 0; n < model.nodes.size(); ++n)
        if (model.nodes[n].inScene && model.nodes[n].light >= 0) all.push_back(static_cast<int>(n));
    for (const int node : all) {
        if (!isOfKnownType(lightOf(node)))
            notes.push_back(
                fmt::format("light \"{}\" has the type \"{}\" and is left out; expected spot, "
                            "directional or point",
                            nameOf(node), oneLine(lightOf(node).type, 30)));
        if (!usable(lightOf(node))) continue;
        if (chosen < 0 || (lightOf(chosen).type == "point" && lightOf(node).type != "point")) chosen = node;
    }
    if (chosen >= 0)
        views.light = placed(lightOf(chosen), chosen, nameOf(chosen), notes);
    else
        views.light.pose = fittedLight(bounds);

    std::vector<std::string> rest;
    for (const int node : all)
        if (node != chosen) rest.push_back(nameOf(node));
    if (rest.empty()) return;
    const std::size_t count = rest.size();
    if (count > 8) rest.resize(8);
    notes.push_back(
        fmt::format("one light is used; {} left out: {}{}", count, fmt::join(rest, ", "), count > 8 ? ", ..." : ""));
}

}  // namespace

Views readViews(const Model& model, const Bounds& bounds, std::vector<std::string>& notes) {
    Views views;
    readCameras(model, bounds, views, notes);
    readLight(model, bounds, views, notes);
    return views;
}

}  // namespace timeshade::gltf
