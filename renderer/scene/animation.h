#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scene/gltf_model.h"

namespace timeshade::gltf {

/// A moment of a clip. In a shutter, `steps` is its middle at all of its instants, so that nothing jumps inside it.
struct ClipInstant {
    double seconds = 0.0;  ///< at which continuous tracks are read
    double steps = 0.0;    ///< at which tracks of STEP keys are read
    static ClipInstant of(double seconds) { return {seconds, seconds}; }
};

/// One animated property of a node or a light: values at keys, and the interpolation between them.
struct Track {
    int node = -1;
    int light = -1;
    TargetPath path = TargetPath::Other;
    Interpolation interpolation = Interpolation::Linear;
    std::size_t width = 0;                             ///< numbers per value: 1, 3, 4, or that of morph weights
    std::shared_ptr<const std::vector<double>> times;  ///< seconds, strictly increasing, never empty
    std::shared_ptr<const std::vector<float>> values;  ///< width per key; a spline has in-tangent, value, out-tangent

    /// The value at the given time, constant before the first and after the last key. Rotations (x, y, z, w) are unit.
    /// A STEP key counts from keyTimeSlack() before its time.
    void sample(const ClipInstant& instant, double* out) const;

  private:
    /// Whether the value is equal at this key and the next. It is then copied instead of interpolated: a static object
    /// must be bitwise static, or it would be classified as moving.
    bool holds(std::size_t key) const;
};

/// An animation of the file.
struct Clip {
    std::string name;
    std::vector<Track> tracks;       ///< of nodes
    std::vector<Track> lightTracks;  ///< of lights' own properties
    double duration = 0.0;           ///< the last key of all tracks, seconds
};

/// Keys by accessor. Channels may share accessors; reading each accessor once bounds memory by the file's size.
struct KeyCache {
    std::map<int, std::shared_ptr<const std::vector<double>>> times;
    std::map<int, std::shared_ptr<const std::vector<float>>> values;
};

/// Reads and validates one animation. Channels with unknown targets are left out with a note.
Clip readClip(const Model& model, std::size_t animation, KeyCache& cache, std::vector<std::string>& notes);

}  // namespace timeshade::gltf
