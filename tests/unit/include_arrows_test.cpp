// Which layer may include which (docs/architecture.md), enforced by reading every #include line.
#include <gtest/gtest.h>

#include <timeshade/paths.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "techniques/registry.h"

namespace timeshade {
namespace {

namespace fs = std::filesystem;

const fs::path root = TIMESHADE_SOURCE_DIRECTORY;

struct Include {
    std::string file;  ///< relative to the repository: "renderer/plan/frame_plan.cpp"
    int line = 0;
    std::string target;  ///< as it is written between the quotes or brackets
    bool quoted = false;
};

/// For each folder of renderer/ what it may include, as beginnings of paths. "techniques/*" means the files that lie
/// directly in the folder: the interface and the registry, no technique.
const std::map<std::string, std::vector<std::string>> arrows{
    {"core", {"core/"}},
    {"scene", {"scene/", "image/", "core/"}},
    {"scenes", {"scenes/", "scene/", "core/", "shared/"}},
    {"image", {"image/", "core/"}},
    {"chart", {"chart/", "image/", "core/"}},
    {"plan", {"plan/", "scene/", "core/", "shared/"}},
    {"culling", {"culling/", "plan/", "scene/", "core/", "shared/"}},
    // What techniques state is plain data, without OpenGL.
    {"cases", {"cases/", "plan/", "scene/", "core/", "shared/", "technique/prediction.h"}},
    {"oracle", {"oracle/", "plan/", "scene/", "core/", "shared/"}},
    {"gl", {"gl/", "core/", "shared/"}},
    {"passes", {"passes/", "gl/", "plan/", "scene/", "core/", "shared/"}},
    {"technique", {"technique/", "culling/", "passes/", "gl/", "plan/", "scene/", "core/", "shared/"}},
    {"techniques", {"techniques/*", "technique/", "culling/", "passes/", "gl/", "plan/", "scene/", "core/", "shared/"}},
    {"frame",
     {"frame/", "technique/", "techniques/registry.h", "passes/", "gl/", "plan/", "scene/", "image/", "core/",
      "shared/"}},
    {"measure",
     {"measure/", "oracle/", "cases/", "chart/", "frame/", "technique/", "techniques/registry.h", "passes/", "gl/",
      "plan/", "scene/", "image/", "core/", "shared/"}},
};

/// Headers of libraries, by the beginning of their names, and the folders that may include them.
const std::vector<std::pair<std::string, std::vector<std::string>>> libraries{
    {"glad/",
     {"renderer/gl/", "renderer/passes/", "renderer/technique/", "renderer/techniques/", "renderer/frame/", "app/"}},
    {"GL/", {}},
    {"EGL/", {"app/contexts/"}},
    {"GLFW/", {"app/"}},
    {"X11/", {}},
    {"imgui", {"app/"}},
    {"CLI/", {"app/"}},
    {"tiny_gltf", {"renderer/scene/"}},
    {"tinyexr", {"renderer/image/"}},
    {"stb_", {"renderer/image/", "renderer/chart/"}},
    {"png.h", {"renderer/image/"}},
    {"jpeglib", {"renderer/image/"}},
    {"jerror", {"renderer/image/"}},
    {"embree", {"renderer/oracle/", "renderer/measure/"}},
    {"tbb", {"renderer/oracle/"}},
    {"gtest", {}},
    {"rapidcheck", {}},
    // A frame is drawn from its plan alone: no clock and no random numbers but the plan's.
    {"chrono", {"renderer/gl/", "renderer/measure/", "renderer/oracle/", "app/"}},
    {"ctime", {"app/"}},
    {"random", {}},
};

bool startsWith(const std::string& text, const std::string& beginning) { return text.rfind(beginning, 0) == 0; }

/// The parts of a path: "techniques/tsm/tsm_shadow.h" has three.
std::vector<std::string> partsOf(const std::string& path) {
    std::vector<std::string> parts;
    std::istringstream stream(path);
    for (std::string part; std::getline(stream, part, '/');) parts.push_back(part);
    return parts;
}

bool allowedBy(const std::vector<std::string>& rules, const std::string& target) {
    return std::any_of(rules.begin(), rules.end(), [&](const std::string& rule) {
        if (rule.back() == '*')
            return startsWith(target, rule.substr(0, rule.size() - 1)) && partsOf(target).size() == 2;
        return startsWith(target, rule);
    });
}

std::optional<std::string> rendererComplaint(const Include& include) {
    const std::vector<std::string> parts = partsOf(include.file);
    const auto rules = arrows.find(parts[1]);
    if (rules == arrows.end()) return "renderer/" + parts[1] + " is no layer of the design";
    const bool inTechnique = parts[1] == "techniques" && parts.size() > 3;
    if (inTechnique && startsWith(include.target, "techniques/" + parts[2] + "/")) return std::nullopt;
    // The registry is the one place that includes every technique.
    if (include.file == "renderer/techniques/registry.cpp" && startsWith(include.target, "techniques/"))
        return std::nullopt;
    if (inTechnique && startsWith(include.target, "techniques/registry")) return "a technique includes no other";
    if (allowedBy(rules->second, include.target)) return std::nullopt;
    return "renderer/" + parts[1] + " may not include it";
}

std::optional<std::string> shaderComplaint(const Include& include) {
    const std::vector<std::string> parts = partsOf(include.file);
    std::vector<std::string> rules{"shared/"};
    if (parts[1] != "shared") rules.push_back("lib/");
    if (parts[1] == "techniques") rules.push_back("techniques/" + parts[2] + "/");
    if (allowedBy(rules, include.target)) return std::nullopt;
    return "shaders/" + parts[1] + " may not include it";
}

/// Why a file may not have this include; nothing if it may.
std::optional<std::string> complaintAbout(const Include& include) {
    if (!include.quoted) {
        for (const auto& [beginning, folders] : libraries) {
            const bool exact = beginning == "chrono" || beginning == "ctime" || beginning == "random";
            if (exact ? include.target != beginning : !startsWith(include.target, beginning)) continue;
            const bool allowed = std::any_of(folders.begin(), folders.end(),
                                             [&](const std::string& f) { return startsWith(include.file, f); });
            if (!allowed) return "the library does not belong there";
        }
        return std::nullopt;
    }
    if (include.target.find("..") != std::string::npos) return "paths start at a layer";
    if (startsWith(include.file, "renderer/")) return rendererComplaint(include);
    if (startsWith(include.file, "shaders/")) return shaderComplaint(include);
    return std::nullopt;  // the application may include everything
}

/// The file that a quoted include means, or nothing.
std::optional<fs::path> resolve(const Include& include) {
    const std::vector<fs::path> places{root / "renderer", root / "shaders", root / "app",
                                       (root / include.file).parent_path()};
    for (const fs::path& place : places)
        if (fs::is_regular_file(place / include.target)) return place / include.target;
    return std::nullopt;
}

std::vector<Include> includesOf(const std::string& folder) {
    static const std::regex directive(R"(^\s*#\s*include\s*(["<])([^">]+)[">].*$)");
    std::vector<Include> includes;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
        static const std::set<std::string> kinds{".h", ".cpp", ".glsl", ".vert", ".frag", ".comp", ".geom"};
        if (!entry.is_regular_file() || kinds.count(entry.path().extension().string()) == 0) continue;
        std::ifstream stream(entry.path());
        std::string text;
        for (int line = 1; std::getline(stream, text); ++line) {
            std::smatch match;
            if (!std::regex_match(text, match, directive)) continue;
            includes.push_back(
                {fs::relative(entry.path(), root).string(), line, match[2].str(), match[1].str() == "\""});
        }
    }
    return includes;
}

