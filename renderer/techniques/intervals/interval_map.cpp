#include "techniques/intervals/interval_map.h"

#include <algorithm>

#include "gl/dispatch.h"
#include "gl/read_back.h"
#include "technique/linked_interval_marks.h"
#include "techniques/intervals/bindings.shared.h"

namespace timeshade {

namespace {

constexpr std::size_t bytesPerInterval = 20;
constexpr std::size_t groupSize = 64;  // of all compute shaders here
/// Of an invocation, of all its loops together, before a software renderer breaks them off.
constexpr std::uint32_t roundsOfLoops = 60000;
constexpr float afterClose = 1.5f;  // what begins later is no interval

}  // namespace

IntervalMap::IntervalMap(gl::ProgramCache& programs)
    : programs_(programs),
      lists_(programs),
      times_("interval times", GL_RG32F),
      depths_("interval distances", GL_RG32F),
      ids_("interval triangles", GL_R32UI),
      visibleTimes_("visible times", GL_RG32F),
      arrangedLists_(programs),
      arrangedTimes_("arranged times", GL_RG32F),
      arrangedDepths_("arranged distances", GL_RG32F),
      arrangedIds_("arranged triangles", GL_R32UI),
      errors_("compression errors", GL_R32F),
      bentParts_("bent intervals", sizeof(GLuint)),
      target_("interval target") {
    target_.setColorCount(0);
}

void IntervalMap::build(const TechniqueFrame& frame, const std::vector<std::uint32_t>& triangles, const Form& form) {
    const MapSize size = frame.plan.request.mapSize;
    form_ = form;
    covers_.set(frame.plan, triangles);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDisable(GL_DEPTH_TEST);
    glNamedFramebufferParameteri(target_.name(), GL_FRAMEBUFFER_DEFAULT_WIDTH, size.width);
    glNamedFramebufferParameteri(target_.name(), GL_FRAMEBUFFER_DEFAULT_HEIGHT, size.height);
    const GLuint none = 0;
    glNamedBufferSubData(bentParts_.name(), 0, sizeof none, &none);
    {
        const auto timed = frame.timer.scope("build/count");
        if (times_.bytes() == 0) reserve(1);
        bindEntries();  // blocks may not be left unbound, though nothing is written while counting
        lists_.beginCount(size.texels());
        collect(frame, false);
        collected_ = lists_.scan(frame.counts, [&](std::size_t count) { return reserve(count); });
    }
    {
        const auto timed = frame.timer.scope("build/intervals");
        bindEntries();
        if (collected_ > 0) collect(frame, true);
    }
    const auto timed = frame.timer.scope("build/arrange");
    if (form_.asPublished)
        arrangeAsPublished(frame);
    else
        arrangeVisible(frame);
    CellLists::finishFill();
}

std::size_t IntervalMap::reserve(std::size_t count) {
    for (gl::GrowingBuffer* field : {&times_, &depths_, &ids_})
        field->reserve(std::max<std::size_t>(count, 1), "the lists of intervals are too long: lower --map");
    return std::min({times_.capacity(), depths_.capacity(), ids_.capacity()});
}

std::size_t IntervalMap::reserveArranged(std::size_t count) {
    for (gl::GrowingBuffer* field : {&arrangedTimes_, &arrangedDepths_, &arrangedIds_})
        field->reserve(std::max<std::size_t>(count, 1), "the lists of intervals are too long: lower --map");
    return std::min({arrangedTimes_.capacity(), arrangedDepths_.capacity(), arrangedIds_.capacity()});
}

void IntervalMap::bindArranged() const {
    arrangedTimes_.bindForWriting(ARRANGED_TIMES_BINDING);
    arrangedDepths_.bindForWriting(ARRANGED_DEPTHS_BINDING);
    arrangedIds_.bindForWriting(ARRANGED_IDS_BINDING);
}

void IntervalMap::bindEntries() const {
    if (lists_.cells() > 0)
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, LIST_OFFSETS_BINDING, lists_.offsetsBuffer().name());
    times_.bindForWriting(INTERVAL_TIMES_BINDING);
    depths_.bindForWriting(INTERVAL_DEPTHS_BINDING);
    ids_.bindForWriting(INTERVAL_IDS_BINDING);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, INTERVAL_COUNTS_BINDING, bentParts_.name());
}

