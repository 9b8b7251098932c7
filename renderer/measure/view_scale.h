#pragma once

#include <string>
#include <vector>

#include "image/image_file.h"
#include "technique/technique.h"

namespace timeshade {

/// A number beside a scale: how far along it stands (0 to 1), and how it is written.
struct ScaleMark {
    double share = 0.0;
    std::string text;
};

/// 1, 2 or 5 times a power of ten, at least `least` > 0.
double roundStep(double least);

/// Numbers for a view's scale: both ends, and round ones between them, whole where the scale spans whole numbers. The
/// last carries the unit.
std::vector<ScaleMark> marksOf(const TechniqueView& view);

/// The picture of a technique's view with its scale below: colours, numbers and the unit.
DisplayImage withScale(const DisplayImage& picture, const TechniqueView& view);

}  // namespace timeshade
