#include "techniques/deep/visibility_map.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "gl/dispatch.h"
#include "gl/read_back.h"
#include "technique/linked_interval_marks.h"
#include "techniques/deep/bindings.shared.h"

namespace timeshade {

namespace {

/// As compress.comp counts them.
struct DeviceCounts {
    std::uint32_t hits = 0, texelsInUse = 0, mostNodes = 0;
};

}  // namespace

VisibilityMap::VisibilityMap(gl::ProgramCache& programs, std::size_t maximumRawBytes)
    : programs_(programs),
      maximumRawBytes_(maximumRawBytes),
      rasterizer_(programs),
      lists_(programs),
      nodes_("visibility nodes", GL_RG32F),
      counts_("visibility counts", sizeof(DeviceCounts)) {}

void VisibilityMap::build(const TechniqueFrame& frame, const StochasticRasterizer::Strata& strata) {
    const MapSize size = frame.plan.request.mapSize;
    const int layers = static_cast<int>(strata.count), rows = rowsAtOnce(size, strata.count);
    if (!samples_ || MapSize(samples_->width(), samples_->height()) != MapSize(size.width, rows) ||
        samples_->layers() != layers) {
        samples_.reset();  // first, so that both need not fit at once
        samples_ = gl::Texture::array2D("deep samples", GL_DEPTH_COMPONENT32F, size.width, rows, layers);
    }
    const DeviceCounts none;
    glNamedBufferSubData(counts_.name(), 0, sizeof none, &none);
    lists_.beginCount(size.texels());
    drawAll(frame, strata, false);
    lists_.scan(frame.counts, [&](std::size_t nodes) {
        nodes_.reserve(std::max<std::size_t>(nodes, 1), "lower --map, or allow a greater deep.error");
        return nodes_.capacity();
    });
    drawAll(frame, strata, true);
    CellLists::finishFill();
}

int VisibilityMap::rowsAtOnce(const MapSize& size, std::uint32_t times) const {
    const std::size_t row = static_cast<std::size_t>(size.width) * times * sizeof(float),
                      most = std::min(maximumRawBytes_ / row, static_cast<std::size_t>(size.height));
    return std::max(static_cast<int>(most), 1);
}

void VisibilityMap::drawAll(const TechniqueFrame& frame, const StochasticRasterizer::Strata& strata, bool fill) {
    const int height = frame.plan.request.mapSize.height, rows = samples_->height();
    for (int firstRow = 0; firstRow < height; firstRow += rows) {
        if (!fill || rows < height) {
            const auto timed = frame.timer.scope("build/times");
            rasterizer_.draw(frame.mesh, frame.plan.light, {&frame.plan.light.dynamicTriangles},
                             StochasticRasterizer::Role::Light, StochasticRasterizer::Output::DepthOnly, strata,
                             nullptr, *samples_, nullptr, firstRow);
        }
        const auto timed = frame.timer.scope("build/compress");
        compress(frame, strata, firstRow, fill);
    }
}

void VisibilityMap::compress(const TechniqueFrame& frame, const StochasticRasterizer::Strata& strata, int firstRow,
                             bool fill) {
    gl::ShaderDefines defines = frame.defines();
    defines.emplace_back("CAPACITY", fmt::format("{}", std::bit_ceil(strata.count)));
    if (fill) defines.emplace_back("FILL", "1");
    const gl::Program& program =
        programs_.get({.label = "deep compress", .defines = defines, .compute = "techniques/deep/compress.comp"});
    lists_.bindCursors();
    if (fill) nodes_.bindForWriting(DEEP_NODES_BINDING);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, DEEP_COUNTS_BINDING, counts_.name());
    gl::Inputs inputs;
    inputs.texture("samples", *samples_).set("times", strata.count).set("timeLength", strata.length);
    inputs.set("firstRow", firstRow);
    if (fill) inputs.texture("nodeOffsets", lists_.offsets());
    program.use(inputs);
    const std::size_t texels =
        static_cast<std::size_t>(samples_->width()) * static_cast<std::size_t>(samples_->height());
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    gl::dispatch(gl::groupsFor(texels, 64));
}

void VisibilityMap::addInputs(gl::Inputs& inputs) const {
    inputs.texture("nodeOffsets", lists_.offsets()).texture("nodes", nodes_.texels());
}

void VisibilityMap::addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const {
    const MapSize size = plan.request.mapSize;
    for (const TexelOnLine& t : texelsAlong(line, {size.width, size.height})) {
        const auto span = gl::readElements<GLuint>(lists_.offsetsBuffer(), listNumber(plan, t.texel), 2);
        const auto nodes = gl::readElements<glm::vec2>(nodes_.buffer(), span[0], span[1] - span[0]);
        double depth = nodes.empty() ? 0.0 : static_cast<double>(nodes.front().x), visibility = 1.0;
        for (const glm::vec2& node : nodes) {
            const auto after = static_cast<double>(node.y);
            // What the nodes lose of the light that is left, all of it where nothing is left behind.
            const double opacity = std::min((visibility - after) / visibility, 1.0);
            if (opacity > 0.0) {
                marks.push_back({t.xFrom, t.xTo, 0.0, 1.0, depth, depth});
                marks.back().opacity = opacity;
            }
            if (after <= 0.0) break;
            depth = static_cast<double>(node.x);
            visibility = after;
        }
    }
}

VisibilityMapCounts VisibilityMap::counts() const {
    const auto device = gl::readElement<DeviceCounts>(counts_);
    return {device.hits, device.texelsInUse, device.mostNodes, lists_.total()};
}

std::size_t VisibilityMap::functionBytes() const {
    return (lists_.cells() + 1) * sizeof(std::uint32_t) + lists_.total() * 2 * sizeof(float);
}

std::size_t VisibilityMap::bytes() const {
    return rawBytes() + lists_.bytes() + nodes_.bytes() + counts_.bytes() + rasterizer_.bytes();
}

}  // namespace timeshade