std::string where(const Include& include) {
    return include.file + ":" + std::to_string(include.line) + " includes " + include.target;
}

TEST(IncludeArrows, NoFileIncludesMoreThanItsLayerMay) {
    std::size_t seen = 0;
    for (const char* folder : {"renderer", "shaders", "app"}) {
        for (const Include& include : includesOf(folder)) {
            ++seen;
            const std::optional<std::string> complaint = complaintAbout(include);
            EXPECT_FALSE(complaint) << where(include) << ": " << complaint.value_or("");
        }
    }
    EXPECT_GT(seen, 300u) << "most includes were not found";
}

TEST(IncludeArrows, EveryQuotedIncludeIsAFileOfOurs) {
    for (const char* folder : {"renderer", "shaders", "app"})
        for (const Include& include : includesOf(folder))
            EXPECT_TRUE(!include.quoted || resolve(include)) << where(include) << ": there is no such file";
}

TEST(IncludeArrows, ShadersNeedNoSystemHeaders) {
    // C++ alone sees the one exception: types.shared.h takes GLM in behind #ifdef __cplusplus.
    for (const Include& include : includesOf("shaders"))
        EXPECT_TRUE(include.quoted || include.file == "shaders/shared/types.shared.h") << where(include);
}

/// The sources that app/CMakeLists.txt gives to a target.
std::vector<std::string> sourcesOf(const std::string& target) {
    std::ifstream stream(root / "app" / "CMakeLists.txt");
    std::stringstream text;
    text << stream.rdbuf();
    const std::string all = text.str();
    std::vector<std::string> sources;
    const std::size_t begin = all.find("add_library(" + target + " ");
    if (begin == std::string::npos) return sources;
    std::istringstream words(all.substr(begin, all.find(')', begin) - begin));
    for (std::string word; words >> word;)
        if (word.ends_with(".cpp") || word.ends_with(".h")) sources.push_back(word);
    return sources;
}

