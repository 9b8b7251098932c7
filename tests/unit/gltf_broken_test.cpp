// Whatever a file holds: a scene, or an Error of one line. Never a crash, a hang or a flood of memory.

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "../broken_gltf/broken_files.h"
#include "core/error.h"
#include "scene/gltf_scene.h"

namespace timeshade {
namespace {

using namespace test;
namespace fs = std::filesystem;

/// The message with which the file is refused; empty where it loads.
std::string refusal(const fs::path& path) {
    try {
        const auto scene = loadGltf(path);
        const MotionMesh mesh = scene->motionMesh(0.5, 0.6);
        EXPECT_FALSE(scene->bounds().empty());
        EXPECT_EQ(mesh.positionsOpen.size(), mesh.topology->vertexCount);
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

void expectOneClearLine(const std::string& message, const std::string& fileName) {
    EXPECT_NE(message.find(fileName), std::string::npos) << message;
    EXPECT_EQ(message.find_first_of("\n\r\t"), std::string::npos) << message;
    EXPECT_LE(message.size(), 300u) << message;
    EXPECT_GT(message.size(), fileName.size() + 8) << message;
}

/// Peak resident memory of this process so far, in MiB.
double peakMiB() {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word)
        if (word == "VmHWM:") {
            double kib = 0.0;
            status >> kib;
            return kib / 1024.0;
        }
    return 0.0;
}

void expectAllRefused(const std::vector<BrokenFile>& files) {
    const TemporaryFolder folder;
    const double before = peakMiB();
    for (const BrokenFile& file : files) {
        SCOPED_TRACE(file.name);
        const std::string message = refusal(folder.write("broken.glb", file.bytes));
        EXPECT_NE(message, "") << "it loads";
        expectOneClearLine(message, "broken.glb");
        EXPECT_NE(message.find(file.expected), std::string::npos) << message << "\n  expected: " << file.expected;
    }
    EXPECT_LT(peakMiB() - before, 500.0);  // the largest of these files has some hundred kilobytes
}

TEST(BrokenGltf, TheFileTheyStartFromIsValid) {
    const TemporaryFolder folder;
    EXPECT_EQ(refusal(folder.write("valid.glb", fileWithEverything().glb())), "");
}

TEST(BrokenGltf, ContainersAreRefused) { expectAllRefused(brokenContainers()); }
TEST(BrokenGltf, IndicesAreRefused) { expectAllRefused(brokenIndices()); }
TEST(BrokenGltf, ReferencesAreRefused) { expectAllRefused(brokenReferences()); }
TEST(BrokenGltf, ContentsAreRefused) { expectAllRefused(brokenContents()); }
TEST(BrokenGltf, ShapesAreRefused) { expectAllRefused(brokenShapes()); }

TEST(BrokenGltf, EveryTruncationIsRefused) {
    const TemporaryFolder folder;
    const ByteList whole = fileWithEverything().glb();
    for (std::size_t length = 0; length + 4 < whole.size(); length += 37) {
        const std::string message = refusal(folder.write("cut.glb", cut(whole, length)));
        EXPECT_NE(message, "") << length;
        expectOneClearLine(message, "cut.glb");
    }
}

TEST(BrokenGltf, BuffersComeFromTheModelsFolderOnly) {
    const TemporaryFolder outer;
    const GltfFile file = fileWithEverything();
    outer.write("outside.bin", file.data);
    const fs::path folder = outer.path() / "model";
    fs::create_directories(folder / "a folder");
    fs::create_symlink(outer.path() / "outside.bin", folder / "escape.bin");
    fs::create_directory_symlink(outer.path(), folder / "up");
    fs::create_symlink("loop.bin", folder / "loop.bin");
    ASSERT_EQ(::mkfifo((folder / "pipe.bin").c_str(), 0600), 0);
    fs::create_symlink("/dev/zero", folder / "device.bin");

    const std::vector<std::string> uris{"../outside.bin",
                                        "%2e%2e/outside.bin",
                                        "a%2f..%2f../outside.bin",
                                        outer.path() / "outside.bin",
                                        "file://" + (outer.path() / "outside.bin").string(),
                                        "http://localhost/x.bin",
                                        "up/outside.bin",
                                        "escape.bin",
                                        "loop.bin",
                                        "pipe.bin",
                                        "device.bin",
                                        "a folder",
                                        ".",
                                        "",
                                        "missing.bin",
                                        "..\\outside.bin",
                                        "escape.bin%00.bin",
                                        "/dev/zero",
                                        std::string(5000, 'x')};
    for (const std::string& uri : uris) {
        SCOPED_TRACE(uri);
        Json json = file.json;
        json["buffers"] = Json::array({{{"byteLength", file.data.size()}, {"uri", uri}}});
        std::ofstream(folder / "model.gltf") << json.dump();
        const std::string message = refusal(folder / "model.gltf");
        EXPECT_NE(message, "") << "it loads";
        EXPECT_NE(message.find("buffer 0"), std::string::npos) << message;
        expectOneClearLine(message, "model.gltf");
    }
}

TEST(BrokenGltf, BuffersInsideTheFolderLoad) {
    const TemporaryFolder folder;
    const GltfFile file = fileWithEverything();
    fs::create_directories(folder.path() / "data");
    folder.write("data/the buffer.bin", file.data);
    EXPECT_EQ(refusal(file.saveSplit(folder, "model.gltf", "data/the%20buffer.bin")), "");
    folder.write("short.bin", cut(file.data, 50));
    EXPECT_NE(refusal(file.saveSplit(folder, "short.gltf", "short.bin")).find("there are 50"), std::string::npos);
}

TEST(BrokenGltf, WhatIsNoFileIsRefused) {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "folder.glb");
    ASSERT_EQ(::mkfifo((folder.path() / "pipe.glb").c_str(), 0600), 0);
    for (const char* name : {"folder.glb", "pipe.glb", "missing.glb"})
        expectOneClearLine(refusal(folder.path() / name), name);
    expectOneClearLine(refusal("/dev/zero"), "/dev/zero");
}

/// A chain of nodes, the last of which carries a quad and each of which moves a little.
TEST(BrokenGltf, DeepChainsOfNodesWork) {
    constexpr int depth = 20'000;
    GltfFile file;
    addQuad(file);
    for (int i = 0; i < depth; ++i) {
        file.add("nodes", {{"translation", {0.001, 0, 0}}});
        if (i + 1 < depth) file.json["nodes"][static_cast<std::size_t>(i)]["children"] = {i + 1};
    }
    file.json["nodes"][depth - 1]["mesh"] = 0;
    file.json["scenes"] = Json::array({{{"nodes", {0}}}});
    const TemporaryFolder folder;
    const auto scene = loadGltf(folder.write("chain.glb", file.glb()));
    EXPECT_NEAR(scene->bounds().low.x, 0.001 * depth, 1e-6);
}

/// What a few bytes of JSON name again and again is read once.
TEST(BrokenGltf, RepetitionCostsNoMemory) {
    GltfFile file;
    addQuad(file);
    file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}});
    const int keys = 20'000;
    std::vector<float> times;
    for (int i = 0; i < keys; ++i) times.push_back(static_cast<float>(i));
    const int output = file.vec3s(std::vector<float>(3 * keys));
    const int input = file.scalars(times);
    for (int i = 0; i < 10'000; ++i) {
        const int node = file.addRoot({{"mesh", 0}, {"camera", 0}, {"name", "same"}});
        file.json["animations"][0]["samplers"].push_back({{"input", input}, {"output", output}});
        file.json["animations"][0]["channels"].push_back(
            {{"sampler", i}, {"target", {{"node", node}, {"path", "translation"}}}});
    }
    const TemporaryFolder folder;
    const auto path = folder.write("repeated.glb", file.glb());
    const double before = peakMiB();
    const auto scene = loadGltf(path);
    EXPECT_EQ(scene->cameras().back().name, "same 10000");
    EXPECT_LT(peakMiB() - before, 500.0);  // the keys alone would take 3 GB if every channel had its own
}

