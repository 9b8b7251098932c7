#include "scene/gltf_images.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "core/one_line.h"
#include "image/foreign_image.h"
#include "scene/gltf_accessors.h"

namespace timeshade::gltf {

namespace {

constexpr std::size_t largestTotal = std::size_t{1} << 30;  // bytes of decoded images
constexpr std::size_t copiesOfAnImage = 3;                  // here, and as a texture with smaller levels

/// Whatever is tried counts, so that many images that fail at their end cannot cost more than those that are good.
Image decode(std::span<const std::uint8_t> bytes, std::size_t& budget, MemoryBudget& memory) {
    ImageLimits limits;
    std::size_t spent = 0;
    limits.bytes = std::min<std::size_t>(budget, memory.left() / copiesOfAnImage);
    limits.spent = &spent;
    ForeignImage decoded;
    try {
        decoded = decodeImage(bytes, limits);
    } catch (const Error&) {
        budget -= std::min(budget, bytes.size() + spent);
        throw;
    }
    budget -= std::min(budget, bytes.size() + spent);
    memory.take(copiesOfAnImage, decoded.rgba.size(), "its images");
    Image image;
    image.width = decoded.width;
    image.height = decoded.height;
    image.rgba = std::move(decoded.rgba);
    return image;
}

/// Decodes each image on first use.
class ImageShelf {
  public:
    ImageShelf(const Model& model, FilesBeside& files, std::vector<std::string>& notes)
        : model_(model), files_(files), notes_(notes) {}

    /// The image index of a texture, or -1.
    int indexOf(int texture) {
        if (texture < 0) return -1;
        const int source = model_.textureImages[static_cast<std::size_t>(texture)];
        if (source < 0) {
            if (noSource_++ == 0) notes_.push_back(fmt::format("texture {} has no image that can be read", texture));
            return -1;
        }
        if (const auto known = known_.find(source); known != known_.end()) return known->second;
        return known_[source] = load(model_.images[static_cast<std::size_t>(source)]);
    }

    std::vector<Image> images;

  private:
    int load(const ImageSource& source) {
        try {
            std::shared_ptr<const Bytes> file;
            if (source.view < 0) file = files_.read(source.uri);
            Image image = decode(source.view < 0 ? std::span<const std::uint8_t>(*file) : bytesOf(model_, source.view),
                                 budget_, *model_.memory);
            image.name = source.name;
            images.push_back(std::move(image));
            return static_cast<int>(images.size()) - 1;
        } catch (const Error& error) {
            notes_.push_back(fmt::format("image \"{}\" is left out: {}", source.name, oneLine(error.what(), 120)));
            return -1;
        }
    }

    const Model& model_;
    FilesBeside& files_;
    std::vector<std::string>& notes_;
    std::map<int, int> known_;
    std::size_t budget_ = largestTotal;
    int noSource_ = 0;
};

/// The mean of an sRGB image's colour, linear.
glm::vec3 meanColour(const Image& image) {
    const auto linear = [](std::uint8_t byte) {
        const double c = byte / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4)
        sum += glm::dvec3(linear(image.rgba[i]), linear(image.rgba[i + 1]), linear(image.rgba[i + 2]));
    return glm::vec3(sum / std::max(1.0, static_cast<double>(image.rgba.size() / 4)));
}

/// What alpha cuts out of a material; none where no texel is cut out.
std::optional<Cutout> cutoutOf(const Model& model, const MaterialSource& source, const Material& material,
                               const std::vector<Image>& images) {
    Cutout cutout;
    cutout.threshold = cutoutThreshold(source.alphaCutoff, static_cast<double>(material.baseColorFactor.w));
    cutout.image = material.baseColorImage;
    int least = 255;
    if (cutout.image >= 0) {
        const TextureSampler& sampler = model.textureSamplers[static_cast<std::size_t>(source.baseColorTexture)];
        cutout.wrapS = sampler.wrapS;
        cutout.wrapT = sampler.wrapT;
        cutout.nearest = sampler.nearest;
        const std::vector<std::uint8_t>& rgba = images[static_cast<std::size_t>(cutout.image)].rgba;
        for (std::size_t i = 3; i < rgba.size(); i += 4) least = std::min<int>(least, rgba[i]);
    }
    if (static_cast<float>(least) >= cutout.threshold) return std::nullopt;
    if (cutout.image >= 0) {
        constexpr std::size_t copies = 2;  // here and on the device
        model.memory->take(copies, images[static_cast<std::size_t>(cutout.image)].rgba.size() / 4, "its cut-outs");
    }
    return cutout;
}

}  // namespace

Looks readLooks(const Model& model, FilesBeside& files, std::vector<std::string>& notes, const LoadingWatch& watch) {
    ImageShelf shelf(model, files, notes);
    Looks looks;
    std::size_t otherCoordinates = 0;
    std::vector<std::string> blended;
    std::size_t shining = 0;
    for (const MaterialSource& source : model.materials) {
        watch({"materials", looks.materials.size(), model.materials.size()});
        looks.materials.push_back(source.material);
        looks.materials.back().baseColorImage = shelf.indexOf(source.baseColorTexture);
        looks.materials.back().metallicRoughnessImage = shelf.indexOf(source.metallicRoughnessTexture);
        // A factor without its texture would shine where the texture is dark.
        glm::vec3& emissive = looks.materials.back().emissiveFactor;
        if (source.emissiveTexture >= 0 && emissive != glm::vec3(0.0f)) {
            const int image = shelf.indexOf(source.emissiveTexture);
            emissive *= image < 0 ? glm::vec3(0.0f) : meanColour(shelf.images[static_cast<std::size_t>(image)]);
            ++shining;
        }
        if (source.otherCoordinates) ++otherCoordinates;
        if (source.cutOut)
            looks.materials.back().cutout = cutoutOf(model, source, looks.materials.back(), shelf.images);
        if (source.transparent) blended.push_back(looks.materials.back().name);
    }
    looks.materials.emplace_back().name = "default";
    looks.images = std::move(shelf.images);
    if (otherCoordinates > 0)
        notes.push_back(fmt::format(
            "{} materials use other texture coordinates than TEXCOORD_0 as it is; they get those", otherCoordinates));
    if (shining > 0)
        notes.push_back(fmt::format("{} materials shine evenly, with the mean of their emissive texture", shining));
    if (!blended.empty())
        notes.push_back(
            fmt::format("{} materials blend by their alpha (the first is \"{}\"): they are drawn, and cast "
                        "shadows, as if they were opaque",
                        blended.size(), oneLine(blended.front(), 60)));
    return looks;
}

}  // namespace timeshade::gltf
