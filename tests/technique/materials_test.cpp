// How shading reads materials: against images filtered, wrapped and averaged in double precision.

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "../broken_gltf/loaded.h"
#include "image/image_file.h"
#include "support/gl_environment.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

using namespace test;

constexpr int side = 32;  // pixels of a picture

/// A picture of grey levels, row by row from the top.
struct Grey {
    int width, height;
    std::vector<std::uint8_t> levels;
};

double linear(std::uint8_t level) {
    const double c = level / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// The unit quad, which fills the picture, with coordinates 0 to `last` from the upper left corner. A lamp is behind
/// it, or before.
GltfFile quadBeforeCamera(float last, bool lit) {
    GltfFile file;
    addQuad(file);
    Json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] = file.addAccessor<float>({0, last, last, last, last, 0, 0, 0}, "VEC2", 2);
    primitive["material"] = 0;
    file.add("materials", {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}});
    file.addRoot({{"mesh", 0}});
    file.add("cameras",
             {{"type", "perspective"}, {"perspective", {{"yfov", 2.0 * std::atan(0.5 / 4.0)}, {"znear", 0.1}}}});
    file.addRoot({{"camera", 0}, {"translation", {0.5, 0.5, 4}}});
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array(
        {{{"type", "spot"}, {"intensity", 10}, {"spot", {{"innerConeAngle", 0.9}, {"outerConeAngle", 1.0}}}}});
    const Json back = lit ? Json({0, 0, 0, 1}) : Json({0, 1, 0, 0});
    file.addRoot({{"translation", {0.5, 0.5, lit ? 2 : -2}},
                  {"rotation", back},
                  {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return file;
}

/// The quad shines as the image says, and reflects as little as it can.
GltfFile shining(float last, const Json& sampler = Json::object()) {
    GltfFile file = quadBeforeCamera(last, false);
    file.add("images", {{"uri", "image.png"}});
    file.add("samplers", sampler);
    file.add("textures", {{"source", 0}, {"sampler", 0}});
    file.json["materials"][0] = {{"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}}},
                                 {"emissiveFactor", {1, 1, 1}},
                                 {"emissiveTexture", {{"index", 0}}}};
    return file;
}

/// Red of the drawn picture, rows from the top.
std::vector<double> drawn(const GltfFile& file, const Grey& image = {1, 1, {255}},
                          CameraSamples samples = CameraSamples::Strata) {
    const TemporaryFolder folder;
    DisplayImage png{image.width, image.height, {}};
    for (const std::uint8_t level : image.levels) png.rgb.insert(png.rgb.end(), 3, level);
    writePng(folder.path() / "image.png", png);
    folder.write("model.bin", file.data);
    const auto scene = loadGltf(file.saveSplit(folder, "model.gltf", "model.bin"));
    FrameRequest request;
    request.width = request.height = side;
    request.samplesPerPixel = 1;
    request.samples = samples;
    request.timeStrata = 1;
    request.pixelCentres = true;
    request.shutter.length = 0.0;
    request.mapSize = 64;
    FramePlanner planner(*scene);
    const auto technique = makeTechnique(techniqueDescriptions().front().name, sharedRenderer().programs());
    sharedRenderer().draw(planner.plan(request), *technique, View::Final);
    const LinearImage picture = sharedRenderer().readRadiance();
    std::vector<double> red;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) red.push_back(static_cast<double>(picture.rgb[i]));
    return red;
}

/// What the image adds to a picture: light that it emits.
std::vector<double> emitted(GltfFile file, const Grey& image, CameraSamples samples = CameraSamples::Strata) {
    std::vector<double> with = drawn(file, image, samples);
    file.json["materials"][0].erase("emissiveFactor");
    const std::vector<double> without = drawn(file, image, samples);
    for (std::size_t i = 0; i < with.size(); ++i) with[i] -= without[i];
    return with;
}

int wrapped(int texel, int count, int mode) {
    const auto within = [](int x, int period) { return ((x % period) + period) % period; };
    if (mode == 33071) return std::clamp(texel, 0, count - 1);
    if (mode == 10497) return within(texel, count);
    const int folded = within(texel, 2 * count);
    return folded < count ? folded : 2 * count - 1 - folded;
}

double filtered(const Grey& image, double u, double v, int modeU, int modeV) {
    const double x = u * image.width - 0.5, y = v * image.height - 0.5;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    double sum = 0.0;
    for (const int dx : {0, 1})
        for (const int dy : {0, 1}) {
            const int column = wrapped(x0 + dx, image.width, modeU), row = wrapped(y0 + dy, image.height, modeV);
            const double weight = (dx == 1 ? x - x0 : 1.0 - (x - x0)) * (dy == 1 ? y - y0 : 1.0 - (y - y0));
            sum += weight * linear(image.levels[static_cast<std::size_t>(row * image.width + column)]);
        }
    return sum;
}

// Weights of a texture unit have 8 bits, two of them in a product.
constexpr double filterError = 2.5 / 256.0;

const Grey chart{4, 4, {255, 30, 90, 0, 180, 60, 220, 10, 0, 140, 200, 250, 20, 240, 100, 70}};

double worst(const std::vector<double>& found, const std::function<double(double, double)>& expected) {
    double most = 0.0;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            most = std::max(most, std::abs(found[static_cast<std::size_t>(j * side + i)] -
                                           expected((i + 0.5) / side, (j + 0.5) / side)));
    return most;
}

TEST(Materials, EmissiveTexturesShineWhereTheyAreBright) {
    for (const CameraSamples samples : {CameraSamples::Strata, CameraSamples::Intervals})
        EXPECT_LE(worst(emitted(shining(1), chart, samples),
                        [](double u, double v) { return filtered(chart, u, v, 10497, 10497); }),
                  filterError);
    GltfFile strong = shining(1);
    strong.json["materials"][0]["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 50}};
    EXPECT_LE(
        worst(emitted(strong, chart), [](double u, double v) { return 50.0 * filtered(chart, u, v, 10497, 10497); }),
        50.0 * filterError);
}

/// A factor whose map is black shines no more than one that is absent, wherever the map is black.
TEST(Materials, WhereTheEmissiveMapIsBlackNothingShines) {
    Grey half = chart;
    for (std::size_t i = 0; i < half.levels.size() / 2; ++i) half.levels[i] = 0;
    for (const Grey& map : {Grey{1, 1, {0}}, Grey{2, 3, {0, 0, 0, 0, 0, 0}}, half}) {
        const std::vector<double> found = emitted(shining(1), map);
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                if (filtered(map, (i + 0.5) / side, (j + 0.5) / side, 10497, 10497) > 0.0) continue;
                EXPECT_EQ(found[static_cast<std::size_t>(j * side + i)], 0.0) << i << " " << j;
            }
    }
}

TEST(Materials, ImagesWrapAsTheirSamplerSays) {
    for (const int modeU : {10497, 33648, 33071})
        for (const int modeV : {10497, 33648, 33071}) {
            GltfFile file = shining(3, {{"wrapS", modeU}, {"wrapT", modeV}});
            file.json["materials"][0]["emissiveTexture"]["extensions"]["KHR_texture_transform"] = {
                {"offset", {-1.3, -0.9}}};
            EXPECT_LE(
                worst(emitted(file, chart),
                      [&](double u, double v) { return filtered(chart, 3 * u - 1.3, 3 * v - 0.9, modeU, modeV); }),
                filterError)
                << modeU << " " << modeV;
        }
}

/// Each texture has coordinates of its own; read in another list, they are the same.
TEST(Materials, TexturesReadTheirOwnCoordinates) {
    GltfFile one = shining(1);
    one.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] =
        one.addAccessor<float>({0.5f, 0, 0, 0, 0, 1, 0.5f, 1}, "VEC2", 2);
    one.json["materials"][0]["emissiveTexture"] = {{"index", 0}, {"texCoord", 1}};
    const std::vector<double> expected = emitted(one, chart);
    EXPECT_LE(worst(expected, [](double u, double v) { return filtered(chart, 0.5 - 0.5 * u, 1 - v, 10497, 10497); }),
              filterError);
    GltfFile second = one, third = one;
    second.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    third.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    third.json["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {
        {"index", 0}, {"extensions", {{"KHR_texture_transform", {{"rotation", 1}}}}}};
    for (const GltfFile* file : {&second, &third}) {
        const std::vector<double> found = emitted(*file, chart);
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-6) << i;
    }
}

