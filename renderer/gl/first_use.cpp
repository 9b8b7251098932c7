#include "gl/first_use.h"

#include <array>
#include <map>
#include <set>
#include <utility>

#include "core/pause.h"

namespace timeshade::gl {

namespace {

struct Uses {
    std::string label;
    std::set<std::pair<GLint, GLint>> sizes;  ///< of the viewport
};

/// Names are used again: what is known is of the last one.
std::map<GLuint, Uses>& known() {
    static std::map<GLuint, Uses> programs;
    return programs;
}

}  // namespace

void linked(GLuint program, const std::string& label) { known()[program] = {label, {}}; }

void announceFirstUse() {
    GLint current = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &current);
    const auto found = known().find(static_cast<GLuint>(current));
    if (found == known().end()) return;
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    if (found->second.sizes.emplace(viewport[2], viewport[3]).second)
        announceWork("building shader " + found->second.label);
}

}  // namespace timeshade::gl
