#pragma once

#include <string>
#include <vector>

#include "gl/object.h"
#include "gl/shader_source.h"

namespace timeshade::gl {

struct DeleteProgram {
    void operator()(GLuint name) const { glDeleteProgram(name); }
};

/// Which files make a program, and with which defines. Paths are under shaders/; a stage that is not there is empty.
struct ProgramDescription {
    std::string label;
    std::string vertex = {};
    std::string fragment = {};
    ShaderDefines defines = {};
    std::string geometry = {};
    std::string compute = {};  ///< alone: a program either draws or computes

    bool operator==(const ProgramDescription&) const = default;

    /// The stages that are there, first to last.
    std::vector<std::string> stages() const;
};

/// A linked program. Construction throws Error with the driver's first message, the file and the line.
class Program : public Object<DeleteProgram> {
  public:
    explicit Program(const ProgramDescription& description);
    void use() const { glUseProgram(name()); }
};

/// Every program built so far in this process, each once, for the test that hands each to an independent validator.
const std::vector<ProgramDescription>& programsBuilt();

}  // namespace timeshade::gl
