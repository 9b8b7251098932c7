#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scene/gltf_model.h"

namespace timeshade::gltf {

/// One animated property of a node: values at keys, and how to get from one to the next.
struct Track {
    int node = -1;
    TargetPath path = TargetPath::Other;
    Interpolation interpolation = Interpolation::Linear;
    std::size_t width = 0;                             ///< numbers per value: 3, 4, or the number of morph weights
    std::shared_ptr<const std::vector<double>> times;  ///< seconds, strictly increasing, never empty
    std::shared_ptr<const std::vector<float>> values;  ///< width per key; a spline has in-tangent, value, out-tangent

    /// The value at the given time, held before the first and after the last key. Rotations (x, y, z, w) are unit.
    void sample(double seconds, double* out) const;

  private:
    /// Nothing changes between this key and the next. Then the value is copied, not interpolated: what stands still
    /// must do so to the last bit, or it would count as moving.
    bool holds(std::size_t key) const;
};

/// An animation of the file.
struct Clip {
    std::string name;
    std::vector<Track> tracks;
    double duration = 0.0;  ///< the last key of all tracks, seconds
};

/// Keys by accessor. Channels share accessors, so reading each accessor once bounds memory by the file's size.
struct KeyCache {
    std::map<int, std::shared_ptr<const std::vector<double>>> times;
    std::map<int, std::shared_ptr<const std::vector<float>>> values;
};

/// Reads one animation and checks all of it. What cannot be played (targets of unknown kind) is left out with a note.
Clip readClip(const Model& model, std::size_t animation, KeyCache& cache, std::vector<std::string>& notes);

}  // namespace timeshade::gltf
