#include "scene/gltf_images.h"

#include <map>
#include <memory>
#include <span>

#include <fmt/format.h>
#include <stb_image.h>

#include "core/error.h"
#include "core/one_line.h"
#include "scene/gltf_accessors.h"

namespace timeshade::gltf {

namespace {

constexpr int largestSide = 8192;
constexpr std::size_t largestTotal = std::size_t{1} << 30;  // bytes of decoded images

bool startsWith(std::span<const std::uint8_t> bytes, std::initializer_list<int> magic) {
    if (bytes.size() < magic.size()) return false;
    std::size_t i = 0;
    for (const int value : magic)
        if (bytes[i++] != value) return false;
    return true;
}

/// Only PNG and JPEG, as glTF specifies; the decoder's other formats are not exposed to untrusted files.
Image decode(std::span<const std::uint8_t> bytes, std::size_t& budget) {
    if (!startsWith(bytes, {0x89, 'P', 'N', 'G'}) && !startsWith(bytes, {0xff, 0xd8, 0xff}))
        throw Error("neither PNG nor JPEG");
    if (bytes.size() > (std::size_t{1} << 30)) throw Error("too large");
    const auto length = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(bytes.data(), length, &width, &height, &channels) == 0)
        throw Error("its header is damaged");
    if (width < 1 || height < 1 || width > largestSide || height > largestSide)
        throw Error(fmt::format("{}x{} pixels, the limit is {} a side", width, height, largestSide));
    const std::size_t size = std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    // Neither format compresses better than about 1000 : 1, so a larger size cannot be true.
    if (size / 2048 > bytes.size())
        throw Error(fmt::format("{} bytes cannot hold {}x{} pixels", bytes.size(), width, height));
    if (size > budget) throw Error("the limit on bytes of images is used up");

    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), length, &width, &height, &channels, 4), &stbi_image_free);
    if (!pixels) throw Error("damaged");
    budget -= size;
    Image image;
    image.width = width;
    image.height = height;
    image.rgba.assign(pixels.get(), pixels.get() + size);
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
            Image image =
                decode(source.view < 0 ? std::span<const std::uint8_t>(*file) : bytesOf(model_, source.view), budget_);
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

}  // namespace

Looks readLooks(const Model& model, FilesBeside& files, std::vector<std::string>& notes) {
    ImageShelf shelf(model, files, notes);
    Looks looks;
    std::size_t otherCoordinates = 0;
    std::size_t transparent = 0;
    for (const MaterialSource& source : model.materials) {
        looks.materials.push_back(source.material);
        looks.materials.back().baseColorImage = shelf.indexOf(source.baseColorTexture);
        looks.materials.back().metallicRoughnessImage = shelf.indexOf(source.metallicRoughnessTexture);
        if (source.otherCoordinates) ++otherCoordinates;
        if (source.transparent) ++transparent;
    }
    looks.materials.emplace_back().name = "default";
    looks.images = std::move(shelf.images);
    if (otherCoordinates > 0)
        notes.push_back(fmt::format(
            "{} materials use other texture coordinates than TEXCOORD_0 as it is; they get those", otherCoordinates));
    if (transparent > 0) notes.push_back(fmt::format("{} transparent materials are drawn opaque", transparent));
    return looks;
}

}  // namespace timeshade::gltf
