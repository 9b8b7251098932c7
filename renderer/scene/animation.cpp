#include "scene/animation.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "scene/gltf_accessors.h"
#include "scene/key_time.h"

namespace timeshade::gltf {

namespace {

void normaliseRotation(double* q) {
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (length > 1e-12) {
        for (int i = 0; i < 4; ++i) q[i] /= length;
    } else {
        q[0] = q[1] = q[2] = 0.0;
        q[3] = 1.0;
    }
}

/// Spherical interpolation along the shorter arc. Both ends are normalised first.
void slerp(const float* from, const float* to, double fraction, double* out) {
    double a[4], b[4];
    std::copy(from, from + 4, a);
    std::copy(to, to + 4, b);
    normaliseRotation(a);
    normaliseRotation(b);
    double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    const double sign = cosine < 0.0 ? -1.0 : 1.0;
    cosine = std::min(cosine * sign, 1.0);
    double shareA = 1.0 - fraction;
    double shareB = fraction;
    if (cosine < 0.999999) {  // closer than that, the chord equals the arc and avoids 0/0
        const double angle = std::acos(cosine);
        shareA = std::sin(shareA * angle) / std::sin(angle);
        shareB = std::sin(shareB * angle) / std::sin(angle);
    }
    for (int i = 0; i < 4; ++i) out[i] = shareA * a[i] + shareB * sign * b[i];
}

/// glTF 2.0, appendix C, "Cubic Spline Interpolation": Hermite, tangents scaled by the length of the segment.
double hermite(double from, double outTangent, double inTangent, double to, double length, double t) {
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (2.0 * t3 - 3.0 * t2 + 1.0) * from + length * (t3 - 2.0 * t2 + t) * outTangent + (3.0 * t2 - 2.0 * t3) * to +
           length * (t3 - t2) * inTangent;
}

std::shared_ptr<const std::vector<double>> readTimes(const Model& model, int accessor, KeyCache& cache,
                                                     const std::string& what) {
    auto& known = cache.times[accessor];
    if (known) return known;
    const std::vector<float> read = readFloats(model, accessor, 1, Integers::Forbidden, what + " key times");
    model.memory->take(read.size(), sizeof(double), what + " key times");
    std::vector<double> times(read.begin(), read.end());
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (times[i] > 1e7) throw Error(fmt::format("{}: key {} lies at {} s, the limit is 1e7 s", what, i, times[i]));
        if (times[i] < 0.0) throw Error(fmt::format("{}: key {} lies at {} s, before 0", what, i, times[i]));
        if (i > 0 && times[i] <= times[i - 1])
            throw Error(fmt::format("{}: key times do not increase: {} s after {} s", what, times[i], times[i - 1]));
    }
    return known = std::make_shared<const std::vector<double>>(std::move(times));
}

std::shared_ptr<const std::vector<float>> readValues(const Model& model, int accessor, int components, KeyCache& cache,
                                                     const std::string& what) {
    auto& known = cache.values[accessor];
    if (known && model.accessors[static_cast<std::size_t>(accessor)].components == components) return known;
    // Quantised files store translations and scales as integers too, so all narrow integers are accepted.
    std::vector<float> values = readFloats(model, accessor, components, Integers::Quantized, what + " values");
    for (const float value : values)
        if (std::abs(value) > 1e15f) throw Error(fmt::format("{}: a key has the value {}", what, value));
    return known = std::make_shared<const std::vector<float>>(std::move(values));
}

std::size_t morphCount(const Model& model, const Node& node) {
    if (node.mesh < 0 || model.meshes[static_cast<std::size_t>(node.mesh)].primitives.empty()) return 0;
    return model.meshes[static_cast<std::size_t>(node.mesh)].primitives.front().targets.size();
}

std::size_t widthOf(TargetPath path) {
    switch (path) {
    case TargetPath::Rotation: return 4;
    case TargetPath::Intensity:
    case TargetPath::Range:
    case TargetPath::InnerConeAngle:
    case TargetPath::OuterConeAngle: return 1;
    default: return 3;
    }
}

Track readTrack(const Model& model, const AnimationSampler& sampler, const AnimationChannel& channel, KeyCache& cache,
                const std::string& what) {
    Track track;
    track.node = channel.node;
    track.light = channel.light;
    track.path = channel.path;
    track.interpolation = sampler.interpolation;
    track.times = readTimes(model, sampler.input, cache, what);
    const bool weights = channel.path == TargetPath::Weights;
    track.width =
        weights ? morphCount(model, model.nodes[static_cast<std::size_t>(channel.node)]) : widthOf(channel.path);
    if (track.width == 0) return track;
    track.values = readValues(model, sampler.output, weights ? 1 : static_cast<int>(track.width), cache, what);
    const std::size_t perKey = sampler.interpolation == Interpolation::CubicSpline ? 3 : 1;
    const std::size_t expected = track.times->size() * perKey * track.width;
    if (track.values->size() != expected)
        throw Error(fmt::format("{}: {} numbers for {} keys, expected {}", what, track.values->size(),
                                track.times->size(), expected));
    return track;
}

}  // namespace

