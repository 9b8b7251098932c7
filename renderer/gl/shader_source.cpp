#include "gl/shader_source.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include "core/data_folder.h"
#include "core/error.h"
#include "core/file_bytes.h"

namespace timeshade::gl {

namespace {

// Many times what any shader needs. Files include each other by recursion, so that a chain without end would end the
// program by its stack.
constexpr std::size_t mostFiles = 256;
constexpr std::size_t mostBytes = std::size_t{4} << 20;

class Expander {
  public:
    explicit Expander(ShaderSource& out) : out_(out) {}

    void file(const std::string& path, const std::string& includedBy) {
        if (std::find(out_.files.begin(), out_.files.end(), path) != out_.files.end()) return;
        if (out_.files.size() >= mostFiles)
            throw Error(fmt::format("{}: is included by {} as file {} of one shader; expected at most {}",
                                    (shaderDirectory() / path).string(), includedBy, mostFiles + 1, mostFiles));
        std::istringstream stream(textOf(path, includedBy));
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
    /// Counts what is read.
    std::string textOf(const std::string& path, const std::string& includedBy) {
        try {
            std::string text = readFileText(shaderDirectory() / path, mostBytes - read_);
            read_ += text.size();
            return text;
        } catch (const Error& error) {
            throw Error(fmt::format("{}{}; expected a shader file, of at most {} bytes with all that it includes",
                                    error.what(), includedBy.empty() ? "" : " (included by " + includedBy + ")",
                                    mostBytes));
        }
    }

    static std::string includedPath(const std::string& line) {
        const std::string_view directive = "#include \"";
        if (line.compare(0, directive.size(), directive) != 0) return {};
        const std::size_t end = line.find('"', directive.size());
        return end == std::string::npos ? std::string{} : line.substr(directive.size(), end - directive.size());
    }

    ShaderSource& out_;
    std::size_t read_ = 0;  ///< bytes
};

}  // namespace

std::filesystem::path shaderDirectory() {
    if (const char* folder = std::getenv("TIMESHADE_SHADERS")) return folder;
    return dataFolder() / "shaders";
}

ShaderSource readShader(std::string_view path, const ShaderDefines& defines) {
    ShaderSource source;
    source.text = "#version 450 core\n";
    for (const auto& [name, value] : defines) source.text += fmt::format("#define {} {}\n", name, value);
    Expander(source).file(std::string(path), "");
    return source;
}

}  // namespace timeshade::gl
