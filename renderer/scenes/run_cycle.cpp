#include "scenes/run_cycle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenes/staging.h"

namespace timeshade {

namespace {

constexpr double standing = 0.33;    ///< share of a stride for which a foot is on the ground
constexpr double landing = 0.37;     ///< how far before the hips the ball of a foot lands
constexpr double hipHeight = 0.885;  ///< on average

/// One instant of a foot in the air, and how it gets there.
struct FootKey {
    double phase;       ///< of the stride; 0 as it lands
    double ahead, up;   ///< of the ball, from the hips and from the ground
    double heel, toes;  ///< degrees by which heel and toes are raised: heel up is positive, toes up too
};
const FootKey keys[] = {
    {standing, landing - standing* strideLength, 0.0, 58.0, 0.0},
    {0.46, -0.52, 0.26, 92.0, -18.0},
    {0.60, -0.30, 0.36, 84.0, -12.0},
    {0.74, 0.08, 0.27, 44.0, 0.0},
    {0.88, 0.42, 0.14, 12.0, 8.0},
    {1.0, landing, 0.0, 9.0, 4.0},
};

/// A cubic between two values with those slopes, all per unit of phase.
double cubic(double low, double high, double lowSlope, double highSlope, double width, double share) {
    const double s = share, s2 = s * s, s3 = s2 * s;
    return low * (2.0 * s3 - 3.0 * s2 + 1.0) + high * (3.0 * s2 - 2.0 * s3) +
           width * (lowSlope * (s3 - 2.0 * s2 + s) + highSlope * (s3 - s2));
}

/// A value of the keys at a phase, smoothly; its slopes at both ends are given.
double inAir(double FootKey::*value, double phase, double firstSlope, double lastSlope) {
    constexpr std::size_t count = std::size(keys);
    const auto slope = [&](std::size_t i) {
        if (i == 0) return firstSlope;
        if (i + 1 == count) return lastSlope;
        return (keys[i + 1].*value - keys[i - 1].*value) / (keys[i + 1].phase - keys[i - 1].phase);
    };
    std::size_t i = 0;
    while (i + 2 < count && phase > keys[i + 1].phase) ++i;
    const double width = keys[i + 1].phase - keys[i].phase;
    return cubic(keys[i].*value, keys[i + 1].*value, slope(i), slope(i + 1), width, (phase - keys[i].phase) / width);
}

struct FootPlace {
    double ahead, up, heel, toes;
};

FootPlace footAt(double phase) {
    if (phase >= standing)
        return {inAir(&FootKey::ahead, phase, -strideLength, -strideLength), inAir(&FootKey::up, phase, 0.7, -0.6),
                inAir(&FootKey::heel, phase, 420.0, -90.0), inAir(&FootKey::toes, phase, -120.0, 0.0)};
    // On the ground: it comes down on the ball, stands flat, and rises again over it.
    const double share = phase / standing, landed = std::clamp(share / 0.2, 0.0, 1.0),
                 leaving = std::clamp((share - 0.42) / 0.58, 0.0, 1.0);
    return {landing - phase * strideLength, 0.0, 9.0 * (1.0 - landed) * (1.0 - landed) + 58.0 * leaving * leaving,
            4.0 * (1.0 - landed)};
}

/// The right-handed frame whose y is along a bone and whose z is, as far as may be, towards something.
glm::dmat3 boneFrame(const glm::dvec3& along, const glm::dvec3& towards) {
    const glm::dvec3 y = glm::normalize(along), z = glm::normalize(towards - glm::dot(towards, y) * y);
    return {glm::cross(y, z), y, z};
}

/// The rotation that takes a bone from rest to where it is.
glm::dmat3 boneTurn(const glm::dvec3& restAlong, const glm::dvec3& restTowards, const glm::dvec3& along,
                    const glm::dvec3& towards) {
    return boneFrame(along, towards) * glm::transpose(boneFrame(restAlong, restTowards));
}

/// Half of the way from one rotation to another, less than 180 degrees apart.
glm::dmat3 halfway(const glm::dmat3& from, const glm::dmat3& to) {
    const glm::dmat3 sum = from + to;
    // The nearest rotation to the mean, by Newton's iteration.
    glm::dmat3 mean = 0.5 * sum;
    for (int i = 0; i < 12; ++i) mean = 0.5 * (mean + glm::transpose(glm::inverse(mean)));
    return mean;
}

using Pose = std::vector<RigidPose>;

void poseLeg(Pose& pose, Side side, double strides, const Track& track) {
    const RunnerJoints rest;
    const double begun = strides + (side == left ? 0.0 : 0.5), phase = begun - std::floor(begun);
    const FootPlace place = footAt(phase);
    const double along = strides * strideLength + place.ahead, outside = side == left ? -0.055 : 0.055;
    const glm::dmat3 heading = track.heading(along);
    const glm::dvec3 ball = track.at(along, outside) + glm::dvec3(0.0, place.up, 0.0);
    const glm::dvec3 restBall = onSide(side, rest.ball), restAnkle = onSide(side, rest.ankle);
    const glm::dmat3 footTurn = heading * turnAbout({1.0, 0.0, 0.0}, glm::radians(place.heel));
    const glm::dvec3 ankle = ball + footTurn * (restAnkle - restBall);
    pose[boneOf(side, foot)] = turnedAt(footTurn, restAnkle, ankle);
    // On the ground toes lie flat; in the air they go with the foot.
    const double flat = phase < standing ? 1.0 : std::clamp(1.0 - (phase - standing) / 0.10, 0.0, 1.0);
    const double toesUp = place.toes - (1.0 - flat * flat * (3.0 - 2.0 * flat)) * place.heel;
    pose[boneOf(side, toes)] = turnedAt(heading * turnAbout({1.0, 0.0, 0.0}, -glm::radians(toesUp)), restBall, ball);

    const glm::dvec3 restHip = onSide(side, rest.hip), restKnee = onSide(side, rest.knee);
    const glm::dvec3 hip = pose[pelvisBone].of(restHip);
    const double upper = glm::length(restKnee - restHip), lower = glm::length(restAnkle - restKnee);
    const double reach = std::min(glm::length(ankle - hip), 0.999 * (upper + lower));
    const glm::dvec3 way = glm::normalize(ankle - hip);
    const double before = (upper * upper - lower * lower + reach * reach) / (2.0 * reach);
    const glm::dvec3 forwards = boneFrame(way, pose[pelvisBone].axes[2])[2];
    const glm::dvec3 bent = hip + before * way + std::sqrt(std::max(0.0, upper * upper - before * before)) * forwards;
    const glm::dvec3 ahead(0.0, 0.0, 1.0);
    const glm::dmat3 thighTurn = boneTurn(restKnee - restHip, ahead, bent - hip, forwards);
    const glm::dmat3 shinTurn = boneTurn(restAnkle - restKnee, ahead, hip + reach * way - bent, forwards);
    pose[boneOf(side, thigh)] = turnedAt(thighTurn, restHip, hip);
    pose[boneOf(side, knee)] = turnedAt(halfway(thighTurn, shinTurn), restKnee, bent);
    pose[boneOf(side, shin)] = turnedAt(shinTurn, restKnee, bent);
}

void poseArm(Pose& pose, Side side, double strides) {
    const RunnerJoints rest;
    // With the leg of the other side; the right leg is half a stride behind the left one.
    const double swing = std::cos(2.0 * pi * (strides - 0.02)) * (side == left ? -1.0 : 1.0);
    const double forwards = glm::radians(4.0 + 42.0 * swing), bend = glm::radians(96.0 + 16.0 * swing),
                 sideways = glm::radians(14.0), inwards = side == left ? -0.30 : 0.30;
    const glm::dmat3& chest = pose[chestBone].axes;
    const glm::dvec3 upper = chest * onSide(side, {std::sin(sideways), -std::cos(sideways) * std::cos(forwards),
                                                   std::cos(sideways) * std::sin(forwards)});
    const glm::dvec3 bendsTo =
        boneFrame(upper, chest * glm::dvec3(inwards * (0.6 + 0.5 * swing), std::sin(forwards), std::cos(forwards)))[2];
    const glm::dvec3 restShoulder = onSide(side, rest.shoulder), restElbow = onSide(side, rest.elbow),
                     restWrist = onSide(side, rest.wrist), ahead(0.0, 0.0, 1.0);
    const glm::dvec3 lower = std::cos(bend) * upper + std::sin(bend) * bendsTo;
    const glm::dmat3 upperTurn = boneTurn(restElbow - restShoulder, ahead, upper, bendsTo);
    const glm::dmat3 lowerTurn =
        boneTurn(restWrist - restElbow, ahead, lower, std::cos(bend) * bendsTo - std::sin(bend) * upper);
    pose[boneOf(side, upperArm)] = turnedAt(upperTurn, restShoulder, pose[chestBone].of(restShoulder));
    const glm::dvec3 bent = pose[boneOf(side, upperArm)].of(restElbow);
    pose[boneOf(side, elbow)] = turnedAt(halfway(upperTurn, lowerTurn), restElbow, bent);
    pose[boneOf(side, forearm)] = turnedAt(lowerTurn, restElbow, bent);
}

}  // namespace

glm::dvec3 Track::at(double along, double outside) const {
    const double angle = along / radius;
    return (radius + outside) * glm::dvec3(std::cos(angle), 0.0, -std::sin(angle));
}

glm::dmat3 Track::heading(double along) const {
    const double angle = along / radius;
    const glm::dvec3 forwards(-std::sin(angle), 0.0, -std::cos(angle)), up(0.0, 1.0, 0.0);
    return {glm::cross(up, forwards), up, forwards};
}

std::vector<RigidPose> runningPose(double strides, const Track& track) {
    const RunnerJoints rest;
    Pose pose(boneCount);
    const double along = strides * strideLength, round = 2.0 * pi * strides;
    const glm::dmat3 heading = track.heading(along);
    // Lowest while a foot stands below the hips, twice a stride.
    const double height = hipHeight - 0.028 * std::cos(2.0 * (round - 2.0 * pi * 0.5 * standing));
    const double twist = std::cos(round - 2.0 * pi * 0.02);
    const glm::dvec3 up(0.0, 1.0, 0.0), across(1.0, 0.0, 0.0), ahead(0.0, 0.0, 1.0);
    const glm::dmat3 pelvis = heading * turnAbout(up, -0.10 * twist) * turnAbout(across, 0.10) *
                              turnAbout(ahead, -0.05 * std::cos(round - 2.0 * pi * 0.5 * standing));
    const glm::dvec3 hips(0.0, rest.hip.y, 0.0);
    pose[pelvisBone] = turnedAt(pelvis, hips, track.at(along, 0.0) + glm::dvec3(0.0, height, 0.0));
    const glm::dmat3 chest = heading * turnAbout(up, 0.20 * twist) * turnAbout(across, 0.17);
    pose[chestBone] = turnedAt(chest, rest.waist, pose[pelvisBone].of(rest.waist));
    const glm::dmat3 head = heading * turnAbout(across, 0.03 + 0.02 * std::cos(2.0 * round));
    pose[headBone] = turnedAt(head, rest.neck, pose[chestBone].of(rest.neck));
    for (const Side side : {left, right}) {
        poseLeg(pose, side, strides, track);
        poseArm(pose, side, strides);
    }
    return pose;
}

std::pair<double, int> roundTrack(double least) {
    const int strides = static_cast<int>(std::ceil(2.0 * pi * least / strideLength));
    return {strides * strideLength / (2.0 * pi), strides};
}

}  // namespace timeshade