/// Texels much smaller than pixels: their mean, not one of them.
TEST(Materials, SmallTexelsAreAveraged) {
    for (const int texels : {250, 500}) {
        Grey checkered{texels, texels, {}};
        for (int y = 0; y < texels; ++y)
            for (int x = 0; x < texels; ++x) checkered.levels.push_back((x + y) % 2 == 0 ? 255 : 0);
        // A mean of .5 is stored as an sRGB level of 187 or 188.
        EXPECT_LE(worst(emitted(shining(1), checkered), [](double, double) { return 0.5; }), 0.004) << texels;
    }
}

TEST(Materials, ColoursOfVerticesMultiplyTheBaseColour) {
    // At the corners, from the lower left one counter-clockwise.
    const auto u = [](double x, double) { return x; };
    const auto left = [](double x, double) { return 1.0 - x; };
    const auto v = [](double, double y) { return y; };
    GltfFile white = quadBeforeCamera(1, false), black = white;
    black.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0, 0, 0, 1};
    for (const CameraSamples samples : {CameraSamples::Strata, CameraSamples::Intervals}) {
        const std::vector<double> high = drawn(white, chart, samples), low = drawn(black, chart, samples);
        const auto check = [&](const std::vector<std::uint8_t>& corners, const auto& expected) {
            GltfFile coloured = white;
            std::vector<std::uint8_t> colours;
            for (const std::uint8_t red : corners) colours.insert(colours.end(), {red, 9, 9, 0});
            coloured.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] =
                coloured.addAccessor<std::uint8_t>(colours, "VEC4", 4, true);
            std::vector<double> share = drawn(coloured, chart, samples);
            for (std::size_t i = 0; i < share.size(); ++i) share[i] = (share[i] - low[i]) / (high[i] - low[i]);
            EXPECT_LE(worst(share, expected), 1e-4);
        };
        check({0, 255, 255, 0}, u);
        check({255, 0, 0, 255}, left);
        check({255, 255, 0, 0}, v);
    }
}

/// KHR_lights_punctual: times 1 - (distance / range)^4, down to 0.
TEST(Materials, LightFadesToNothingAtItsRange) {
    const auto withRange = [](double range) {
        GltfFile file = quadBeforeCamera(1, true);
        if (range > 0.0) file.json["extensions"]["KHR_lights_punctual"]["lights"][0]["range"] = range;
        return drawn(file);
    };
    const std::vector<double> endless = withRange(0.0), none = withRange(1e-3);
    for (const double range : {2.05, 3.0, 8.0}) {
        std::vector<double> share = withRange(range);
        for (std::size_t i = 0; i < share.size(); ++i) share[i] = (share[i] - none[i]) / (endless[i] - none[i]);
        EXPECT_LE(worst(share,
                        [&](double u, double v) {
                            const double squared = 4 + (u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5);
                            const double reach = squared / (range * range);
                            return std::max(1.0 - reach * reach, 0.0);
                        }),
                  1e-4)
            << range;
    }
}

}  // namespace
}  // namespace timeshade
