#include "scene/gltf_images.h"

#include <algorithm>
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

    /// Puts the image's index in place of the texture's, or -1, and says how the texture wraps.
    void resolve(TextureUse& use) {
        if (use.image < 0) return;
        const Texture& texture = model_.textures[static_cast<std::size_t>(use.image)];
        use.wrapU = texture.wrapU;
        use.wrapV = texture.wrapV;
        use.image = indexOf(use.image, texture.image);
    }

    std::vector<Image> images;

  private:
    int indexOf(int texture, int source) {
        if (source < 0) {
            if (noSource_++ == 0) notes_.push_back(fmt::format("texture {} has no image that can be read", texture));
            return -1;
        }
        if (const auto known = known_.find(source); known != known_.end()) return known->second;
        return known_[source] = load(model_.images[static_cast<std::size_t>(source)]);
    }

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

/// What alpha cuts out of a material; none where no texel is cut out.
std::optional<Cutout> cutoutOf(const Model& model, const MaterialSource& source, const Material& material,
                               const std::vector<Image>& images) {
    Cutout cutout;
    cutout.threshold = cutoutThreshold(source.alphaCutoff, static_cast<double>(material.baseColorFactor.w));
    const int image = material.baseColor.image;
    int least = 255;
    if (image >= 0) {
        cutout.nearest = model.textures[static_cast<std::size_t>(source.material.baseColor.image)].nearest;
        const std::vector<std::uint8_t>& rgba = images[static_cast<std::size_t>(image)].rgba;
        for (std::size_t i = 3; i < rgba.size(); i += 4) least = std::min<int>(least, rgba[i]);
    }
    if (static_cast<float>(least) >= cutout.threshold) return std::nullopt;
    if (image >= 0) {
        constexpr std::size_t copies = 2;  // here and on the device
        model.memory->take(copies, images[static_cast<std::size_t>(image)].rgba.size() / 4, "its cut-outs");
    }
    return cutout;
}

}  // namespace

Looks readLooks(const Model& model, FilesBeside& files, std::vector<std::string>& notes, const LoadingWatch& watch) {
    ImageShelf shelf(model, files, notes);
    Looks looks;
    std::vector<std::string> blended;
    for (const MaterialSource& source : model.materials) {
        watch({"materials", looks.materials.size(), model.materials.size()});
        Material& material = looks.materials.emplace_back(source.material);
        if (material.emissiveFactor == glm::vec3(0.0f)) material.emissive = {};
        const bool shines = material.emissive.image >= 0;
        for (TextureUse* use : {&material.baseColor, &material.metallicRoughness, &material.emissive})
            shelf.resolve(*use);
        // A factor without its texture would shine where the texture is dark.
        if (shines && material.emissive.image < 0) material.emissiveFactor = glm::vec3(0.0f);
        if (source.cutOut) material.cutout = cutoutOf(model, source, material, shelf.images);
        if (source.transparent) blended.push_back(material.name);
    }
    looks.materials.emplace_back().name = "default";
    looks.images = std::move(shelf.images);
    if (!blended.empty())
        notes.push_back(
            fmt::format("{} materials blend by their alpha (the first is \"{}\"): they are drawn, and cast "
                        "shadows, as if they were opaque",
                        blended.size(), oneLine(blended.front(), 60)));
    return looks;
}

}  // namespace timeshade::gltf
