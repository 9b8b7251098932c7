#pragma once

#include <optional>
#include <string>

#include "measure/technique_variant.h"

namespace timeshade {

/// One side of a comparison, as --compare names it: a technique, "tsm:bias=2", where "spp=12" among its settings is its
/// own number of samples per pixel; "truth", what ray tracing shows; or a picture's file, F.png or F.exr.
struct ComparedSide {
    enum class Kind { Technique, Truth, File };

    /// Throws UsageError for samples that are no number from 1 to what a frame takes, and as TechniqueVariant::of.
    static ComparedSide of(const std::string& text);

    Kind kind = Kind::Technique;
    TechniqueVariant variant;            ///< of a technique
    std::optional<int> samplesPerPixel;  ///< of a technique, where they are its own
    std::string path;                    ///< of a file
};

/// Camera samples per pixel of the ground truth as a picture, each with a shadow ray of its own.
inline constexpr int truthSamples = 256;
inline constexpr const char* truthName = "truth";
/// "Ground truth, 256 spp"
std::string truthLabel(int samples);

}  // namespace timeshade
