#include "techniques/ranges/linked_ranges.h"

#include <algorithm>

#include "gl/counted_draw.h"
#include "gl/dispatch.h"
#include "gl/read_back.h"
#include "gl/uploads.h"
#include "shared/linked_intervals.shared.h"
#include "technique/linked_interval_marks.h"
#include "techniques/ranges/bindings.shared.h"

namespace timeshade {

namespace {

constexpr std::size_t bytesPerFragment = 16, bytesPerRange = LINKED_INTERVAL_WORDS * sizeof(std::uint32_t);
const char* const advice =
    "the linked lists are too long: lower --map, or use the repaired form, whose fragments are smaller";

/// As the shaders count them.
struct DeviceCounts {
    std::uint32_t fragments = 0, ranges = 0, unpairedLists = 0, longestList = 0;
};

}  // namespace

LinkedRanges::LinkedRanges(gl::ProgramCache& programs)
    : programs_(programs),
      triangles_("prism triangles", GL_R32UI),
      heads_("fragment heads", GL_R32UI),
      fragmentList_("linked fragments", GL_RGBA32UI),
      rangeHeads_("range heads", GL_R32UI),
      rangeList_("linked ranges", GL_R32UI),
      counts_("linked counts", sizeof(DeviceCounts)),
      none_("prism points"),
      target_("prism target") {
    target_.setColorCount(0);
}

void LinkedRanges::build(const TechniqueFrame& frame, const LightMotion& motion) {
    const MapSize size = frame.plan.request.mapSize;
    texels_ = size.texels();
    prisms_ = motion.dynamicCasters.size();
    triangles_.reserve(std::max<std::size_t>(prisms_, 1), "a scene of fewer moving triangles is needed");
    gl::upload(triangles_.buffer().name(), std::span<const std::uint32_t>(motion.dynamicCasters));
    heads_.reserve(texels_, advice);
    rangeHeads_.reserve(texels_, advice);
    glNamedFramebufferParameteri(target_.name(), GL_FRAMEBUFFER_DEFAULT_WIDTH, size.width);
    glNamedFramebufferParameteri(target_.name(), GL_FRAMEBUFFER_DEFAULT_HEIGHT, size.height);
    {
        const auto timed = frame.timer.scope("build/collect");
        const auto makeRoom = [&](std::size_t fragments) {
            fragmentList_.reserve(std::max<std::size_t>(fragments, 1), advice);
            return fragmentList_.capacity();
        };
        const auto draw = [&](std::size_t room) { collect(frame, room); };
        fragments_ = gl::drawCounted(frame.counts, {counts_, foreseen_, fragments_, makeRoom, draw});
    }
    const auto timed = frame.timer.scope("build/generate");
    rangeList_.reserve(std::max<std::size_t>(fragments_ / 2, 1) * LINKED_INTERVAL_WORDS, advice);
    generate();
}

void LinkedRanges::collect(const TechniqueFrame& frame, std::size_t room) {
    const MapSize size = frame.plan.request.mapSize;
    const GLuint none = NO_INTERVAL;
    const DeviceCounts zero;
    glClearNamedBufferData(heads_.buffer().name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
    glNamedBufferSubData(counts_.name(), 0, sizeof zero, &zero);
    heads_.bindForWriting(LINKED_HEADS_BINDING);
    fragmentList_.bindForWriting(LINKED_FRAGMENTS_BINDING);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, LINKED_COUNTS_BINDING, counts_.name());
    gl::ShaderDefines defines;
    if (frame.plan.light.projection == Projection::Orthographic) defines.emplace_back("LIGHT_ORTHOGRAPHIC", "1");
    const gl::Program& program = programs_.get({.label = "published ranges collect",
                                                .vertex = "techniques/ranges/published_prism.vert",
                                                .fragment = "techniques/ranges/published_collect.frag",
                                                .defines = defines,
                                                .geometry = "techniques/ranges/published_prism.geom"});
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    target_.bindForDrawing(size.width, size.height);
    program.use(
        gl::Inputs().texture("prismTriangles", triangles_.texels()).set("capacity", static_cast<std::uint32_t>(room)));
    glBindVertexArray(none_.name());
    if (prisms_ > 0) glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(prisms_));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void LinkedRanges::generate() {
    rangeHeads_.bindForWriting(LINKED_RANGE_HEADS_BINDING);
    rangeList_.bindForWriting(LINKED_RANGES_BINDING);
    const gl::Program& program =
        programs_.get({.label = "published ranges generate", .compute = "techniques/ranges/published_generate.comp"});
    program.use(gl::Inputs().set("texels", static_cast<std::uint32_t>(texels_)));
    gl::dispatch(gl::groupsFor(texels_, 64));
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void LinkedRanges::addInputs(gl::Inputs& inputs) const {
    inputs.texture("rangeHeads", rangeHeads_.texels()).texture("ranges", rangeList_.texels());
}

void LinkedRanges::addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const {
    addLinkedMarks(plan, rangeHeads_.buffer(), rangeList_.buffer(), line, marks);
}

RangeCounts LinkedRanges::counts() const {
    const auto device = gl::readElement<DeviceCounts>(counts_);
    RangeCounts counts;
    counts.fragments = device.fragments;
    counts.ranges = device.ranges;
    counts.longestList = device.longestList;
    counts.unpairedLists = device.unpairedLists;
    counts.predictedBytes =
        counts.fragments * bytesPerFragment + counts.ranges * bytesPerRange + 2 * texels_ * sizeof(std::uint32_t);
    return counts;
}

std::size_t LinkedRanges::bytes() const {
    return triangles_.bytes() + heads_.bytes() + fragmentList_.bytes() + rangeHeads_.bytes() + rangeList_.bytes() +
           counts_.bytes();
}

}  // namespace timeshade
