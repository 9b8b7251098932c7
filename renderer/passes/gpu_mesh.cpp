#include "passes/gpu_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "core/error.h"
#include "gl/changed_upload.h"
#include "shared/cutout.shared.h"

namespace timeshade {

namespace {

static_assert(static_cast<std::uint32_t>(Wrap::Repeat) == TEXTURE_REPEATS &&
              static_cast<std::uint32_t>(Wrap::Mirror) == TEXTURE_MIRRORS &&
              static_cast<std::uint32_t>(Wrap::Clamp) == TEXTURE_CLAMPS);

/// Largest side of a layer of the image arrays; larger images are reduced to it.
constexpr int imageArraySide = 1024;

/// Bilinear resampling to a square of the given side: one array holds all images of a scene.
std::vector<std::uint8_t> resampled(const Image& image, int side) {
    std::vector<std::uint8_t> out(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 4);
    const auto texel = [&](int x, int y, int channel) {
        const int cx = std::clamp(x, 0, image.width - 1), cy = std::clamp(y, 0, image.height - 1);
        const auto index =
            (static_cast<std::size_t>(cy) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(cx)) * 4;
        return static_cast<double>(image.rgba[index + static_cast<std::size_t>(channel)]);
    };
    std::size_t at = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double fx = (x + 0.5) * image.width / side - 0.5, fy = (y + 0.5) * image.height / side - 0.5;
            const int x0 = static_cast<int>(std::floor(fx)), y0 = static_cast<int>(std::floor(fy));
            const double ax = fx - x0, ay = fy - y0;
            for (int c = 0; c < 4; ++c) {
                const double top = texel(x0, y0, c) * (1 - ax) + texel(x0 + 1, y0, c) * ax;
                const double bottom = texel(x0, y0 + 1, c) * (1 - ax) + texel(x0 + 1, y0 + 1, c) * ax;
                out[at++] = static_cast<std::uint8_t>(std::lround(top * (1 - ay) + bottom * ay));
            }
        }
    }
    return out;
}

gl::Texture imageArray(const std::string& label, GLenum format, const std::vector<Image>& images,
                       const std::vector<int>& wanted) {
    int side = 1;
    for (const int index : wanted) {
        const Image& image = images[static_cast<std::size_t>(index)];
        side = std::max(side, std::min(std::max(image.width, image.height), imageArraySide));
    }
    const int layers = std::max(1, static_cast<int>(wanted.size()));
    const int levels = std::bit_width(static_cast<unsigned>(side));
    gl::Texture texture = gl::Texture::array2D(label, format, side, side, layers, levels);
    if (wanted.empty()) {
        const std::uint32_t white = 0xffffffffu;
        glTextureSubImage3D(texture.name(), 0, 0, 0, 0, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &white);
    }
    for (std::size_t layer = 0; layer < wanted.size(); ++layer) {
        const std::vector<std::uint8_t> texels = resampled(images[static_cast<std::size_t>(wanted[layer])], side);
        glTextureSubImage3D(texture.name(), 0, 0, 0, static_cast<GLint>(layer), side, side, 1, GL_RGBA,
                            GL_UNSIGNED_BYTE, texels.data());
    }
    glGenerateTextureMipmap(texture.name());
    texture.setFilters(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    texture.setWrap(GL_REPEAT);
    return texture;
}

std::uint32_t wrapBits(Wrap u, Wrap v) {
    return static_cast<std::uint32_t>(u) << TEXTURE_WRAP_U_SHIFT | static_cast<std::uint32_t>(v)
                                                                       << TEXTURE_WRAP_V_SHIFT;
}

/// As a number of a material's texels.
float packed(const TextureUse& use) {
    return static_cast<float>(static_cast<std::uint32_t>(use.coordinates) | wrapBits(use.wrapU, use.wrapV));
}

/// Where an image lies in its array, adding it at the end if it is new; -1 stays -1.
int layerOf(std::vector<int>& wanted, int image) {
    if (image < 0) return -1;
    const auto found = std::find(wanted.begin(), wanted.end(), image);
    if (found != wanted.end()) return static_cast<int>(found - wanted.begin());
    wanted.push_back(image);
    return static_cast<int>(wanted.size()) - 1;
}

}  // namespace