TEST(IncludeArrows, HeadlessWorkReachesNoWindow) {
    std::set<std::string> headless;
    for (const std::string& source : sourcesOf("timeshade_headless")) headless.insert("app/" + source);
    ASSERT_TRUE(headless.count("app/shot.cpp"));
    for (const fs::directory_entry& entry : fs::directory_iterator(root / "app" / "contexts")) {
        const std::string name = entry.path().filename().string();
        if (name.rfind("window_context", 0) != 0) headless.insert("app/contexts/" + name);
    }
    ASSERT_TRUE(headless.count("app/contexts/egl_context.cpp"));
    for (const Include& include : includesOf("app")) {
        std::string source = include.file;
        if (source.ends_with(".h")) source = source.substr(0, source.size() - 2) + ".cpp";
        if (headless.count(source) == 0 && headless.count(include.file) == 0) continue;
        EXPECT_FALSE(startsWith(include.target, "GLFW/") || startsWith(include.target, "imgui") ||
                     startsWith(include.target, "panels/") || startsWith(include.target, "interactive"))
            << where(include);
        // A hidden window is one of the contexts that can be requested, made in one place.
        EXPECT_TRUE(!startsWith(include.target, "contexts/window_context") || include.file == "app/make_context.cpp")
            << where(include);
    }
}

std::set<std::string> foldersIn(const fs::path& path) {
    std::set<std::string> names;
    if (!fs::is_directory(path)) return names;
    for (const fs::directory_entry& entry : fs::directory_iterator(path))
        if (entry.is_directory()) names.insert(entry.path().filename().string());
    return names;
}

TEST(IncludeArrows, TechniquesHaveTheirFoldersAndNothingElseHas) {
    const std::set<std::string> sources = foldersIn(root / "renderer" / "techniques"),
                                shaders = foldersIn(root / "shaders" / "techniques");
    std::set<std::string> registered;
    for (const TechniqueDescription& description : techniqueDescriptions()) registered.insert(description.name);
    EXPECT_EQ(sources, registered) << "folders in renderer/techniques, names in the registry";
    // A technique that draws with shaders of passes/ alone has no folder there.
    for (const std::string& name : shaders)
        EXPECT_TRUE(sources.count(name)) << "shaders/techniques/" << name << " has no technique";
}