void IntervalMap::collect(const TechniqueFrame& frame, bool fill) {
    const MapSize size = frame.plan.request.mapSize;
    gl::ShaderDefines defines{frame.settings};
    gl::Inputs inputs;
    inputs.set("filling", fill ? 1u : 0u);
    if (form_.asPublished) defines.emplace_back("AS_PUBLISHED", "1");
    if (form_.staticMap != nullptr) {
        defines.emplace_back("STATIC_TRIANGLES", "1");
        inputs.texture("staticMap", *form_.staticMap);
    }
    target_.bindForDrawing(size.width, size.height);
    covers_.draw(programs_, "techniques/intervals/collect.frag", defines, inputs);
}

void IntervalMap::arrangeVisible(const TechniqueFrame& frame) {
    visibleTimes_.reserve(std::max<std::size_t>(collected_, 1), "the lists of intervals are too long: lower --map");
    arrangedLists_.beginCount(lists_.cells());
    bindEntries();
    visibleTimes_.bindForWriting(VISIBLE_TIMES_BINDING);
    gl::ShaderDefines defines{frame.settings};
    if (frame.plan.cutouts) defines.emplace_back("CUTOUTS", "1");
    run({.label = "intervals visible", .defines = defines, .compute = "techniques/intervals/visible.comp"}, entries(),
        collected_);
    arrangedLists_.scan(frame.counts, [&](std::size_t count) { return reserveArranged(count); });
    bindArranged();
    bindEntries();
    visibleTimes_.bindForWriting(VISIBLE_TIMES_BINDING);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, ARRANGED_OFFSETS_BINDING, arrangedLists_.offsetsBuffer().name());
    run({.label = "intervals arrange", .compute = "techniques/intervals/arrange.comp"}, entries(), collected_);
}

void IntervalMap::arrangeAsPublished(const TechniqueFrame& frame) {
    reserveArranged(collected_);
    bindArranged();
    bindEntries();
    gl::Inputs inputs = entries();
    inputs.set("asDrawn", form_.capacity > 0 ? 1u : 0u);
    run({.label = "intervals arrange as published",
         .defines = {{"AS_PUBLISHED", "1"}},
         .compute = "techniques/intervals/arrange.comp"},
        inputs, collected_);
    const std::size_t cells = lists_.cells();
    errors_.reserve(cells, "lower --map");
    errors_.bindForWriting(INTERVAL_ERRORS_BINDING);
    const float none = 0.0f;
    glClearNamedBufferData(errors_.buffer().name(), GL_R32F, GL_RED, GL_FLOAT, &none);
    if (form_.capacity == 0) return;
    const std::uint32_t step = roundsOfLoops / (4 * form_.capacity + 8);
    const auto longest = static_cast<std::uint32_t>(
        lists_.longest(frame.counts, [&](std::size_t length) { return (length + step - 1) / step * step; }));
    for (std::uint32_t from = 0; from < longest; from += step)
        run({.label = "intervals compress", .compute = "techniques/intervals/compress.comp"},
            gl::Inputs()
                .set("texels", static_cast<std::uint32_t>(cells))
                .set("capacity", form_.capacity)
                .set("from", from)
                .set("to", from + step),
            cells);
}

gl::Inputs IntervalMap::entries() const {
    return gl::Inputs()
        .set("texels", static_cast<std::uint32_t>(lists_.cells()))
        .set("intervals", static_cast<std::uint32_t>(collected_));
}

void IntervalMap::run(const gl::ProgramDescription& source, const gl::Inputs& inputs, std::size_t invocations) {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    programs_.get(source).use(inputs);
    gl::dispatch(gl::groupsFor(invocations, groupSize));
}

