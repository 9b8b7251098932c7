// What a file says of materials: which image is read where, and how. Known results of small files.

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "../broken_gltf/loaded.h"

namespace timeshade {
namespace {

using namespace test;

/// A quad with the coordinates 0, 0 to 1, 1 in set 0, halves of them in set 1, and material 0 with one image in all
/// textures that are named.
GltfFile texturedQuad(const std::vector<std::string>& textures) {
    GltfFile file;
    addQuad(file);
    Json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] = file.addAccessor<float>({0, 0, 1, 0, 1, 1, 0, 1}, "VEC2", 2);
    primitive["attributes"]["TEXCOORD_1"] = file.addAccessor<float>({0, 0, 0.5f, 0, 0.5f, 0.5f, 0, 0.5f}, "VEC2", 2);
    primitive["material"] = 0;
    file.addRoot({{"mesh", 0}});
    file.add("images", {{"uri", std::string("data:image/png;base64,") + onePixelPng}});
    file.add("textures", {{"source", 0}});
    file.add("materials", {{"emissiveFactor", {1, 1, 1}}});
    for (const std::string& name : textures)
        (name == "emissiveTexture" ? file.json["materials"][0]
                                   : file.json["materials"][0]["pbrMetallicRoughness"])[name] = {{"index", 0}};
    return file;
}

Json& textureOf(GltfFile& file, const std::string& name) {
    Json& material = file.json["materials"][0];
    return name == "emissiveTexture" ? material[name] : material["pbrMetallicRoughness"][name];
}

std::shared_ptr<const MeshTopology> topologyOf(const GltfFile& file) { return loaded(file)->motionMesh(0, 0).topology; }

void expectPlace(const glm::vec2& found, double x, double y) {
    EXPECT_NEAR(static_cast<double>(found.x), x, 1e-6);
    EXPECT_NEAR(static_cast<double>(found.y), y, 1e-6);
}

TEST(TextureCoordinates, AreThoseOfTheBaseColourTransformed) {
    GltfFile file = texturedQuad({"baseColorTexture"});
    textureOf(file, "baseColorTexture")["extensions"]["KHR_texture_transform"] = {
        {"offset", {0.25, -3.0}}, {"rotation", 0.5}, {"scale", {2.0, 4.0}}};
    const auto topology = topologyOf(file);
    const double c = std::cos(0.5), s = std::sin(0.5);
    expectPlace(topology->textureCoordinates[0], 0.25, -3.0);
    expectPlace(topology->textureCoordinates[1], 0.25 + 2 * c, -3.0 - 2 * s);
    expectPlace(topology->textureCoordinates[3], 0.25 + 4 * s, -3.0 + 4 * c);
    EXPECT_TRUE(topology->moreCoordinates.empty());
    EXPECT_EQ(notesWith(*loaded(file), "KHR_texture_transform"), 0u);
}

TEST(TextureCoordinates, OfAnotherSetByTextureOrByTransform) {
    for (const bool byTransform : {false, true}) {
        GltfFile file = texturedQuad({"baseColorTexture"});
        Json& texture = textureOf(file, "baseColorTexture");
        if (byTransform)
            texture["extensions"]["KHR_texture_transform"] = {{"texCoord", 1}, {"offset", {1.0, 0.0}}};
        else
            texture["texCoord"] = 1;
        const auto topology = topologyOf(file);
        expectPlace(topology->textureCoordinates[2], byTransform ? 1.5 : 0.5, 0.5);
        EXPECT_TRUE(topology->moreCoordinates.empty());
    }
    GltfFile lacks = texturedQuad({"baseColorTexture"});
    textureOf(lacks, "baseColorTexture")["texCoord"] = 4;
    expectPlace(topologyOf(lacks)->textureCoordinates[2], 0.0, 0.0);
    EXPECT_EQ(notesWith(*loaded(lacks), "1 primitives lack texture coordinates"), 1u);
}

TEST(TextureCoordinates, OfEachTextureWhereTheyDiffer) {
    const std::vector<std::string> all{"baseColorTexture", "metallicRoughnessTexture", "emissiveTexture"};
    const auto alike = loaded(texturedQuad(all));
    EXPECT_TRUE(alike->motionMesh(0, 0).topology->moreCoordinates.empty());
    for (const TextureUse& use :
         {alike->materials()[0].baseColor, alike->materials()[0].metallicRoughness, alike->materials()[0].emissive})
        EXPECT_EQ(use.coordinates, 0);

    GltfFile file = texturedQuad(all);
    textureOf(file, "metallicRoughnessTexture")["texCoord"] = 1;
    textureOf(file, "emissiveTexture")["extensions"]["KHR_texture_transform"] = {{"scale", {-1.0, 3.0}}};
    const auto scene = loaded(file);
    EXPECT_EQ(scene->materials()[0].baseColor.coordinates, 0);
    EXPECT_EQ(scene->materials()[0].metallicRoughness.coordinates, 1);
    EXPECT_EQ(scene->materials()[0].emissive.coordinates, 2);
    const auto topology = scene->motionMesh(0, 0).topology;
    ASSERT_EQ(topology->moreCoordinates.size(), 4u);
    EXPECT_EQ(topology->textureCoordinates[2], glm::vec2(1, 1));
    EXPECT_EQ(topology->moreCoordinates[2], glm::vec4(0.5, 0.5, -1, 3));
    EXPECT_EQ(topology->moreCoordinates[1], glm::vec4(0.5, 0, -1, 0));

    // Without a base colour's image the first that there is takes its place.
    GltfFile shining = texturedQuad({"emissiveTexture"});
    textureOf(shining, "emissiveTexture")["texCoord"] = 1;
    EXPECT_EQ(loaded(shining)->materials()[0].emissive.coordinates, 0);
    expectPlace(topologyOf(shining)->textureCoordinates[2], 0.5, 0.5);
}

TEST(TextureCoordinates, BrokenTransformsAreNamed) {
    for (const auto& [key, value] : std::vector<std::pair<const char*, Json>>{{"offset", {1}},
                                                                              {"offset", "0 0"},
                                                                              {"scale", {1, 2, 3}},
                                                                              {"scale", {1, "2"}},
                                                                              {"rotation", {0}},
                                                                              {"rotation", 1e30},
                                                                              {"texCoord", -1},
                                                                              {"texCoord", 0.5}}) {
        GltfFile file = texturedQuad({"baseColorTexture"});
        textureOf(file, "baseColorTexture")["extensions"]["KHR_texture_transform"] = {{key, value}};
        const std::string message = refusal(file);
        EXPECT_NE(message.find("baseColorTexture"), std::string::npos) << key << " " << message;
        EXPECT_NE(message.find(key), std::string::npos) << key << " " << message;
    }
}

TEST(Samplers, WrapAsTheySay) {
    for (const auto& [mode, wrap, known] : {std::tuple{10497, Wrap::Repeat, true},
                                            {33648, Wrap::Mirror, true},
                                            {33071, Wrap::Clamp, true},
                                            {10496, Wrap::Repeat, false}}) {
        GltfFile file = texturedQuad({"baseColorTexture"});
        file.add("samplers", {{"wrapT", mode}});
        file.json["textures"][0]["sampler"] = 0;
        const auto scene = loaded(file);
        EXPECT_EQ(scene->materials()[0].baseColor.wrapU, Wrap::Repeat);
        EXPECT_EQ(scene->materials()[0].baseColor.wrapV, wrap) << mode;
        EXPECT_EQ(notesWith(*scene, "wrap in a way that glTF does not know"), known ? 0u : 1u);
    }
    GltfFile nearest = texturedQuad({"baseColorTexture"});
    nearest.add("samplers", {{"magFilter", 9728}});
    nearest.json["textures"][0]["sampler"] = 0;
    EXPECT_EQ(notesWith(*loaded(nearest), "1 textures ask for the nearest texel"), 1u);
    nearest.json["textures"][0]["sampler"] = 3;
    EXPECT_NE(refusal(nearest).find("sampler 3"), std::string::npos) << refusal(nearest);
}

TEST(Emission, HasItsTextureAndStrength) {
    GltfFile file = texturedQuad({"emissiveTexture"});
    file.json["materials"][0]["emissiveFactor"] = {0.5, 0.25, 1};
    file.json["materials"][0]["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 8}};
    file.json["extensionsUsed"] = {"KHR_materials_emissive_strength"};
    const auto scene = loaded(file);
    EXPECT_EQ(scene->materials()[0].emissiveFactor, glm::vec3(4, 2, 8));
    EXPECT_EQ(scene->materials()[0].emissive.image, 0);
    EXPECT_TRUE(scene->notes().empty()) << scene->notes()[0];

    // A factor without its texture would shine where the texture is dark; an image of what does not shine is not read.
    file.json["images"][0]["uri"] = "missing.png";
    EXPECT_EQ(loaded(file)->materials()[0].emissiveFactor, glm::vec3(0.0f));
    GltfFile dark = texturedQuad({"emissiveTexture"});
    dark.json["materials"][0].erase("emissiveFactor");
    EXPECT_TRUE(loaded(dark)->images().empty());
}

TEST(LeftOut, NormalAndOcclusionTexturesAreNamed) {
    GltfFile file = texturedQuad({});
    file.json["materials"][0]["normalTexture"] = {{"index", 0}};
    EXPECT_EQ(notesWith(*loaded(file), "1 materials have normal or occlusion textures"), 1u);
}

/// A quad with colours of the given numbers.
template <typename Number>
GltfFile colouredQuad(const std::vector<Number>& numbers, bool normalized, int components) {
    GltfFile file;
    addQuad(file);
    file.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] =
        file.addAccessor<Number>(numbers, components == 3 ? "VEC3" : "VEC4", components, normalized);
    file.addRoot({{"mesh", 0}});
    return file;
}

TEST(VertexColours, OfAllTypesAndBothWidths) {
    const std::vector<double> shares{0, 0.2, 0.4, 0.6, 0.8, 1, 0, 1, 0.4, 0.2, 0.2, 0.2, 1, 1, 0, 0};
    const auto check = [&](const GltfFile& file, int components, double scale) {
        const auto scene = loaded(file);
        EXPECT_TRUE(scene->notes().empty()) << scene->notes()[0];
        const std::vector<glm::vec4>& colours = scene->motionMesh(0, 0).topology->colours;
        ASSERT_EQ(colours.size(), 4u);
        for (int v = 0; v < 4; ++v)
            for (int c = 0; c < 4; ++c) {
                const double share = shares[static_cast<std::size_t>(v * components + c)];
                EXPECT_NEAR(static_cast<double>(colours[static_cast<std::size_t>(v)][c]),
                            c < components ? std::round(share * scale) / scale : 1.0, 1e-6)
                    << v << " " << c;
            }
    };
    for (const int components : {3, 4}) {
        const auto first = [&](double scale) {
            std::vector<double> numbers(shares.begin(), shares.begin() + 4 * components);
            for (double& number : numbers) number = std::round(number * scale);
            return numbers;
        };
        std::vector<float> floats;
        for (int i = 0; i < 4 * components; ++i) floats.push_back(static_cast<float>(shares[std::size_t(i)]));
        check(colouredQuad(floats, false, components), components, 1e12);
        const std::vector<double> bytes = first(255), shorts = first(65535);
        check(colouredQuad(std::vector<std::uint8_t>(bytes.begin(), bytes.end()), true, components), components, 255);
        check(colouredQuad(std::vector<std::uint16_t>(shorts.begin(), shorts.end()), true, components), components,
              65535);
    }
}

TEST(VertexColours, OthersOfTheSceneAreWhite) {
    GltfFile file;
    addQuad(file);
    file.addRoot({{"mesh", 0}});
    addQuad(file);
    file.json["meshes"][1]["primitives"][0]["attributes"]["COLOR_0"] = file.vec3s(std::vector<float>(12, 0.5f));
    file.addRoot({{"mesh", 1}});
    addQuad(file);
    file.addRoot({{"mesh", 2}});
    const auto topology = topologyOf(file);
    ASSERT_EQ(topology->colours.size(), 12u);
    for (std::size_t v = 0; v < 12; ++v)
        EXPECT_EQ(topology->colours[v], v / 4 == 1 ? glm::vec4(0.5, 0.5, 0.5, 1) : glm::vec4(1.0f));
    // Where all are white, there are none.
    EXPECT_TRUE(topologyOf(colouredQuad(std::vector<float>(12, 1.0f), false, 3))->colours.empty());
}

TEST(VertexColours, ThatCannotBeReadAreLeftOutWithANote) {
    EXPECT_EQ(notesWith(*loaded(colouredQuad(std::vector<std::uint8_t>(12, 9), false, 3)), "vertex colours are left"),
              1u);
    EXPECT_EQ(notesWith(*loaded(colouredQuad(std::vector<float>(9, 0.5f), false, 3)), "vertex colours are left"), 1u);
    const GltfFile bright = colouredQuad(std::vector<float>(12, 1.5f), false, 3);
    EXPECT_EQ(notesWith(*loaded(bright), "colours beyond 0 to 1"), 1u);
    EXPECT_TRUE(topologyOf(bright)->colours.empty());
}

TEST(VertexColours, AreCountedOverAllInstances) {
    GltfFile file = colouredQuad(std::vector<float>(12, 0.5f), false, 3);
    GltfOptions options;
    const auto least = [&](const GltfFile& of) {
        std::uint64_t low = 0, high = std::uint64_t{1} << 30;
        while (high - low > 16) {
            options.memoryLimit = (low + high) / 2;
            (refusal(of, options).empty() ? high : low) = options.memoryLimit;
        }
        return high;
    };
    const std::uint64_t one = least(file);
    for (int i = 0; i < 999; ++i) file.addRoot({{"mesh", 0}});
    GltfFile plain = file;
    plain.json["meshes"][0]["primitives"][0]["attributes"].erase("COLOR_0");
    EXPECT_GE(least(file), least(plain) + 4000 * sizeof(glm::vec4));
    EXPECT_LT(one, least(file));
}

}  // namespace
}  // namespace timeshade
