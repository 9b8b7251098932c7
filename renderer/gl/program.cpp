#include "gl/program.h"

#include <algorithm>
#include <regex>

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade::gl {

namespace {

std::vector<ProgramDescription>& built() {
    static std::vector<ProgramDescription> descriptions;
    return descriptions;
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Mesa writes "3:17(5): error: ...", NVIDIA "3(17) : error ...": the first number is the one given to #line.
std::string withFileNames(const std::string& log, const ShaderSource& source) {
    std::smatch match;
    const std::string line = firstLine(log);
    if (!std::regex_search(line, match, std::regex(R"(^(\d+)[:(](\d+))"))) return line;
    const auto file = static_cast<std::size_t>(std::stoul(match[1].str()));
    const std::string name = file < source.files.size() ? source.files[file] : source.files.front();
    return fmt::format("{}:{}: {}", name, match[2].str(), line);
}

GLuint compile(GLenum stage, const ShaderSource& source) {
    const GLuint shader = glCreateShader(stage);
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return shader;
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    glDeleteShader(shader);
    throw Error("shaders/" + withFileNames(log, source));
}

GLuint link(const ProgramDescription& description) {
    const GLuint program = glCreateProgram();
    try {
        const auto stage = [&](GLenum kind, const std::string& path) {
            const GLuint shader = compile(kind, readShader(path, description.defines));
            glAttachShader(program, shader);
            glDeleteShader(shader);  // freed with the program
        };
        if (!description.vertex.empty()) stage(GL_VERTEX_SHADER, description.vertex);
        if (!description.geometry.empty()) stage(GL_GEOMETRY_SHADER, description.geometry);
        if (!description.fragment.empty()) stage(GL_FRAGMENT_SHADER, description.fragment);
        if (!description.compute.empty()) stage(GL_COMPUTE_SHADER, description.compute);
    } catch (...) {
        glDeleteProgram(program);
        throw;
    }
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return program;
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    glDeleteProgram(program);
    throw Error(fmt::format("shaders/{}: does not link: {}", description.stages().front(), firstLine(log)));
}

}  // namespace

std::vector<std::string> ProgramDescription::stages() const {
    std::vector<std::string> all;
    for (const std::string* path : {&vertex, &geometry, &fragment, &compute})
        if (!path->empty()) all.push_back(*path);
    return all;
}

Program::Program(const ProgramDescription& description) : Object(link(description)) {
    label(GL_PROGRAM, name(), description.label);
    if (std::find(built().begin(), built().end(), description) == built().end()) built().push_back(description);
}

const std::vector<ProgramDescription>& programsBuilt() { return built(); }

}  // namespace timeshade::gl