bool Track::holds(std::size_t key) const {
    const bool cubic = interpolation == Interpolation::CubicSpline;
    const std::size_t perKey = cubic ? 3 * width : width;
    const float* from = values->data() + key * perKey + (cubic ? width : 0);
    if (!std::equal(from, from + width, from + perKey)) return false;
    const auto zero = [](float tangent) { return tangent == 0.0f; };
    return !cubic ||
           (std::all_of(from + width, from + 2 * width, zero) && std::all_of(from + 2 * width, from + 3 * width, zero));
}

void Track::sample(const ClipInstant& instant, double* out) const {
    const bool steps = interpolation == Interpolation::Step;
    const double seconds = steps ? instant.steps + keyTimeSlack(instant.steps) : instant.seconds;
    const bool cubic = interpolation == Interpolation::CubicSpline;
    const std::size_t perKey = cubic ? 3 * width : width;
    const float* keys = values->data() + (cubic ? width : 0);  // a spline key has in-tangent, value, out-tangent
    const auto after =
        static_cast<std::size_t>(std::upper_bound(times->begin(), times->end(), seconds) - times->begin());
    const std::size_t before = after == 0 ? 0 : after - 1;
    const float* from = keys + before * perKey;

    if (after == 0 || after == times->size() || steps || holds(before)) {
        std::copy(from, from + width, out);
    } else {
        const float* to = from + perKey;
        const double length = (*times)[after] - (*times)[before];
        const double fraction = (seconds - (*times)[before]) / length;
        if (cubic) {
            for (std::size_t i = 0; i < width; ++i)
                out[i] = hermite(static_cast<double>(from[i]), static_cast<double>(from[width + i]),
                                 static_cast<double>((to - width)[i]), static_cast<double>(to[i]), length, fraction);
        } else if (path == TargetPath::Rotation) {
            slerp(from, to, fraction, out);
        } else {
            for (std::size_t i = 0; i < width; ++i)
                out[i] = static_cast<double>(from[i]) +
                         (static_cast<double>(to[i]) - static_cast<double>(from[i])) * fraction;
        }
    }
    if (path == TargetPath::Rotation) normaliseRotation(out);
}

Clip readClip(const Model& model, std::size_t index, KeyCache& cache, std::vector<std::string>& notes) {
    const Animation& animation = model.animations[index];
    Clip clip{animation.name.empty() ? fmt::format("animation_{}", index) : animation.name, {}, {}, 0.0};
    std::size_t skipped = 0;
    for (const AnimationChannel& channel : animation.channels) {
        if (channel.path == TargetPath::Other) {
            ++skipped;
            continue;
        }
        const bool ofLight = channel.light >= 0;
        const std::string what = fmt::format("animation {} ({} {})", index, ofLight ? "light" : "node",
                                             ofLight ? channel.light : channel.node);
        Track track =
            readTrack(model, animation.samplers[static_cast<std::size_t>(channel.sampler)], channel, cache, what);
        if (track.width == 0) {
            ++skipped;
            continue;
        }
        clip.duration = std::max(clip.duration, track.times->back());
        (ofLight ? clip.lightTracks : clip.tracks).push_back(std::move(track));
    }
    if (skipped > 0)
        notes.push_back(fmt::format("{} channels of clip \"{}\" drive something that is not supported and are left out",
                                    skipped, clip.name));
    return clip;
}

}  // namespace timeshade::gltf