const CellLists& IntervalMap::lookedUp() const { return form_.asPublished ? lists_ : arrangedLists_; }

void IntervalMap::addInputs(gl::Inputs& inputs) const {
    inputs.texture("intervalOffsets", lookedUp().offsets())
        .texture("intervalTimes", arrangedTimes_.texels())
        .texture("intervalDepths", arrangedDepths_.texels())
        .texture("intervalIds", arrangedIds_.texels());
}

void IntervalMap::addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const {
    const MapSize size = plan.request.mapSize;
    for (const TexelOnLine& t : texelsAlong(line, {size.width, size.height})) {
        const auto span = gl::readElements<GLuint>(lookedUp().offsetsBuffer(), listNumber(plan, t.texel), 2);
        const std::size_t first = span[0], count = span[1] - span[0];
        const auto times = gl::readElements<glm::vec2>(arrangedTimes_.buffer(), first, count);
        const auto depths = gl::readElements<glm::vec2>(arrangedDepths_.buffer(), first, count);
        const auto ids = gl::readElements<GLuint>(arrangedIds_.buffer(), first, count);
        for (std::size_t i = 0; i < count && times[i].x < afterClose; ++i) {
            const glm::dvec2 u(times[i]), depth(depths[i]);
            marks.push_back({t.xFrom, t.xTo, u.x, u.y, depth.x, depth.y});
            marks.back().triangle = ids[i];
        }
    }
}

IntervalCounts IntervalMap::counts() const {
    IntervalCounts counts;
    const auto offsets = gl::readElements<GLuint>(lookedUp().offsetsBuffer(), 0, lists_.cells() + 1);
    counts.collected = form_.asPublished ? offsets.back() : lists_.total();
    const auto times = gl::readElements<glm::vec2>(arrangedTimes_.buffer(), 0, offsets.back());
    for (std::size_t cell = 0; cell + 1 < offsets.size(); ++cell) {
        std::size_t kept = 0;
        for (std::size_t i = offsets[cell]; i < offsets[cell + 1] && times[i].x < afterClose; ++i) ++kept;
        counts.kept += kept;
        counts.most = std::max(counts.most, kept);
        counts.texelsInUse += kept > 0 ? 1u : 0u;
    }
    counts.bentParts = gl::readElements<GLuint>(bentParts_, 0, 1)[0];
    counts.usedBytes = counts.collected * bytesPerInterval + times.size() * bytesPerInterval +
                       lists_.cells() * 2 * sizeof(GLuint) + covers_.count() * sizeof(GLuint) + covers_.fixedBytes();
    if (form_.asPublished)
        addErrors(offsets, counts);
    else
        counts.usedBytes += counts.collected * sizeof(glm::vec2) + lists_.cells() * 2 * sizeof(GLuint);
    return counts;
}

void IntervalMap::addErrors(const std::vector<GLuint>& offsets, IntervalCounts& counts) const {
    const auto errors = gl::readElements<float>(errors_.buffer(), 0, lists_.cells());
    counts.usedBytes += lists_.cells() * sizeof(float);
    double sum = 0.0;
    for (std::size_t cell = 0; cell < errors.size(); ++cell) {
        if (form_.capacity == 0 || offsets[cell + 1] - offsets[cell] <= form_.capacity) continue;
        const auto error = static_cast<double>(errors[cell]);
        ++counts.overflowed;
        sum += error;
        counts.mostError = std::max(counts.mostError, error);
    }
    if (counts.overflowed > 0) counts.meanError = sum / static_cast<double>(counts.overflowed);
}

std::size_t IntervalMap::bytes() const {
    return covers_.bytes() + lists_.bytes() + times_.bytes() + depths_.bytes() + ids_.bytes() + errors_.bytes() +
           bentParts_.bytes() + visibleTimes_.bytes() + arrangedLists_.bytes() + arrangedTimes_.bytes() +
           arrangedDepths_.bytes() + arrangedIds_.bytes();
}

}  // namespace timeshade
