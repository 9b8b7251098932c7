#include "technique/linked_interval_marks.h"

#include <bit>

#include "gl/read_back.h"
#include "shared/linked_intervals.shared.h"

namespace timeshade {

std::size_t listNumber(const FramePlan& plan, const glm::ivec2& texel) {
    return static_cast<std::size_t>(texel.y) * static_cast<std::size_t>(plan.request.mapSize.width) +
           static_cast<std::size_t>(texel.x);
}

void addLinkedMarks(const FramePlan& plan, const gl::Buffer& heads, const gl::Buffer& intervals, const MapLine& line,
                    std::vector<StoredMark>& marks) {
    const MapSize size = plan.request.mapSize;
    for (const TexelOnLine& t : texelsAlong(line, {size.width, size.height})) {
        GLuint next = gl::readElements<GLuint>(heads, listNumber(plan, t.texel), 1)[0];
        while (next != NO_INTERVAL) {
            const auto words =
                gl::readElements<GLuint>(intervals, std::size_t{next} * LINKED_INTERVAL_WORDS, LINKED_INTERVAL_WORDS);
            const auto number = [&](std::size_t word) { return std::bit_cast<float>(words[word]); };
            marks.push_back({t.xFrom, t.xTo, static_cast<double>(number(0)), static_cast<double>(number(1)),
                             distanceOfStored(plan, number(2)), distanceOfStored(plan, number(3))});
            marks.back().triangle = words[4];
            next = words[5];
        }
    }
}

}  // namespace timeshade
