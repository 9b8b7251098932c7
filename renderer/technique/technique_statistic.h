#pragma once

#include <string>

namespace timeshade {

/// Something that a technique counted while it drew, for the panel, --explain and reports.
struct TechniqueStatistic {
    std::string name;  ///< "dynamic triangles", "entries", "lists with unpaired fragments"
    double value = 0.0;
    std::string unit;     ///< may be empty
    std::string warning;  ///< what it means for the picture, where that is not right; else empty
};

}  // namespace timeshade
