#include "gl/first_use.h"

#include <array>
#include <bit>
#include <cstdint>
#include <map>

#include "core/pause.h"

namespace timeshade::gl {

namespace {

struct Uses {
    std::string label;
    std::uint64_t sizes = 0;  ///< a bit for each doubling of the viewport's pixels: not one for every size of a window
};

/// Names are used again: what is known is of the last one.
std::map<GLuint, Uses>& known() {
    static std::map<GLuint, Uses> programs;
    return programs;
}

}  // namespace

void linked(GLuint program, const std::string& label) { known()[program] = {label, 0}; }

void announceFirstUse() {
    GLint current = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &current);
    const auto found = known().find(static_cast<GLuint>(current));
    if (found == known().end()) return;
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    const auto pixels = static_cast<std::uint64_t>(viewport[2]) * static_cast<std::uint64_t>(viewport[3]);
    const std::uint64_t size = std::uint64_t{1} << (std::bit_width(pixels) % 64);
    if ((found->second.sizes & size) != 0) return;
    found->second.sizes |= size;
    announceWork("building shader " + found->second.label);
}

}  // namespace timeshade::gl
