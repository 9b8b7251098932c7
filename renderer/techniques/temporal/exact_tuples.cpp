#include "techniques/temporal/exact_tuples.h"

#include <algorithm>

#include "gl/read_back.h"
#include "technique/linked_interval_marks.h"
#include "techniques/temporal/bindings.shared.h"

namespace timeshade {

namespace {

constexpr std::size_t bytesPerTuple = 20;

}  // namespace

ExactTuples::ExactTuples(gl::ProgramCache& programs)
    : programs_(programs),
      lists_(programs),
      times_("tuple times", GL_RG32F),
      depths_("tuple distances", GL_RG32F),
      ids_("tuple triangles", GL_R32UI),
      skipped_("skipped tuples", sizeof(GLuint)),
      target_("tuple target"),
      coverageTarget_("coverage target") {
    target_.setColorCount(0);
    coverageTarget_.setColorCount(0);
}

void ExactTuples::build(const TechniqueFrame& frame, const std::vector<std::uint32_t>& moving, bool coverageMap) {
    const MapSize size = frame.plan.request.mapSize;
    covers_.set(frame.plan, moving);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl::ShaderDefines defines;
    gl::Inputs inputs;
    if (coverageMap) {
        const auto timed = frame.timer.scope("build/coverage");
        drawCoverage(frame);
        inputs.texture("coverageMap", *coverage_);
        defines.emplace_back("COVERAGE_MAP", "1");
    } else {
        coverage_.reset();
    }
    glNamedFramebufferParameteri(target_.name(), GL_FRAMEBUFFER_DEFAULT_WIDTH, size.width);
    glNamedFramebufferParameteri(target_.name(), GL_FRAMEBUFFER_DEFAULT_HEIGHT, size.height);
    glDisable(GL_DEPTH_TEST);
    const GLuint none = 0;
    glNamedBufferSubData(skipped_.name(), 0, sizeof none, &none);
    // Blocks may not be left unbound, though nothing is written while counting.
    const auto reserve = [&](std::size_t count) {
        for (gl::GrowingBuffer* field : {&times_, &depths_, &ids_})
            field->reserve(std::max<std::size_t>(count, 1), "the lists of tuples are too long: lower --map");
        return std::min({times_.capacity(), depths_.capacity(), ids_.capacity()});
    };
    const auto bind = [&] {
        times_.bindForWriting(TUPLE_TIMES_BINDING);
        depths_.bindForWriting(TUPLE_DEPTHS_BINDING);
        ids_.bindForWriting(TUPLE_IDS_BINDING);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, TUPLE_COUNTS_BINDING, skipped_.name());
    };
    {
        const auto timed = frame.timer.scope("build/count");
        if (times_.bytes() == 0) reserve(1);
        bind();
        lists_.beginCount(size.texels());
        target_.bindForDrawing(size.width, size.height);
        covers_.draw(programs_, "techniques/temporal/coverage_intervals.frag", defines,
                     gl::Inputs(inputs).set("filling", 0u));
        tuples_ = lists_.scan(frame.counts, reserve);
    }
    const auto timed = frame.timer.scope("build/tuples");
    bind();
    target_.bindForDrawing(size.width, size.height);
    if (tuples_ > 0)
        covers_.draw(programs_, "techniques/temporal/coverage_intervals.frag", defines,
                     gl::Inputs(inputs).set("filling", 1u));
    CellLists::finishFill();
}

void ExactTuples::drawCoverage(const TechniqueFrame& frame) {
    const MapSize size = frame.plan.request.mapSize;
    if (!coverage_ || MapSize(coverage_->width(), coverage_->height()) != size) {
        coverage_ = gl::Texture::array2D("coverage map", GL_DEPTH_COMPONENT32F, size.width, size.height, 1);
        coverageTarget_.attach(GL_DEPTH_ATTACHMENT, *coverage_);
    }
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    coverageTarget_.bindForDrawing(size.width, size.height);
    const float nobody = 0.0f;
    glClearNamedFramebufferfv(coverageTarget_.name(), GL_DEPTH, 0, &nobody);
    covers_.draw(programs_, "techniques/temporal/claim.frag", {}, {});
}

void ExactTuples::addInputs(gl::Inputs& inputs) const {
    inputs.texture("tupleOffsets", lists_.offsets())
        .texture("tupleTimes", times_.texels())
        .texture("tupleDepths", depths_.texels())
        .texture("tupleIds", ids_.texels());
    if (coverage_) inputs.texture("coverageMap", *coverage_);
}

void ExactTuples::addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const {
    const MapSize size = plan.request.mapSize;
    for (const TexelOnLine& t : texelsAlong(line, {size.width, size.height})) {
        const auto span = gl::readElements<GLuint>(lists_.offsetsBuffer(), listNumber(plan, t.texel), 2);
        const std::size_t first = span[0], count = span[1] - span[0];
        const auto times = gl::readElements<glm::vec2>(times_.buffer(), first, count);
        const auto depths = gl::readElements<glm::vec2>(depths_.buffer(), first, count);
        const auto ids = gl::readElements<GLuint>(ids_.buffer(), first, count);
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec2 u(times[i]), depth(depths[i]);
            marks.push_back({t.xFrom, t.xTo, u.x, u.y, depth.x, depth.y});
            marks.back().triangle = ids[i];
        }
    }
}

TupleCounts ExactTuples::counts() const {
    TupleCounts counts;
    const auto offsets = gl::readElements<GLuint>(lists_.offsetsBuffer(), 0, lists_.cells() + 1);
    for (std::size_t cell = 0; cell + 1 < offsets.size(); ++cell)
        counts.longestList = std::max<std::size_t>(counts.longestList, offsets[cell + 1] - offsets[cell]);
    counts.tuples = offsets.back();
    counts.predictedBytes = counts.tuples * bytesPerTuple + lists_.cells() * 2 * sizeof(GLuint) +
                            covers_.count() * sizeof(GLuint) + covers_.fixedBytes();
    if (coverage_) {
        counts.skippedTuples = gl::readElement<GLuint>(skipped_);
        const auto claims = gl::readTexture<float>(*coverage_, GL_DEPTH_COMPONENT, GL_FLOAT);
        counts.coveredTexels = static_cast<std::size_t>(
            std::count_if(claims.begin(), claims.end(), [](float claim) { return claim > 0.0f; }));
        counts.predictedBytes += coverage_->bytes();
    }
    return counts;
}

std::vector<const gl::Texture*> ExactTuples::textures() const {
    if (!coverage_) return {};
    return {&*coverage_};
}

std::size_t ExactTuples::bytes() const {
    return covers_.bytes() + lists_.bytes() + times_.bytes() + depths_.bytes() + ids_.bytes() + skipped_.bytes() +
           (coverage_ ? coverage_->bytes() : 0);
}

}  // namespace timeshade
