#include "scenes/runner_body.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include "scenes/blobs.h"

namespace timeshade {

namespace {

enum Layer : std::uint32_t { bare, singlet, shorts, shoe, sock, hair, sole, layers };
const std::array<glm::vec3, layers> colours{{{0.44f, 0.24f, 0.155f},
                                             {0.05f, 0.22f, 0.45f},
                                             {0.035f, 0.04f, 0.055f},
                                             {0.75f, 0.36f, 0.03f},
                                             {0.62f, 0.62f, 0.60f},
                                             {0.07f, 0.045f, 0.03f},
                                             {0.66f, 0.66f, 0.64f}}};

/// Blobs as they are added: those of limbs on both sides.
struct Maker {
    std::vector<Blob> blobs;
    Layer layer = bare;

    Blob& middle(std::uint32_t bone, const glm::dvec3& a, const glm::dvec3& b, double radiusA, double radiusB,
                 double melting = 0.03, double depth = 1.0) {
        blobs.push_back({a, b, radiusA, radiusB, depth, melting, bone, layer, glm::dvec3(0.0), 0.0});
        return blobs.back();
    }
    void both(LimbBone bone, const glm::dvec3& a, const glm::dvec3& b, double radiusA, double radiusB,
              double melting = 0.03, const glm::dvec3& cutTo = glm::dvec3(0.0), double cutAt = 0.0) {
        for (const Side side : {left, right}) {
            Blob& blob = middle(boneOf(side, bone), onSide(side, a), onSide(side, b), radiusA, radiusB, melting);
            blob.cutTo = onSide(side, cutTo);
            blob.cutAt = cutAt;
        }
    }
};

glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double share, double forwards = 0.0) {
    return glm::mix(a, b, share) + glm::dvec3(0.0, 0.0, forwards);
}

void addLegs(Maker& maker, const RunnerJoints& at) {
    maker.layer = bare;
    // What the shorts cover begins below their folds.
    maker.both(thigh, between(at.hip, at.knee, 0.34), at.knee, 0.080, 0.054);
    maker.both(thigh, between(at.hip, at.knee, 0.38, 0.020), between(at.hip, at.knee, 0.74, 0.016), 0.070, 0.056);
    maker.both(thigh, between(at.hip, at.knee, 0.38, -0.020), between(at.hip, at.knee, 0.80, -0.014), 0.064, 0.046);
    maker.both(knee, between(at.knee, at.ankle, -0.05, 0.012), between(at.knee, at.ankle, 0.04, 0.014), 0.048, 0.044);
    maker.both(shin, at.knee, at.ankle, 0.050, 0.033);
    maker.both(shin, between(at.knee, at.ankle, 0.14, -0.026), between(at.knee, at.ankle, 0.50, -0.020), 0.047, 0.038);
    maker.both(shin, between(at.knee, at.ankle, 0.18, -0.010) + glm::dvec3(-0.016, 0.0, 0.0),
               between(at.knee, at.ankle, 0.45, -0.012), 0.043, 0.034);
    maker.layer = sock;
    maker.both(shin, at.ankle, between(at.ankle, at.knee, 0.20), 0.040, 0.0445, 0.03, {0.0, 1.0, 0.0}, 0.165);
    maker.layer = shoe;
    maker.both(foot, {0.135, 0.056, -0.050}, {0.139, 0.044, 0.095}, 0.042, 0.041);
    maker.both(foot, {0.135, 0.100, -0.026}, {0.136, 0.070, -0.020}, 0.043, 0.044, 0.03, {0.0, 1.0, 0.0}, 0.112);
    maker.both(foot, at.ankle + glm::dvec3(0.0, 0.0, 0.015), {0.138, 0.052, 0.085}, 0.044, 0.036);
    maker.both(toes, {0.139, 0.042, 0.092}, {0.142, 0.037, 0.165}, 0.041, 0.033);
    maker.layer = sole;
    const glm::dvec3 down(0.0, -1.0, 0.0);
    maker.both(foot, {0.135, 0.000, -0.052}, {0.139, -0.004, 0.095}, 0.047, 0.048, 0.03, down, -0.002);
    maker.both(toes, {0.139, -0.004, 0.092}, {0.142, 0.002, 0.168}, 0.048, 0.037, 0.03, down, -0.002);
}

void addTrunk(Maker& maker, const RunnerJoints& at) {
    maker.layer = shorts;
    maker.middle(pelvisBone, {-0.068, 0.975, -0.004}, {0.068, 0.975, -0.004}, 0.110, 0.110, 0.06, 0.88);
    maker.both(thigh, at.hip + glm::dvec3(-0.012, 0.01, -0.028), at.hip + glm::dvec3(-0.010, -0.03, -0.030), 0.098,
               0.096, 0.06);
    maker.both(thigh, at.hip + glm::dvec3(0.0, -0.02, 0.0), between(at.hip, at.knee, 0.62), 0.104, 0.092, 0.05,
               {0.0, -1.0, 0.0}, -0.715);
    maker.layer = singlet;
    maker.middle(pelvisBone, {-0.028, 1.015, -0.004}, {0.028, 1.06, -0.006}, 0.114, 0.104, 0.08, 0.86);
    maker.middle(chestBone, {-0.034, 1.16, -0.006}, {0.034, 1.16, -0.006}, 0.104, 0.104, 0.10, 0.86);
    maker.middle(chestBone, {-0.064, 1.29, -0.012}, {0.064, 1.29, -0.012}, 0.112, 0.112, 0.09, 0.86);
    maker.middle(chestBone, {-0.105, 1.395, -0.026}, {0.105, 1.395, -0.026}, 0.072, 0.072, 0.07, 0.95);
}

void addHead(Maker& maker, const RunnerJoints& at) {
    maker.layer = bare;
    maker.middle(chestBone, {-0.02, 1.43, -0.028}, {0.0, 1.47, -0.022}, 0.066, 0.058);
    maker.middle(headBone, at.neck, {0.0, 1.56, -0.004}, 0.057, 0.053);
    maker.middle(headBone, {0.0, 1.650, -0.022}, {0.0, 1.672, 0.012}, 0.089, 0.087, 0.05);
    maker.middle(headBone, {0.0, 1.605, 0.036}, {0.0, 1.577, 0.052}, 0.064, 0.046, 0.05);
    maker.middle(headBone, {0.0, 1.632, 0.094}, {0.0, 1.604, 0.112}, 0.010, 0.015, 0.022);
    for (const double x : {-1.0, 1.0}) {
        maker.middle(headBone, {0.086 * x, 1.640, -0.006}, {0.085 * x, 1.606, -0.002}, 0.020, 0.013, 0.012, 0.8);
        maker.middle(headBone, {0.030 * x, 1.652, 0.084}, {0.045 * x, 1.652, 0.078}, 0.013, 0.012, 0.020);
    }
    maker.layer = hair;
    maker.middle(headBone, {0.0, 1.676, -0.034}, {0.0, 1.694, 0.004}, 0.095, 0.088, 0.04);
    maker.middle(headBone, {0.0, 1.62, -0.060}, {0.0, 1.66, -0.050}, 0.062, 0.075, 0.04);
    maker.middle(headBone, {0.0, 1.70, -0.13}, {0.0, 1.65, -0.19}, 0.030, 0.036, 0.03);
    maker.middle(headBone, {0.0, 1.65, -0.19}, {0.0, 1.56, -0.215}, 0.036, 0.014, 0.03);
}

void addArms(Maker& maker, const RunnerJoints& at) {
    maker.layer = bare;
    maker.both(upperArm, at.shoulder + glm::dvec3(-0.006, -0.004, 0.0), between(at.shoulder, at.elbow, 0.30), 0.059,
               0.050, 0.04);
    for (const Side side : {left, right})
        maker.middle(chestBone, onSide(side, {0.045, 1.435, -0.024}), onSide(side, at.shoulder), 0.050, 0.052, 0.05);
    maker.both(upperArm, at.shoulder, at.elbow, 0.050, 0.038);
    maker.both(upperArm, between(at.shoulder, at.elbow, 0.35, 0.014), between(at.shoulder, at.elbow, 0.68, 0.012),
               0.042, 0.036);
    maker.both(elbow, between(at.elbow, at.shoulder, 0.03), between(at.elbow, at.wrist, 0.03), 0.038, 0.038);
    maker.both(forearm, at.elbow, at.wrist, 0.040, 0.026);
    maker.both(forearm, between(at.elbow, at.wrist, 0.15), between(at.elbow, at.wrist, 0.50), 0.043, 0.034);
    const glm::dvec3 along = glm::normalize(at.wrist - at.elbow);
    maker.both(forearm, at.wrist, at.wrist + 0.03 * along, 0.026, 0.030, 0.02);
    maker.both(forearm, at.wrist + 0.045 * along, at.wrist + 0.085 * along, 0.036, 0.036, 0.02);
    maker.both(forearm, at.wrist + 0.03 * along + glm::dvec3(-0.01, 0.0, 0.028),
               at.wrist + 0.085 * along + glm::dvec3(-0.012, 0.0, 0.032), 0.015, 0.013, 0.012);
}

std::vector<Blob> blobsOfRunner() {
    const RunnerJoints at;
    Maker maker;
    addLegs(maker, at);
    addTrunk(maker, at);
    addHead(maker, at);
    addArms(maker, at);
    return maker.blobs;
}

/// By how near its surface is, each bone has its share.
Influences influencesAt(const std::vector<Blob>& blobs, const glm::dvec3& place) {
    constexpr double reach = 0.024;
    std::array<double, boneCount> distances;
    distances.fill(1e9);
    for (const Blob& blob : blobs) {
        double& distance = distances[blob.bone];
        distance = std::min(distance, distanceTo(blob, place));
    }
    std::array<std::uint32_t, boneCount> order;
    for (std::uint32_t bone = 0; bone < boneCount; ++bone) order[bone] = bone;
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return distances[a] < distances[b]; });
    Influences influences;
    double sum = 0.0;
    for (std::size_t k = 0; k < influences.bones.size(); ++k) {
        const double behind = (distances[order[k]] - distances[order[0]]) / reach;
        influences.bones[k] = order[k];
        influences.shares[k] = behind < 4.0 ? std::exp(-behind) - std::exp(-4.0) : 0.0;
        sum += influences.shares[k];
    }
    for (double& share : influences.shares) share /= sum;
    return influences;
}

RunnerBody madeOf(const std::vector<Blob>& blobs, double cell) {
    LayeredShape made = surfaceOf(blobs, cell);
    RunnerBody body;
    for (std::size_t v = 0; v < made.layers.size(); ++v) {
        made.shape.colours.push_back(colours[made.layers[v]]);
        body.influences.push_back(influencesAt(blobs, made.shape.positions[v]));
    }
    body.shape = std::make_shared<const Shape>(std::move(made.shape));
    return body;
}

}  // namespace

glm::dvec3 onSide(Side side, const glm::dvec3& place) { return {side == left ? place.x : -place.x, place.y, place.z}; }

const RunnerBody& runnerBody(double cell) {
    static std::mutex mutex;
    static std::map<double, RunnerBody> known;
    const std::lock_guard lock(mutex);
    const auto found = known.find(cell);
    return found != known.end() ? found->second : known.emplace(cell, madeOf(blobsOfRunner(), cell)).first->second;
}

}  // namespace timeshade
