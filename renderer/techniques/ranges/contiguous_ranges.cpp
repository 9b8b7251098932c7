#include "techniques/ranges/contiguous_ranges.h"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>
#include <glm/packing.hpp>

#include "core/error.h"
#include "gl/dispatch.h"
#include "gl/read_back.h"
#include "gl/uploads.h"
#include "technique/linked_interval_marks.h"
#include "techniques/ranges/bindings.shared.h"

namespace timeshade {

namespace {

/// As many prisms as are drawn by one call: their vertices are numbered by 16 bits.
constexpr std::size_t prismsPerCall = 2048;
constexpr std::size_t verticesPerPrism = 9, indicesPerPrism = 42;
constexpr std::size_t bytesPerFragment = 20;

/// Fourteen triangles over the nine vertices of prism.vert. The last vertex of each says what the triangle is.
std::vector<std::uint16_t> prismIndices() {
    std::vector<std::uint16_t> indices;
    for (std::size_t prism = 0; prism < prismsPerCall; ++prism) {
        const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
            for (const std::size_t vertex : {a, b, c})
                indices.push_back(static_cast<std::uint16_t>(prism * verticesPerPrism + vertex));
        };
        add(0, 1, 2);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, centre = 6 + i;
            add(i, j, centre);
            add(j, 3 + j, centre);
            add(3 + j, 3 + i, centre);
            add(3 + i, i, centre);
        }
        add(3, 4, 5);  // last, as its time is: fragments that come in order need no sorting
    }
    return indices;
}

/// As generate.comp counts them.
struct DeviceCounts {
    std::uint32_t unpairedLists = 0, longestList = 0, sparePlaces = 0, emptyRanges = 0;
};

}  // namespace

ContiguousRanges::ContiguousRanges(gl::ProgramCache& programs)
    : programs_(programs),
      lists_(programs),
      triangles_("prism triangles", GL_R32UI),
      ids_("range triangles", GL_RG32UI),
      times_("range times", GL_RG32F),
      distances_("range distances", GL_RG32F),
      slopes_("range slopes", GL_RGBA32UI),
      counts_("range counts", sizeof(DeviceCounts)),
      indices_("prism indices", std::span<const std::uint16_t>(prismIndices())),
      none_("prisms"),
      target_("prism target") {
    glVertexArrayElementBuffer(none_.name(), indices_.name());
    target_.setColorCount(0);
}

void ContiguousRanges::build(const TechniqueFrame& frame, const LightMotion& motion) {
    const MapSize size = frame.plan.request.mapSize;
    const std::size_t texels = size.texels();
    prisms_ = motion.dynamicCasters.size();
    GLint64 largest = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
    if ((texels + 1) * sizeof(GLuint) > static_cast<std::size_t>(largest))
        throw Error(
            fmt::format("a list for each of {} x {} texels needs blocks of {} bytes; this device's "
                        "GL_MAX_SHADER_STORAGE_BLOCK_SIZE "
                        "is {}: lower --map",
                        size.width, size.height, (texels + 1) * sizeof(GLuint), largest));
    {
        const auto timed = frame.timer.scope("build/collect");
        triangles_.reserve(std::max<std::size_t>(prisms_, 1), "a scene of fewer moving triangles is needed");
        gl::upload(triangles_.buffer().name(), std::span<const std::uint32_t>(motion.dynamicCasters));
        glNamedFramebufferParameteri(target_.name(), GL_FRAMEBUFFER_DEFAULT_WIDTH, size.width);
        glNamedFramebufferParameteri(target_.name(), GL_FRAMEBUFFER_DEFAULT_HEIGHT, size.height);
        lists_.beginCount(texels);
        drawPrisms(frame, false);
        places_ = lists_.scan(
            frame.counts, [&](std::size_t places) { return makeRoom(places); }, 2);
        ids_.bindForWriting(RANGES_IDS_BINDING);
        times_.bindForWriting(RANGES_TIMES_BINDING);
        distances_.bindForWriting(RANGES_DISTANCES_BINDING);
        slopes_.bindForWriting(RANGES_SLOPES_BINDING);
        drawPrisms(frame, true);
    }
    const auto timed = frame.timer.scope("build/generate");
    const DeviceCounts none;
    glNamedBufferSubData(counts_.name(), 0, sizeof none, &none);
    lists_.bindCursors();
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, LIST_OFFSETS_BINDING, lists_.offsetsBuffer().name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, RANGES_COUNTS_BINDING, counts_.name());
    const gl::Program& program =
        programs_.get({.label = "ranges generate", .compute = "techniques/ranges/generate.comp"});
    program.use(gl::Inputs().set("texels", static_cast<std::uint32_t>(texels)));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    if (places_ > 0) gl::dispatch(gl::groupsFor(texels, 64));
    CellLists::finishFill();
}

