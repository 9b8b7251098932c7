#pragma once

#include "gl/program.h"
#include "technique/technique_frame.h"
#include "technique/view_target.h"

namespace timeshade {

/// Draws a view that is the sum of one value for each of a pixel's samples, a stratum at a time: `program`, with its
/// inputs set, reads the sample's triangles, `stratum`, and `share`, one over the number of samples.
void drawSummedView(const TechniqueFrame& frame, const gl::Program& program, ViewTarget& target,
                    const gl::Texture& values);

}  // namespace timeshade