TEST(IncludeArrows, TheRulesRefuseWhatTheyShould) {
    const auto refused = [](const std::string& file, const std::string& target, bool quoted = true) {
        return complaintAbout({file, 1, target, quoted}).has_value();
    };
    EXPECT_TRUE(refused("renderer/scene/a.cpp", "gl/buffer.h"));
    EXPECT_TRUE(refused("renderer/scene/a.cpp", "plan/frame_plan.h"));
    EXPECT_TRUE(refused("renderer/plan/a.h", "passes/gpu_mesh.h"));
    EXPECT_TRUE(refused("renderer/plan/a.h", "glad/gl.h", false));
    EXPECT_TRUE(refused("renderer/oracle/a.cpp", "technique/technique.h"));
    EXPECT_TRUE(refused("renderer/oracle/a.cpp", "gl/buffer.h"));
    EXPECT_TRUE(refused("renderer/image/a.cpp", "scene/scene.h"));
    EXPECT_FALSE(refused("renderer/image/a.cpp", "core/error.h"));
    EXPECT_TRUE(refused("renderer/gl/a.cpp", "passes/fullscreen.h"));
    EXPECT_TRUE(refused("renderer/gl/a.cpp", "plan/frame_plan.h"));
    EXPECT_TRUE(refused("renderer/passes/a.cpp", "technique/technique.h"));
    EXPECT_TRUE(refused("renderer/techniques/tsm/a.cpp", "techniques/static/static_shadow.h"));
    EXPECT_TRUE(refused("renderer/techniques/tsm/a.cpp", "techniques/registry.h"));
    EXPECT_TRUE(refused("renderer/techniques/tsm/a.cpp", "oracle/oracle.h"));
    EXPECT_TRUE(refused("renderer/techniques/tsm/a.cpp", "random", false));
    EXPECT_TRUE(refused("renderer/techniques/tsm/a.cpp", "chrono", false));
    EXPECT_TRUE(refused("renderer/technique/technique.h", "techniques/tsm/tsm_shadow.h"));
    EXPECT_FALSE(refused("renderer/techniques/tsm/a.cpp", "techniques/tsm/tsm_shadow.h"));
    EXPECT_FALSE(refused("renderer/techniques/tsm/a.cpp", "technique/technique.h"));
    EXPECT_FALSE(refused("renderer/techniques/registry.cpp", "techniques/tsm/tsm_shadow.h"));
    EXPECT_TRUE(refused("renderer/technique/a.cpp", "techniques/tsm/tsm_shadow.h"));
    EXPECT_TRUE(refused("renderer/technique/a.cpp", "frame/frame_renderer.h"));
    EXPECT_TRUE(refused("renderer/plan/a.cpp", "culling/closed_surfaces.h"));
    EXPECT_TRUE(refused("renderer/core/a.cpp", "scene/scene.h"));
    EXPECT_TRUE(refused("renderer/frame/a.cpp", "techniques/tsm/tsm_shadow.h"));
    EXPECT_TRUE(refused("renderer/frame/a.cpp", "options/command.h"));
    EXPECT_TRUE(refused("renderer/frame/a.cpp", "imgui.h", false));
    EXPECT_TRUE(refused("renderer/gl/a.cpp", "GLFW/glfw3.h", false));
    EXPECT_TRUE(refused("renderer/measure/a.cpp", "techniques/tsm/tsm_shadow.h"));
    EXPECT_TRUE(refused("renderer/helpers/a.cpp", "scene/scene.h"));
    EXPECT_TRUE(refused("renderer/plan/a.cpp", "../gl/buffer.h"));
    EXPECT_TRUE(refused("shaders/shared/a.shared.h", "lib/receiver.glsl"));
    EXPECT_TRUE(refused("shaders/lib/a.glsl", "passes/shade.frag"));
    EXPECT_TRUE(refused("shaders/techniques/tsm/a.frag", "techniques/static/b.glsl"));
    EXPECT_FALSE(refused("shaders/techniques/tsm/a.frag", "techniques/tsm/b.glsl"));
}

}  // namespace
}  // namespace timeshade
