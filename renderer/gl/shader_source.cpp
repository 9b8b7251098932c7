#include "gl/shader_source.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <timeshade/paths.h>

#include "core/error.h"

namespace timeshade::gl {

namespace {

class Expander {
  public:
    explicit Expander(ShaderSource& out) : out_(out) {}

    void file(const std::string& path, const std::string& includedBy) {
        if (std::find(out_.files.begin(), out_.files.end(), path) != out_.files.end()) return;
        std::ifstream stream(shaderDirectory() / path);
        if (!stream)
            throw Error(fmt::format("{}: cannot be read{}; expected a shader file", (shaderDirectory() / path).string(),
                                    includedBy.empty() ? "" : " (included by " + includedBy + ")"));
        const std::size_t number = out_.files.size();
        out_.files.push_back(path);
        out_.text += fmt::format("#line 1 {}\n", number);
        std::string line;
        for (int lineNumber = 1; std::getline(stream, line); ++lineNumber) {
            const std::string included = includedPath(line);
            if (included.empty()) {
                out_.text += line + "\n";
                continue;
            }
            file(included, path);
            out_.text += fmt::format("#line {} {}\n", lineNumber + 1, number);
        }
    }

  private:
    static std::string includedPath(const std::string& line) {
        const std::string_view directive = "#include \"";
        if (line.compare(0, directive.size(), directive) != 0) return {};
        const std::size_t end = line.find('"', directive.size());
        return end == std::string::npos ? std::string{} : line.substr(directive.size(), end - directive.size());
    }

    ShaderSource& out_;
};

}  // namespace

std::filesystem::path shaderDirectory() {
    if (const char* folder = std::getenv("TIMESHADE_SHADERS")) return folder;
    return std::filesystem::path(TIMESHADE_SOURCE_DIRECTORY) / "shaders";
}

ShaderSource readShader(std::string_view path, const ShaderDefines& defines) {
    ShaderSource source;
    source.text = "#version 450 core\n";
    for (const auto& [name, value] : defines) source.text += fmt::format("#define {} {}\n", name, value);
    Expander(source).file(std::string(path), "");
    return source;
}

}  // namespace timeshade::gl
