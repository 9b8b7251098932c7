// Real files made by others, against world-space bounds that an independent implementation computed. The files are
// not part of the project: TIMESHADE_SHARED_GLTF names the folder that holds them and expected_bounds.json.

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "scene/gltf_compression.h"
#include "scene/gltf_scene.h"

namespace timeshade {
namespace {

using Json = nlohmann::json;

std::filesystem::path sharedFolder() {
    const char* folder = std::getenv("TIMESHADE_SHARED_GLTF");
    return folder == nullptr ? std::filesystem::path() : std::filesystem::path(folder);
}

struct Summary {
    Bounds bounds;
    glm::dvec3 mean{0.0};
};

Summary summaryOf(const std::vector<glm::dvec3>& positions) {
    Summary summary;
    for (const glm::dvec3& p : positions) {
        summary.bounds.add(p);
        summary.mean += p / static_cast<double>(positions.size());
    }
    return summary;
}

glm::dvec3 vector(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

void expectMatch(const std::vector<glm::dvec3>& positions, const Json& expected, const std::string& what) {
    EXPECT_EQ(positions.size(), expected.at("verts").get<std::size_t>()) << what;
    const Summary found = summaryOf(positions);
    const glm::dvec3 low = vector(expected.at("min"));
    const glm::dvec3 high = vector(expected.at("max"));
    const double tolerance =
        5e-4 * glm::length(high - low);  // the file's numbers have five decimals, its clips single precision
    EXPECT_LE(glm::length(found.bounds.low - low), tolerance) << what;
    EXPECT_LE(glm::length(found.bounds.high - high), tolerance) << what;
    EXPECT_LE(glm::length(found.mean - vector(expected.at("mean"))), tolerance) << what;
}

TEST(SharedGltf, EveryClipAndTimeMatchesTheIndependentBounds) {
    const auto folder = sharedFolder();
    if (!std::filesystem::exists(folder / "expected_bounds.json"))
        GTEST_SKIP() << "TIMESHADE_SHARED_GLTF names no folder with expected_bounds.json";
    std::ifstream file(folder / "expected_bounds.json");
    int samples = 0;
    const Json expected = Json::parse(file);
    for (const auto& model : expected.items()) {
        const auto scene = loadGltf(folder / model.key());
        const Json& clips = model.value().at("animations");
        if (clips.empty())
            expectMatch(scene->motionMesh(0.0, 0.0).positionsOpen, model.value().at("rest"), model.key() + " at rest");
        for (const Json& clip : clips) {
            const auto played = loadGltf(folder / model.key(), {.clip = clip.at("name").get<std::string>()});
            EXPECT_NEAR(played->duration(), clip.at("duration").get<double>(), 1e-4) << model.key();
            const Json& times = clip.at("samples");
            for (std::size_t i = 0; i < times.size(); ++i) {  // each time once as opening, once as closing of a shutter
                const std::string what =
                    model.key() + " " + clip.at("name").get<std::string>() + " t " + times[i].at("t").dump();
                const double t = times[i].at("t").get<double>();
                expectMatch(played->motionMesh(t, t + 0.01).positionsOpen, times[i], what + " open");
                const double before = i > 0 ? times[i - 1].at("t").get<double>() : t;
                expectMatch(played->motionMesh(before, t).positionsClose, times[i], what + " close");
                ++samples;
            }
        }
    }
    EXPECT_GT(samples, 50);
}

/// Where the library for it was there when this was built; else they are refused by name.
TEST(SharedGltf, CompressedFilesOpenOrAreRefusedByName) {
    const auto folder = sharedFolder() / "refuse";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "TIMESHADE_SHARED_GLTF names no folder with refuse/";
    for (const auto& [file, extension] : {std::pair{"heart_draco.glb", "KHR_draco_mesh_compression"},
                                          std::pair{"quantized.glb", "EXT_meshopt_compression"}}) {
        try {
            const auto scene = loadGltf(folder / file);
            EXPECT_TRUE(gltf::decodes(extension)) << file;
            EXPECT_GT(scene->motionMesh(0.0, 0.0).topology->triangles.size(), 100u) << file;
        } catch (const Error& error) {
            EXPECT_FALSE(gltf::decodes(extension)) << error.what();
            EXPECT_NE(std::string(error.what()).find(extension), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
        }
    }
}

TEST(SharedGltf, UnknownClipIsNamedWithTheClipsThereAre) {
    const auto fox = sharedFolder() / "Fox.glb";
    if (!std::filesystem::exists(fox)) GTEST_SKIP() << "TIMESHADE_SHARED_GLTF names no folder with Fox.glb";
    try {
        loadGltf(fox, {.clip = "Fly"});
        FAIL() << "a clip that does not exist was played";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("\"Fly\"; it has: Survey, Walk, Run"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace timeshade
