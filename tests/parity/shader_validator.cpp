#include "shader_validator.h"

#include <list>
#include <optional>

#include <glslang/Include/ResourceLimits.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

namespace timeshade {

namespace {

/// The tables of built-in functions are made once a process. As a program of its own, the compiler makes them for each
/// program that it is given, which takes some fifty times as long as all the rest.
struct Compiler {
    Compiler() { glslang::InitializeProcess(); }
    ~Compiler() { glslang::FinalizeProcess(); }
    Compiler(const Compiler&) = delete;
    Compiler& operator=(const Compiler&) = delete;
};

std::optional<EShLanguage> languageOf(const std::string& stage) {
    if (stage == "vert") return EShLangVertex;
    if (stage == "geom") return EShLangGeometry;
    if (stage == "frag") return EShLangFragment;
    if (stage == "comp") return EShLangCompute;
    return {};
}

}  // namespace

ShaderVerdict validateShaders(const std::vector<std::pair<std::string, std::string>>& stages) {
    static const Compiler compiler;
    constexpr int versionWithoutDirective = 100;
    ShaderVerdict verdict{true, ""};
    std::list<glslang::TShader> shaders;  // outlive the program, and do not move
    glslang::TProgram program;
    for (const auto& [stage, text] : stages) {
        const std::optional<EShLanguage> language = languageOf(stage);
        if (!language) return {false, "no stage is called " + stage};
        glslang::TShader& shader = shaders.emplace_back(*language);
        const char* const string = text.c_str();
        shader.setStrings(&string, 1);
        if (!shader.parse(GetDefaultResources(), versionWithoutDirective, false, EShMsgDefault)) verdict.good = false;
        verdict.words += shader.getInfoLog();
        program.addShader(&shader);
    }
    if (!verdict.good) return verdict;
    verdict.good = program.link(EShMsgDefault);
    verdict.words += program.getInfoLog();
    return verdict;
}

}  // namespace timeshade