void GpuMesh::update(const FramePlan& plan) {
    const bool newScene = allocatedFor_ != plan.mesh->topology;
    // Its materials may lie in memory where those of a scene that is gone lay.
    if (newScene || materialsOf_ != plan.materials) uploadMaterials(plan);
    if (newScene) allocate(plan);
    uploadedBytes_ = 0;
    if (uploaded_ == plan.texels) return;
    const auto upload = [&](gl::Buffer& buffer, const auto& now, const auto* before) {
        const std::span values(now);
        if (before != nullptr) {
            uploadedBytes_ += gl::uploadChanged(buffer, values, std::span(*before));
        } else {
            buffer.upload(values);
            uploadedBytes_ += values.size_bytes();
        }
    };
    const MeshTexels &now = *plan.texels, *before = uploaded_.get();
    upload(*positions_, now.positions, before ? &before->positions : nullptr);
    upload(*shading_, now.shading, before ? &before->shading : nullptr);
    upload(*vertexPositions_, now.vertices, before ? &before->vertices : nullptr);
    uploaded_ = plan.texels;
}

void GpuMesh::allocate(const FramePlan& plan) {
    const MeshTexels& texels = *plan.texels;
    positions_.emplace("triangle positions", std::span<const glm::vec4>(texels.positions).size_bytes());
    shading_.emplace("triangle shading", std::span<const glm::vec4>(texels.shading).size_bytes());
    positionsView_ = gl::Texture::ofBuffer("triangle positions", GL_RGBA32F, *positions_);
    shadingView_ = gl::Texture::ofBuffer("triangle shading", GL_RGBA32F, *shading_);
    trianglesAsVertices_.emplace("triangles as vertices");
    constexpr GLsizei stride = TRIANGLE_POSITION_TEXELS * sizeof(glm::vec4);
    glVertexArrayVertexBuffer(trianglesAsVertices_->name(), 0, positions_->name(), 0, stride);
    for (GLuint i = 0; i < TRIANGLE_POSITION_TEXELS; ++i)
        trianglesAsVertices_->floats(i, 0, 4, i * static_cast<GLuint>(sizeof(glm::vec4)));

    vertexPositions_.emplace("vertex positions", std::span<const glm::vec3>(texels.vertices).size_bytes());
    indices_.emplace("indices", std::span<const glm::u32vec3>(plan.mesh->topology->triangles));
    vertices_.emplace("vertices");
    constexpr auto position = static_cast<GLuint>(sizeof(glm::vec3));
    glVertexArrayVertexBuffer(vertices_->name(), 0, vertexPositions_->name(), 0, 2 * position);
    vertices_->floats(0, 0, 3, 0);
    vertices_->floats(1, 0, 3, position);
    glVertexArrayElementBuffer(vertices_->name(), indices_->name());
    uploadVertices(*plan.mesh->topology);
    triangleCount_ = plan.mesh->topology->triangles.size();
    allocatedFor_ = plan.mesh->topology;
    uploaded_ = nullptr;
}

void GpuMesh::uploadVertices(const MeshTopology& topology) {
    const auto upload = [](const char* label, const std::vector<glm::vec4>& values, std::optional<gl::Buffer>& buffer,
                           std::optional<gl::Texture>& view) {
        view.reset();
        buffer.reset();
        if (values.empty()) return;
        buffer.emplace(label, std::span<const glm::vec4>(values));
        view = gl::Texture::ofBuffer(label, GL_RGBA32F, *buffer);
    };
    upload("vertex colours", topology.colours, vertexColours_, vertexColoursView_);
    upload("more texture coordinates", topology.moreCoordinates, moreCoordinates_, moreCoordinatesView_);
    indicesView_.reset();
    if (vertexColours_ || moreCoordinates_) indicesView_ = gl::Texture::ofBuffer("indices", GL_R32UI, *indices_);
}