/// Two places a range.
std::size_t ContiguousRanges::makeRoom(std::size_t places) {
    std::size_t ranges = ids_.capacity();
    for (gl::GrowingBuffer* field : {&ids_, &times_, &distances_, &slopes_}) {
        field->reserve(std::max<std::size_t>((places + 1) / 2, 1), "the lists of ranges are too long: lower --map");
        ranges = field == &ids_ ? field->capacity() : std::min(ranges, field->capacity());
    }
    return 2 * ranges;
}

void ContiguousRanges::drawPrisms(const TechniqueFrame& frame, bool fill) {
    gl::ShaderDefines defines;
    if (frame.plan.light.projection == Projection::Orthographic) defines.emplace_back("LIGHT_ORTHOGRAPHIC", "1");
    if (fill) defines.emplace_back("FILL", "1");
    const gl::Program& program =
        programs_.get({"ranges collect", "techniques/ranges/prism.vert", "techniques/ranges/collect.frag", defines});
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    target_.bindForDrawing(frame.plan.request.mapSize.width, frame.plan.request.mapSize.height);
    program.use(gl::Inputs().texture("prismTriangles", triangles_.texels()));
    glBindVertexArray(none_.name());
    for (std::size_t first = 0; first < prisms_; first += prismsPerCall) {
        const std::size_t count = std::min(prismsPerCall, prisms_ - first);
        glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(count * indicesPerPrism), GL_UNSIGNED_SHORT,
                                 nullptr, static_cast<GLint>(first * verticesPerPrism));
    }
}

void ContiguousRanges::addInputs(gl::Inputs& inputs) const {
    inputs.texture("listOffsets", lists_.offsets())
        .texture("rangeTimes", times_.texels())
        .texture("rangeDistances", distances_.texels())
        .texture("rangeIds", ids_.texels())
        .texture("rangeSlopes", slopes_.texels());
}

void ContiguousRanges::addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const {
    const glm::dvec2 size = plan.request.mapSize.sides();
    const auto texelWidth = [&](double distance) {
        const auto width = static_cast<double>(plan.block.lightCone.w);
        return plan.light.projection == Projection::Orthographic ? width : width * distance;
    };
    for (const TexelOnLine& t : texelsAlong(line, glm::ivec2(size))) {
        const auto span = gl::readElements<GLuint>(lists_.offsetsBuffer(), listNumber(plan, t.texel), 2);
        const std::size_t first = span[0] / 2, count = span[1] / 2 - span[0] / 2;
        const auto times = gl::readElements<glm::vec2>(times_.buffer(), first, count);
        const auto distances = gl::readElements<glm::vec2>(distances_.buffer(), first, count);
        const auto slopes = gl::readElements<glm::uvec4>(slopes_.buffer(), first, count);
        const auto ids = gl::readElements<glm::uvec2>(ids_.buffer(), first, count);
        // From the texel's centre, as the lookup extrapolates.
        const glm::dvec2 offset = line.at(0.5 * (t.xFrom + t.xTo)) * size - (glm::dvec2(t.texel) + 0.5);
        const glm::dvec2 way = (line.to - line.from) * size * (t.xTo - t.xFrom);
        for (std::size_t i = 0; i < count; ++i) {
            if (times[i].x > times[i].y) continue;  // empty
            const auto slope = [&](int word) { return glm::dvec2(glm::unpackHalf2x16(slopes[i][word])); };
            const glm::dvec2 u(times[i]), d(distances[i]);
            StoredMark mark{t.xFrom,
                            t.xTo,
                            u.x + glm::dot(offset, slope(0)),
                            u.y + glm::dot(offset, slope(2)),
                            d.x + texelWidth(d.x) * glm::dot(offset, slope(1)),
                            d.y + texelWidth(d.y) * glm::dot(offset, slope(3))};
            mark.uFromSlope = glm::dot(way, slope(0));
            mark.uToSlope = glm::dot(way, slope(2));
            mark.triangle = ids[i].x;
            if (mark.uFrom < mark.uTo) marks.push_back(mark);
        }
    }
}

RangeCounts ContiguousRanges::counts() const {
    const auto device = gl::readElement<DeviceCounts>(counts_);
    const std::size_t places = lists_.total();
    RangeCounts counts;
    counts.fragments = places - device.sparePlaces;
    counts.ranges = places / 2 - device.emptyRanges;
    counts.longestList = device.longestList;
    counts.unpairedLists = device.unpairedLists;
    // Equation 2 has a fragment of 16 bytes, a range of 24 besides, and two words a texel. Here a range lies where its
    // two fragments lay; the two words are the texel's place and its cursor.
    counts.predictedBytes = places * bytesPerFragment + 2 * lists_.cells() * sizeof(std::uint32_t) +
                            prisms_ * sizeof(std::uint32_t) + indices_.bytes();
    return counts;
}

std::size_t ContiguousRanges::bytes() const {
    return lists_.bytes() + triangles_.bytes() + ids_.bytes() + times_.bytes() + distances_.bytes() + slopes_.bytes() +
           counts_.bytes() + indices_.bytes();
}

}  // namespace timeshade
