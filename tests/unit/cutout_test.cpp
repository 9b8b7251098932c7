// Alpha that cuts out parts of a surface: how it is read (the shaders' arithmetic against the oracle's own, and against
// values known by hand), what of a file it comes from, and what of the plan it changes.
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "broken_gltf/gltf_writer.h"
#include "culling/closed_surfaces.h"
#include "oracle/cutout_cover.h"
#include "plan/frame_plan.h"
#include "scene/cutouts.h"
#include "scene/gltf_scene.h"
#include "scenes/mesh_scene.h"
#include "scenes/staging.h"
#include "shared/cutout.shared.h"

namespace timeshade {
namespace {

using test::GltfFile;
using test::Json;
using test::TemporaryFolder;

/// What the shaders do, on the CPU.
float sharedAlpha(const Cutouts::Sheet& sheet, const std::vector<std::uint8_t>& alphas, glm::vec2 coordinates) {
    const std::uint32_t flags = CUTOUT_PRESENT | (sheet.nearest ? CUTOUT_NEAREST : 0u) |
                                static_cast<std::uint32_t>(sheet.wrapU) << TEXTURE_WRAP_U_SHIFT |
                                static_cast<std::uint32_t>(sheet.wrapV) << TEXTURE_WRAP_V_SHIFT;
    const shared::CutoutTexels t = shared::cutoutTexels(coordinates, {sheet.width, sheet.height}, flags);
    const auto at = [&](int x, int y) {
        EXPECT_TRUE(x >= 0 && x < sheet.width && y >= 0 && y < sheet.height) << x << ", " << y;
        return static_cast<float>(alphas[sheet.first + static_cast<std::size_t>(y * sheet.width + x)]);
    };
    return shared::alphaBetween(
        {at(t.low.x, t.low.y), at(t.high.x, t.low.y), at(t.low.x, t.high.y), at(t.high.x, t.high.y)}, t.share);
}

Image imageOf(int width, int height, const std::vector<int>& alphas) {
    Image image{"image", width, height, {}};
    for (const int alpha : alphas) image.rgba.insert(image.rgba.end(), {9, 9, 9, static_cast<std::uint8_t>(alpha)});
    return image;
}

/// One triangle whose texture coordinates are (0, 0), (1, 0) and (0, 1) times `scale`.
std::unique_ptr<Scene> triangleScene(const TextureUse& use, const Cutout& cutout, Image image, float scale) {
    Shape shape;
    shape.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    shape.normals.assign(3, glm::vec3(0, 1, 0));
    shape.triangles = {{0, 2, 1}};
    shape.textureCoordinates = {{0, 0}, {scale, 0}, {0, scale}};
    SceneParts parts;
    parts.name = "triangle";
    parts.materials = {matt("leaf", glm::vec3(1.0f))};
    parts.materials[0].baseColor = use;
    parts.materials[0].cutout = cutout;
    parts.images.push_back(std::move(image));
    parts.instances.emplace_back().shape = std::make_shared<const Shape>(shape);
    parts.cameras.emplace_back("only", staticCamera({0, 3, 1}, {0, 0, 0}, 0.8));
    parts.light = staticSpot({0, 5, 0.1}, {0, 0, 0}, 0.4, 0.5);
    parts.bounds.add({-1, 0, -1});
    parts.bounds.add({1, 1, 1});
    return std::make_unique<MeshScene>(std::move(parts));
}

TEST(CutoutAlpha, IsWhatIsKnownByHand) {
    const std::vector<Image> images{imageOf(2, 2, {0, 100, 200, 40})};
    Material material;
    material.baseColor.image = 0;
    material.cutout = Cutout{.threshold = 50.0f};
    const auto alpha = [&](Wrap wrap, bool nearest, float s, float t) {
        material.baseColor.wrapU = material.baseColor.wrapV = wrap;
        material.cutout->nearest = nearest;
        const auto cutouts = Cutouts::of({material}, images);
        return sharedAlpha(cutouts->sheet(0), cutouts->alphas(), {s, t});
    };
    // At texels' centres, between them, and beyond the border.
    EXPECT_EQ(alpha(Wrap::Repeat, false, 0.25f, 0.25f), 0.0f);
    EXPECT_EQ(alpha(Wrap::Repeat, false, 0.75f, 0.75f), 40.0f);
    EXPECT_EQ(alpha(Wrap::Repeat, false, 0.5f, 0.25f), 50.0f);
    EXPECT_EQ(alpha(Wrap::Repeat, false, 0.5f, 0.5f), 85.0f);
    EXPECT_EQ(alpha(Wrap::Repeat, false, 1.0f, 0.25f), 50.0f) << "halfway between the last and the first";
    EXPECT_EQ(alpha(Wrap::Clamp, false, 1.0f, 0.25f), 100.0f);
    EXPECT_EQ(alpha(Wrap::Clamp, false, 9.0f, 0.25f), 100.0f);
    EXPECT_EQ(alpha(Wrap::Clamp, false, -9.0f, 0.25f), 0.0f);
    EXPECT_EQ(alpha(Wrap::Mirror, false, 1.0f, 0.25f), 100.0f);
    EXPECT_EQ(alpha(Wrap::Mirror, false, 1.25f, 0.25f), 100.0f);
    EXPECT_EQ(alpha(Wrap::Mirror, false, 1.75f, 0.25f), 0.0f);
    EXPECT_EQ(alpha(Wrap::Mirror, false, -0.25f, 0.75f), 200.0f);
    EXPECT_EQ(alpha(Wrap::Repeat, false, -0.25f, 0.25f), 100.0f);
    EXPECT_EQ(alpha(Wrap::Repeat, true, 0.49f, 0.25f), 0.0f);
    EXPECT_EQ(alpha(Wrap::Repeat, true, 0.51f, 0.25f), 100.0f);
    EXPECT_EQ(alpha(Wrap::Repeat, true, 1.49f, 0.76f), 200.0f);
    for (const float wild : {std::nanf(""), HUGE_VALF, -HUGE_VALF, 1e30f})
        for (const Wrap wrap : {Wrap::Repeat, Wrap::Mirror, Wrap::Clamp})
            EXPECT_LE(alpha(wrap, false, wild, 0.25f), 200.0f) << "reads beside the image";
}

TEST(CutoutAlpha, OfTheShadersIsThatOfTheOracle) {
    std::mt19937 numbers(7);
    std::size_t covered = 0, all = 0, doubtful = 0;
    for (int round = 0; round < 60; ++round) {
        const auto number = [&](int below) { return static_cast<int>(numbers() % static_cast<unsigned>(below)); };
        const int width = 1 + number(17), height = 1 + number(9);
        std::vector<int> alphas;
        for (int i = 0; i < width * height; ++i) alphas.push_back(number(4) == 0 ? 255 * number(2) : number(256));
        Cutout cutout{.threshold = cutoutThreshold((1 + number(250)) / 255.0, 1.0)};
        const TextureUse use{.image = 0, .wrapU = static_cast<Wrap>(number(3)), .wrapV = static_cast<Wrap>(number(3))};
        cutout.nearest = number(3) == 0;
        const float scale = static_cast<float>(number(7) - 3) + 0.3f;
        const std::unique_ptr<Scene> scene = triangleScene(use, cutout, imageOf(width, height, alphas), scale);
        FrameRequest request;
        request.width = request.height = 8;
        const FramePlan plan = FramePlanner(*scene).plan(request);
        const oracle::CutoutCover cover(plan);
        ASSERT_TRUE(cover.isCutOut(0));
        const Cutouts::Sheet& sheet = plan.cutouts->sheet(0);
        std::uniform_real_distribution<float> share(0.0f, 1.0f);
        for (int i = 0; i < 4000; ++i) {
            const glm::vec3 weights(share(numbers), share(numbers), share(numbers));
            const double sum =
                static_cast<double>(weights.x) + static_cast<double>(weights.y) + static_cast<double>(weights.z);
            // The corners of the only triangle are in the order 0, 2, 1.
            const glm::vec2 coordinates = shared::weightedCoordinates({0, 0}, {0, scale}, {scale, 0}, weights);
            const bool shaders = sharedAlpha(sheet, plan.cutouts->alphas(), coordinates) >= sheet.threshold;
            const oracle::CutoutCover::Cover truth =
                cover.at(0, {static_cast<double>(weights.y) / sum, static_cast<double>(weights.z) / sum}, 1e-6);
            ++all;
            covered += truth.covers ? 1u : 0u;
            doubtful += truth.doubtful ? 1u : 0u;
            ASSERT_TRUE(truth.doubtful || shaders == truth.covers) << coordinates.x << ", " << coordinates.y;
        }
    }
    EXPECT_GT(covered, all / 4);
    EXPECT_LT(covered, 3 * all / 4);
    EXPECT_LT(doubtful, all / 2000) << "nothing would have been compared";
}

TEST(CutoutThreshold, IsInStepsOfTheImage) {
    EXPECT_EQ(cutoutThreshold(0.5, 1.0), 127.5f);
    EXPECT_EQ(cutoutThreshold(static_cast<double>(128.0f / 255.0f), 1.0), 128.0f) << "a float's rounding counts";
    EXPECT_EQ(cutoutThreshold(0.5, 0.5), 255.0f);
    EXPECT_GT(cutoutThreshold(0.6, 0.5), 255.0f);
    EXPECT_GT(cutoutThreshold(0.5, 0.0), 255.0f);
    EXPECT_EQ(cutoutThreshold(0.0, 0.0), 0.0f) << "everything covers";
}

test::ByteList pngOf(const Image& from) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(from.width);
    image.height = static_cast<png_uint_32>(from.height);
    image.format = PNG_FORMAT_RGBA;
    png_alloc_size_t size = 0;
    png_image_write_to_memory(&image, nullptr, &size, 0, from.rgba.data(), 0, nullptr);
    test::ByteList bytes(size);
    png_image_write_to_memory(&image, bytes.data(), &size, 0, from.rgba.data(), 0, nullptr);
    return bytes;
}

/// A quad with the given material, whose image is the one given.
std::unique_ptr<Scene> fileWith(Json material, const Image& image, Json sampler) {
    GltfFile file;
    const int positions = file.vec3s({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    const int coordinates = file.addAccessor<float>({0, 0, 1, 0, 1, 1, 0, 1}, "VEC2", 2);
    const int mesh = file.addMesh({{"POSITION", positions}, {"TEXCOORD_0", coordinates}},
                                  file.addAccessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 1));
    file.json["meshes"][0]["primitives"][0]["material"] = 0;
    const test::ByteList png = pngOf(image);
    file.add("images", {{"bufferView", file.addView(png.data(), png.size())}, {"mimeType", "image/png"}});
    file.add("samplers", std::move(sampler));
    file.add("textures", {{"source", 0}, {"sampler", 0}});
    file.add("materials", std::move(material));
    file.addRoot({{"mesh", mesh}});
    const TemporaryFolder folder;
    return loadGltf(folder.write("leaf.glb", file.glb()), {});
}

Json masked(Json more = Json::object()) {
    Json material = {
        {"name", "leaf"}, {"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}};
    material.update(more);
    return material;
}

TEST(CutoutsOfFiles, AreReadAsTheyAre) {
    const Image image = imageOf(2, 1, {0, 255});
    const auto material = [&](const Json& more, const Json& sampler) {
        return fileWith(masked(more), image, sampler)->materials().front();
    };
    const auto cutout = [&](const Json& more, const Json& sampler) { return material(more, sampler).cutout; };
    const Material plain = material(Json::object(), Json::object());
    ASSERT_TRUE(plain.cutout);
    EXPECT_EQ(plain.cutout->threshold, 127.5f) << "0.5 where the file says nothing";
    EXPECT_EQ(plain.baseColor.image, 0);
    EXPECT_EQ(plain.baseColor.wrapU, Wrap::Repeat);
    EXPECT_FALSE(plain.cutout->nearest);
    const Material other = material({{"alphaCutoff", 0.25}}, {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
    ASSERT_TRUE(other.cutout);
    EXPECT_EQ(other.cutout->threshold, 63.75f);
    EXPECT_EQ(other.baseColor.wrapU, Wrap::Clamp);
    EXPECT_EQ(other.baseColor.wrapV, Wrap::Mirror);
    EXPECT_TRUE(other.cutout->nearest);
    const std::optional<Cutout> faint =
        cutout({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"baseColorFactor", {1, 1, 1, 0.5}}}}},
               Json::object());
    ASSERT_TRUE(faint);
    EXPECT_EQ(faint->threshold, 255.0f);
    EXPECT_FALSE(cutout({{"alphaMode", "OPAQUE"}}, Json::object()));
    EXPECT_FALSE(cutout({{"alphaCutoff", 0.0}}, Json::object())) << "nothing is below";
    EXPECT_FALSE(fileWith(masked(), imageOf(2, 1, {130, 255}), Json::object())->materials().front().cutout)
        << "no texel is below";
}

bool hasNote(const Scene& scene, const std::string& part) {
    for (const std::string& note : scene.notes())
        if (note.find(part) != std::string::npos) return true;
    return false;
}

TEST(CutoutsOfFiles, WhatBlendsIsOpaqueAndSaysSo) {
    const Image image = imageOf(2, 1, {0, 255});
    const std::unique_ptr<Scene> blended = fileWith(masked({{"alphaMode", "BLEND"}}), image, Json::object());
    EXPECT_FALSE(blended->materials().front().cutout);
    EXPECT_TRUE(hasNote(*blended, "1 materials blend by their alpha (the first is \"leaf\")"));
    EXPECT_FALSE(hasNote(*fileWith(masked(), image, Json::object()), "blend"));
}

TEST(CutoutsOfFiles, WithoutAnImageAllOrNothing) {
    const Image image = imageOf(1, 1, {255});
    const auto material = [&](double alpha) {
        return fileWith({{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, alpha}}}}},
                        image, Json::object())
            ->materials()
            .front();
    };
    EXPECT_FALSE(material(0.6).cutout);
    ASSERT_TRUE(material(0.4).cutout);
    EXPECT_EQ(material(0.4).baseColor.image, -1);
}

/// A box is closed, one that is cut out is not.
TEST(CutoutCulling, WhatIsCutOutIsNotClosed) {
    const auto closedSurfaces = [](bool cut) {
        SceneParts parts;
        parts.name = "box";
        parts.materials = {matt("box", glm::vec3(1.0f))};
        if (cut) parts.materials[0].cutout = Cutout{.threshold = 300.0f};
        parts.instances.emplace_back().shape = std::make_shared<const Shape>(box(glm::dvec3(1.0), glm::ivec3(1)));
        parts.cameras.emplace_back("only", staticCamera({0, 3, 1}, {0, 0, 0}, 0.8));
        parts.light = staticSpot({0, 5, 0.1}, {0, 0, 0}, 0.4, 0.5);
        parts.bounds.add(glm::dvec3(-1.0));
        parts.bounds.add(glm::dvec3(1.0));
        const MeshScene scene(std::move(parts));
        return ClosedSurfaces(scene.motionMesh(0.0, 0.0), scene.materials()).count();
    };
    EXPECT_EQ(closedSurfaces(false), 1u);
    EXPECT_EQ(closedSurfaces(true), 0u);
}

}  // namespace
}  // namespace timeshade