void GpuMesh::uploadMaterials(const FramePlan& plan) {
    std::vector<int> colors, data;
    std::vector<glm::vec4> texels;
    for (const Material& material : *plan.materials) {
        const int color = layerOf(colors, material.baseColor.image),
                  other = layerOf(data, material.metallicRoughness.image),
                  emissive = layerOf(colors, material.emissive.image);
        texels.push_back(material.baseColorFactor);
        texels.emplace_back(material.metallicFactor, material.roughnessFactor, static_cast<float>(color),
                            static_cast<float>(other));
        texels.emplace_back(material.emissiveFactor, static_cast<float>(emissive));
        texels.emplace_back(packed(material.baseColor), packed(material.metallicRoughness), packed(material.emissive),
                            0.0f);
    }
    materials_.emplace("materials", std::span<const glm::vec4>(texels));
    materialsView_ = gl::Texture::ofBuffer("materials", GL_RGBA32F, *materials_);
    colorImages_ = imageArray("colour images", GL_SRGB8_ALPHA8, *plan.images, colors);
    dataImages_ = imageArray("metallic-roughness images", GL_RGBA8, *plan.images, data);
    materialsOf_ = plan.materials;
    for (auto* buffer : {&cutoutMaterials_, &cutoutAlphas_}) buffer->reset();
    if (plan.cutouts) uploadCutouts(*plan.cutouts);
}

void GpuMesh::uploadCutouts(const Cutouts& cutouts) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (cutouts.alphas().size() > static_cast<std::size_t>(most))
        throw LimitError(
            fmt::format("the images of materials that are cut out have {} texels; this device's "
                        "GL_MAX_TEXTURE_BUFFER_SIZE is {}: smaller images are needed",
                        cutouts.alphas().size(), most));
    std::vector<glm::u32vec4> records;
    for (const Cutouts::Sheet& sheet : cutouts.sheets())
        records.emplace_back(std::bit_cast<std::uint32_t>(sheet.threshold),
                             static_cast<std::uint32_t>(sheet.width) | static_cast<std::uint32_t>(sheet.height) << 16u,
                             static_cast<std::uint32_t>(sheet.first),
                             (sheet.cuts ? CUTOUT_PRESENT : 0u) | (sheet.nearest ? CUTOUT_NEAREST : 0u) |
                                 wrapBits(sheet.wrapU, sheet.wrapV));
    cutoutMaterials_.emplace("cut-out materials", std::span<const glm::u32vec4>(records));
    cutoutAlphas_.emplace("alphas of cut-outs", std::span<const std::uint8_t>(cutouts.alphas()));
    cutoutMaterialsView_ = gl::Texture::ofBuffer("cut-out materials", GL_RGBA32UI, *cutoutMaterials_);
    cutoutAlphasView_ = gl::Texture::ofBuffer("alphas of cut-outs", GL_R8UI, *cutoutAlphas_);
}

void GpuMesh::bind() const {
    positionsView_->bind(TRIANGLE_POSITIONS_UNIT);
    shadingView_->bind(TRIANGLE_SHADING_UNIT);
    materialsView_->bind(MATERIALS_UNIT);
    if (hasCutouts()) cutoutMaterialsView_->bind(CUTOUT_MATERIALS_UNIT);
    if (hasCutouts()) cutoutAlphasView_->bind(CUTOUT_ALPHAS_UNIT);
    colorImages_->bind(COLOR_IMAGES_UNIT);
    dataImages_->bind(DATA_IMAGES_UNIT);
    if (indicesView_) indicesView_->bind(VERTEX_INDICES_UNIT);
    if (vertexColoursView_) vertexColoursView_->bind(VERTEX_COLOURS_UNIT);
    if (moreCoordinatesView_) moreCoordinatesView_->bind(MORE_COORDINATES_UNIT);
}

std::size_t GpuMesh::bytes() const {
    std::size_t sum = 0;
    for (const auto* buffer : {&positions_, &shading_, &materials_, &vertexPositions_, &indices_, &vertexColours_,
                               &moreCoordinates_, &cutoutMaterials_, &cutoutAlphas_})
        sum += *buffer ? (*buffer)->bytes() : 0;
    for (const auto* texture : {&colorImages_, &dataImages_}) sum += *texture ? (*texture)->bytes() : 0;
    return sum;
}

}  // namespace timeshade
