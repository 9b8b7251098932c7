#include "parity/compute.h"

#include <bit>
#include <cmath>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/shader_source.h"

namespace timeshade {

namespace {

class ComputeProgram : public gl::Object<gl::DeleteProgram> {
  public:
    explicit ComputeProgram(const std::string& text) : Object(link(text)) {}

  private:
    static GLuint link(const std::string& text) {
        const char* source = text.c_str();
        const GLuint program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source);
        GLint linked = GL_FALSE;
        glGetProgramiv(program, GL_LINK_STATUS, &linked);
        if (linked == GL_TRUE) return program;
        std::string log(4096, '\0');
        glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
        glDeleteProgram(program);
        throw std::runtime_error(std::string(log.c_str()) + "\n" + text);
    }
};

constexpr unsigned groupSize = 64;

}  // namespace

std::vector<std::uint32_t> runOnGpu(const std::string& header, const std::string& body, const std::vector<float>& input,
                                    unsigned inputsPerItem, unsigned outputsPerItem) {
    const auto items = static_cast<unsigned>(input.size() / inputsPerItem);
    const std::string text =
        gl::readShader(header, {}).text + fmt::format(R"(
layout(local_size_x = {0}) in;
layout(std430, binding = 0) readonly buffer Inputs {{ float inputs[]; }};
layout(std430, binding = 1) writeonly buffer Outputs {{ uint outputs[]; }};
uint item;
float in_(int j) {{ return inputs[item * {2}u + uint(j)]; }}
vec2 in2(int j) {{ return vec2(in_(2 * j), in_(2 * j + 1)); }}
vec3 in3(int j) {{ return vec3(in_(3 * j), in_(3 * j + 1), in_(3 * j + 2)); }}
void put(int j, uint value) {{ outputs[item * {3}u + uint(j)] = value; }}
void put(int j, float value) {{ put(j, floatBitsToUint(value)); }}
void main() {{
    item = gl_GlobalInvocationID.x;
    if (item >= {1}u) return;
    {4}
}}
)",
                                                      groupSize, items, inputsPerItem, outputsPerItem, body);
    const ComputeProgram program(text);
    const gl::Buffer in("parity inputs", std::span<const float>(input));
    std::vector<std::uint32_t> output(static_cast<std::size_t>(items) * outputsPerItem);
    const gl::Buffer out("parity outputs", std::span<const std::uint32_t>(output));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out.name());
    glUseProgram(program.name());
    glDispatchCompute((items + groupSize - 1) / groupSize, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(out.name(), 0, static_cast<GLsizeiptr>(output.size() * sizeof(std::uint32_t)),
                            output.data());
    glUseProgram(0);
    return output;
}

std::uint64_t ulpsApart(float a, float b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b) ? 0 : ~std::uint64_t{0};
    const auto onLine = [](float x) {
        const auto bits = std::bit_cast<std::int32_t>(x);
        return bits < 0 ? -static_cast<std::int64_t>(bits & 0x7fffffff) : static_cast<std::int64_t>(bits);
    };
    const std::int64_t difference = onLine(a) - onLine(b);
    return static_cast<std::uint64_t>(difference < 0 ? -difference : difference);
}

}  // namespace timeshade