TEST(BrokenGltf, LimitsAreTheCallersToSet) {
    const TemporaryFolder folder;
    const fs::path path = folder.write("valid.glb", fileWithEverything().glb());
    EXPECT_THROW(loadGltf(path, {.maxTriangles = 5}), Error);
    EXPECT_THROW(loadGltf(path, {.maxBufferBytes = 100}), Error);
}

std::string imageNote(const Json& image, const std::string& bytesInView = "") {
    GltfFile file = fileWithEverything();
    file.json["images"][0] = image;
    if (!bytesInView.empty())
        file.json["images"][0] = {{"bufferView", file.addView(bytesInView.data(), bytesInView.size())}};
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "a folder");
    const auto scene = loadGltf(folder.write("image.glb", file.glb()));
    EXPECT_TRUE(scene->images().empty());
    EXPECT_EQ(scene->materials().at(0).baseColor.image, -1);
    for (const std::string& note : scene->notes())
        if (note.find("image") != std::string::npos) return note;
    return "";
}

/// A PNG's signature and header chunk, and nothing more.
std::string pngHeader(std::uint32_t width, std::uint32_t height) {
    std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    for (const std::uint32_t value : {width, height})
        for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>((value >> shift) & 0xffu));
    return bytes + std::string("\x08\x06\0\0\0\0\0\0\0", 9);
}

TEST(BrokenGltf, BadImagesCostTheTextureOnly) {
    const double before = peakMiB();
    EXPECT_NE(imageNote({{"uri", "data:image/png;base64,iVBORw0KGgo="}}).find("is left out"), std::string::npos);
    EXPECT_NE(imageNote({{"uri", "missing.png"}}).find("no such file"), std::string::npos);
    EXPECT_NE(imageNote({{"uri", "../x.png"}}).find("inside the model's folder"), std::string::npos);
    EXPECT_NE(imageNote({{"uri", "a folder"}}).find("is a folder"), std::string::npos);
    EXPECT_NE(imageNote(Json::object()).find("is left out"), std::string::npos);
    EXPECT_NE(imageNote({}, "GIF89a and more").find("neither PNG nor JPEG"), std::string::npos);
    EXPECT_NE(imageNote({}, std::string("\xff\xd8\xff\xe0 broken")).find("is left out"), std::string::npos);
    EXPECT_NE(imageNote({}, pngHeader(1'000'000, 1'000'000)).find("is left out"), std::string::npos);
    EXPECT_NE(imageNote({}, pngHeader(16'000, 2)).find("limit is 8192"), std::string::npos);
    EXPECT_NE(imageNote({}, pngHeader(8192, 8192)).find("cannot hold"), std::string::npos);
    EXPECT_LT(peakMiB() - before, 500.0);
}

}  // namespace
}  // namespace timeshade
