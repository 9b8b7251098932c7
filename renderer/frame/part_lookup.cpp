#include "frame/part_lookup.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "shared/seen_slices.shared.h"

namespace timeshade {

void PartLookup::draw(const TechniqueFrame& frame, const Lookup& lookup, const IntervalSamples& samples,
                      bool solvesIntervals) {
    const int width = SEEN_PARTS_IN_ROW;
    const int rows = static_cast<int>((samples.partCount() + SEEN_PARTS_IN_ROW - 1) / SEEN_PARTS_IN_ROW);
    if (!values_ || values_->height() < rows) {
        GLint largest = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
        if (rows > largest)
            throw LimitError(
                fmt::format("{} parts of what positions see need {} rows of a texture; this device's "
                            "GL_MAX_TEXTURE_SIZE is {}: draw a smaller picture, or lower --spp",
                            samples.partCount(), rows, largest));
        values_.reset();
        values_ =
            gl::Texture::image2D("visibility of parts", GL_RGBA32F, width, std::min(largest, rows + rows / 8 + 1));
        const GLfloat none[4] = {1.0f, 0.0f, 0.5f, 0.25f};
        glClearTexImage(values_->name(), 0, GL_RGBA, GL_FLOAT, none);
    }
    LookupProgram wanted = lookup.program(Casters::All);
    gl::ShaderDefines defines{{"INTERVAL_SAMPLES", "1"}};
    if (solvesIntervals) defines.emplace_back("SOLVES_INTERVALS", "1");
    const gl::Program& program = programOf(programs_, frame, lookup, wanted, defines);
    wanted.inputs.texture("seenParts", samples.parts()).set("partCount", samples.partCount());
    program.use(wanted.inputs);
    target_.setColorCount(1);
    target_.attach(GL_COLOR_ATTACHMENT0, *values_);
    target_.bindForDrawing(width, std::max(rows, 1));
    frame.fullscreen.draw(program);
}

}  // namespace timeshade
