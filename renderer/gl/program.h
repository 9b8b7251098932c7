#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "gl/inputs.h"
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

/// Texture units from here on are given to samplers and images whose declaration names no binding, in the order of
/// their names. Those below are the frame's own (frame_blocks.shared.h).
inline constexpr GLint firstFreeUnit = 16;

/// A linked program. Construction throws Error with the driver's first message, the file and the line.
class Program : public Object<DeleteProgram> {
  public:
    explicit Program(const ProgramDescription& description);
    void use() const { glUseProgram(name()); }
    /// Makes it the program in use and gives it all inputs. A name that none of its shaders declares is an error of the
    /// caller's: throws Error. One that is declared and not read in this variant is passed over.
    void use(const Inputs& inputs) const;
    /// One input of the program in use.
    void set(const std::string& input, const Inputs::Value& value) const;

  private:
    struct Uniform {
        GLint location = -1;
        GLuint unit = 0;  ///< of a sampler or image
        bool image = false, texture = false;
    };
    void findUniforms(const std::set<std::string>& bound);
    void bindTexture(const std::string& input, const Texture& texture) const;
    const Uniform* uniform(const std::string& input) const;

    std::string label_;
    std::map<std::string, Uniform> uniforms_;
    std::set<std::string> declared_;  ///< names of all uniforms in the sources, read or not
};

/// Every program built so far in this process, each once, for the test that hands each to an independent validator.
const std::vector<ProgramDescription>& programsBuilt();

}  // namespace timeshade::gl
