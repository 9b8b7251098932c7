#pragma once

#include <string>

namespace timeshade {

/// A picture of what a technique works with, instead of the scene: one value a pixel, coloured by a scale.
struct TechniqueView {
    std::string name;              ///< as after --view: lower case, dashes between words
    std::string title;             ///< for people
    std::string unit;              ///< of the values: "ranges", "u"; may be empty
    double low = 0.0, high = 1.0;  ///< the scale's ends; values beyond take the ends' colours
    bool logarithmic = false;
};

}  // namespace timeshade
