#include "gl/program.h"

#include <algorithm>
#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "core/error.h"
#include "gl/first_use.h"

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

/// Adds the names that the text declares as uniforms of their own, and apart those whose declaration has a binding.
void addDeclared(const std::string& text, std::set<std::string>& names, std::set<std::string>& bound) {
    std::istringstream lines(text);
    static constexpr std::string_view word = "uniform ";
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find(word), end = line.find(';');
        if (at == std::string::npos || end == std::string::npos || end < at || line.find('{') != std::string::npos)
            continue;
        const std::size_t first = line.find_last_of(' ', end) + 1;
        const std::string name = line.substr(first, end - first);
        names.insert(name);
        if (const std::size_t binding = line.find("binding"); binding < at) bound.insert(name);
    }
}

bool isImage(GLenum type) { return type >= GL_IMAGE_1D && type <= GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY; }

bool isSampler(GLenum type) {
    const auto between = [&](GLenum first, GLenum last) { return type >= first && type <= last; };
    const bool vector = between(GL_UNSIGNED_INT_VEC2, GL_UNSIGNED_INT_VEC4);
    return !vector && (between(GL_SAMPLER_1D, GL_SAMPLER_2D_RECT_SHADOW) ||
                       between(GL_SAMPLER_1D_ARRAY, GL_UNSIGNED_INT_SAMPLER_BUFFER));
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

Program::Program(const ProgramDescription& description) : Object(link(description)), label_(description.label) {
    label(GL_PROGRAM, name(), description.label);
    std::set<std::string> bound;
    for (const std::string& stage : description.stages())
        addDeclared(readShader(stage, description.defines).text, declared_, bound);
    findUniforms(bound);
    linked(name(), description.label);
    if (std::find(built().begin(), built().end(), description) == built().end()) built().push_back(description);
}

void Program::findUniforms(const std::set<std::string>& bound) {
    GLint count = 0;
    glGetProgramiv(name(), GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        char text[128];
        GLsizei length = 0;
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(name(), static_cast<GLuint>(i), sizeof text, &length, &size, &type, text);
        Uniform found{glGetUniformLocation(name(), text), 0, isImage(type), isImage(type) || isSampler(type)};
        if (found.location >= 0) uniforms_.emplace(std::string(text, static_cast<std::size_t>(length)), found);
    }
    GLint unit = firstFreeUnit, image = 0;
    for (auto& [text, uniform] : uniforms_) {
        if (!uniform.texture) continue;
        GLint current = 0;
        glGetUniformiv(name(), uniform.location, &current);
        if (bound.count(text) == 0) {
            current = uniform.image ? image++ : unit++;
            glProgramUniform1i(name(), uniform.location, current);
        }
        uniform.unit = static_cast<GLuint>(current);
    }
}

const Program::Uniform* Program::uniform(const std::string& input) const {
    const auto found = uniforms_.find(input);
    if (found != uniforms_.end()) return &found->second;
    if (declared_.count(input) == 0) throw Error(fmt::format("program '{}' has no input '{}'", label_, input));
    return nullptr;
}

void Program::set(const std::string& input, const Inputs::Value& value) const {
    const Uniform* found = uniform(input);
    if (found == nullptr) return;
    const GLint at = found->location;
    if (const auto* number = std::get_if<float>(&value)) glProgramUniform1f(name(), at, *number);
    if (const auto* number = std::get_if<std::int32_t>(&value)) glProgramUniform1i(name(), at, *number);
    if (const auto* number = std::get_if<std::uint32_t>(&value)) glProgramUniform1ui(name(), at, *number);
    if (const auto* vector = std::get_if<glm::vec3>(&value)) glProgramUniform3fv(name(), at, 1, &vector->x);
    if (const auto* matrix = std::get_if<glm::mat3>(&value))
        glProgramUniformMatrix3fv(name(), at, 1, GL_FALSE, &(*matrix)[0][0]);
}

void Program::bindTexture(const std::string& input, const Texture& texture) const {
    const Uniform* found = uniform(input);
    if (found == nullptr) return;
    if (found->image)
        glBindImageTexture(found->unit, texture.name(), 0, GL_TRUE, 0, GL_READ_WRITE, texture.format());
    else
        texture.bind(found->unit);
}

void Program::use(const Inputs& inputs) const {
    use();
    for (const auto& [input, value] : inputs.values()) set(input, value);
    for (const auto& [input, texture] : inputs.textures()) bindTexture(input, *texture);
}

const std::vector<ProgramDescription>& programsBuilt() { return built(); }

}  // namespace timeshade::gl
