#include "scene/gltf_probes.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "scene/key_time.h"

namespace timeshade::gltf {

namespace {

std::vector<std::uint32_t> usedVertices(const Geometry& geometry) {
    std::vector<char> used(geometry.positions.size(), 0);
    for (const glm::u32vec3& triangle : geometry.triangles)
        for (int corner = 0; corner < 3; ++corner) used[triangle[corner]] = 1;
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < used.size(); ++v)
        if (used[v]) vertices.push_back(v);
    return vertices;
}

/// The joint with the largest weight at a vertex; -1 where none has any.
int strongestJoint(const Geometry& geometry, std::uint32_t v) {
    int joint = -1;
    float largest = 0.0f;
    for (const JointSet& set : geometry.jointSets)
        for (int i = 0; i < 4; ++i)
            if (set.weights[v][i] > largest) {
                largest = set.weights[v][i];
                joint = set.joints[v][i];
            }
    return joint;
}

std::vector<std::uint32_t> chosenVertices(const Geometry& geometry) {
    std::map<int, std::vector<std::uint32_t>> byJoint;
    for (const std::uint32_t v : usedVertices(geometry)) byJoint[strongestJoint(geometry, v)].push_back(v);
    std::vector<std::uint32_t> chosen;
    const auto add = [&](const std::vector<std::uint32_t>& some) {
        chosen.insert(chosen.end(), some.begin(), some.end());
    };
    for (const auto& [joint, vertices] : byJoint) {
        add(extremesOf(geometry.positions, vertices));
        for (const MorphDeltas& morph : geometry.morphs) {
            if (morph.positions.empty()) continue;
            const auto shift = [&](std::uint32_t v) { return glm::dot(morph.positions[v], morph.positions[v]); };
            chosen.push_back(*std::max_element(vertices.begin(), vertices.end(),
                                               [&](std::uint32_t a, std::uint32_t b) { return shift(a) < shift(b); }));
        }
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

template <typename Value>
std::vector<Value> picked(const std::vector<Value>& values, const std::vector<std::uint32_t>& places) {
    std::vector<Value> some;
    for (const std::uint32_t place : places)
        if (place < values.size()) some.push_back(values[place]);
    return some;
}

Geometry partOf(const Geometry& whole, const std::vector<std::uint32_t>& vertices) {
    Geometry part;
    part.positions = picked(whole.positions, vertices);
    part.normals = picked(whole.normals, vertices);
    for (const JointSet& set : whole.jointSets)
        part.jointSets.push_back({picked(set.joints, vertices), picked(set.weights, vertices)});
    for (const MorphDeltas& morph : whole.morphs)
        part.morphs.push_back({picked(morph.positions, vertices), picked(morph.normals, vertices)});
    return part;
}

/// The keys inside a shutter, as shares of it.
struct KeysInside {
    std::vector<double> shares;
    bool steps = false;  ///< some of them are STEP keys
};

KeysInside keysInside(const Clip& clip, const ClipClock& clock, double openSeconds, double closeSeconds) {
    KeysInside keys;
    const double length = closeSeconds - openSeconds;
    if (!(length > 0.0)) return keys;
    const double from = clock.loops() ? clock.clipTime(openSeconds) : openSeconds;
    std::set<std::pair<const std::vector<double>*, bool>> lists;  // channels often share them
    for (const Track& track : clip.tracks)
        lists.insert({track.times.get(), track.interpolation == Interpolation::Step});
    const double again = clock.loops() ? clip.duration : 0.0;
    for (const auto& [times, step] : lists) {
        std::size_t taken = 0;
        for (double start = 0.0; start < from + length && taken < mostInnerInstants; start += again) {
            const double slack = keyTimeSlack(from + length);
            const auto first = std::upper_bound(times->begin(), times->end(), from - start + slack);
            const auto end = std::lower_bound(first, times->end(), from + length - start - slack);
            // Far more keys than are looked at: every so many of them.
            const auto stride = std::max<std::ptrdiff_t>(1, (end - first) / static_cast<int>(mostInnerInstants));
            for (auto key = first; key < end; key += std::min(stride, end - key), ++taken)
                keys.shares.push_back((*key + start - from) / length);
            keys.steps = keys.steps || (step && first != end);
            if (!(again > 0.0)) break;
        }
    }
    return keys;
}

/// The places of all probes' vertices in a pose, in their order.
std::vector<glm::dvec3> placesIn(const Pose& pose, const ProbeList& list, const Stage& stage) {
    std::map<int, std::vector<glm::dmat4x3>> joints;
    std::vector<glm::dvec3> places;
    std::vector<glm::vec3> normals;
    for (const Probe& probe : list.probes) {
        const std::size_t first = places.size();
        places.resize(first + probe.vertices.size());
        normals.resize(probe.vertices.size());
        std::span<const glm::dmat4x3> own;
        if (probe.instance.skin >= 0) {
            auto& matrices = joints[probe.instance.skin];
            if (matrices.empty())
                matrices = jointMatrices(stage.skins[static_cast<std::size_t>(probe.instance.skin)], pose);
            own = matrices;
        }
        Instance instance = probe.instance;
        instance.geometry = &probe.geometry;
        deform(instance, pose, own, std::span(places).subspan(first), normals);
    }
    return places;
}

/// Adds the probes that are elsewhere than in `unless`, which has a place for each or is empty.
void addGroups(InnerMotion& inner, const ProbeList& list, const std::vector<glm::dvec3>& places, double u, bool jumped,
               const std::vector<glm::dvec3>& unless) {
    std::size_t at = 0;
    for (const Probe& probe : list.probes) {
        const std::size_t first = at;
        at += probe.vertices.size();
        if (!unless.empty() && std::equal(&places[first], &places[first] + probe.vertices.size(), &unless[first]))
            continue;
        inner.groups.push_back({probe.thing, u, jumped, static_cast<std::uint32_t>(inner.vertices.size()),
                                static_cast<std::uint32_t>(probe.vertices.size())});
        inner.vertices.insert(inner.vertices.end(), probe.vertices.begin(), probe.vertices.end());
        inner.positions.insert(inner.positions.end(), places.begin() + static_cast<std::ptrdiff_t>(first),
                               places.begin() + static_cast<std::ptrdiff_t>(at));
    }
}

}  // namespace

ProbeList probesOf(const Model& model, const Stage& stage) {
    ProbeList list;
    std::map<int, std::uint32_t> things;
    for (const Instance& instance : stage.instances) {
        if (!instance.moves) continue;
        const auto [thing, isNew] = things.try_emplace(instance.node, static_cast<std::uint32_t>(list.things.size()));
        const std::string& name = model.nodes[static_cast<std::size_t>(instance.node)].name;
        if (isNew) list.things.push_back(name.empty() ? fmt::format("node {}", instance.node) : name);
        Probe probe{thing->second, instance, {}, chosenVertices(*instance.geometry)};
        probe.geometry = partOf(*instance.geometry, probe.vertices);
        for (std::uint32_t& vertex : probe.vertices) vertex += static_cast<std::uint32_t>(instance.firstVertex);
        list.probes.push_back(std::move(probe));
    }
    return list;
}

InnerMotion innerMotionOf(const ProbeList& list, const Stage& stage, const NodeMotion& motion, const ClipClock& clock,
                          double openSeconds, double closeSeconds) {
    InnerMotion inner;
    if (!(closeSeconds > openSeconds)) return inner;
    const KeysInside keys = keysInside(motion.clip(), clock, openSeconds, closeSeconds);
    inner.things = &list.things;
    inner.instants = innerInstants(keys.shares);
    inner.instants.insert(inner.instants.begin(), 0.0);
    const double middle = clock.during(openSeconds, closeSeconds, 0.5);
    for (const double u : inner.instants) {
        const double seconds = clock.during(openSeconds, closeSeconds, u);
        const std::vector<glm::dvec3> drawn = placesIn(motion.at({seconds, middle}), list, stage);
        if (u > 0.0) addGroups(inner, list, drawn, u, false, {});
        if (keys.steps)
            addGroups(inner, list, placesIn(motion.at(ClipInstant::of(seconds)), list, stage), u, true, drawn);
    }
    return inner;
}

}  // namespace timeshade::gltf
