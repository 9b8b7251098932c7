#pragma once

#include <string>
#include <vector>

#include "gl/object.h"
#include "gl/shader_source.h"

namespace timeshade::gl {

struct DeleteProgram {
    void operator()(GLuint name) const { glDeleteProgram(name); }
};

/// Which files make a program, and with which defines.
struct ProgramDescription {
    std::string label;
    std::string vertex;    ///< path under shaders/
    std::string fragment;  ///< may be empty: depth only
    ShaderDefines defines;
};

/// A linked program. Construction throws Error with the driver's first message, the file and the line.
class Program : public Object<DeleteProgram> {
  public:
    explicit Program(const ProgramDescription& description);
    void use() const { glUseProgram(name()); }
};

/// Every program built so far in this process, for the test that hands each to an independent validator.
const std::vector<ProgramDescription>& programsBuilt();

} // namespace timeshade::gl
