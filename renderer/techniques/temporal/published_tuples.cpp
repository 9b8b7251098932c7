#include "techniques/temporal/published_tuples.h"

#include <algorithm>

#include "gl/counted_draw.h"
#include "gl/read_back.h"
#include "shared/linked_intervals.shared.h"
#include "technique/linked_interval_marks.h"
#include "techniques/temporal/bindings.shared.h"

namespace timeshade {

namespace {

struct DeviceCounts {
    GLuint tuples = 0, skipped = 0;
};

}  // namespace

PublishedTuples::PublishedTuples(gl::ProgramCache& programs)
    : programs_(programs),
      heads_("tuple heads", GL_R32UI),
      tuples_("linked tuples", GL_R32UI),
      counts_("tuple counts", sizeof(DeviceCounts)),
      target_("tuple target") {
    target_.setColorCount(0);
}

void PublishedTuples::build(const TechniqueFrame& frame, const std::vector<std::uint32_t>& moving, bool coverageMap) {
    const MapSize size = frame.plan.request.mapSize;
    texels_ = size.texels();
    covers_.set(frame.plan, moving);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl::ShaderDefines defines;
    gl::Inputs inputs;
    if (coverageMap) {
        const auto timed = frame.timer.scope("build/coverage");
        if (!coverage_) coverage_.emplace(programs_);
        coverage_->draw(size, covers_);
        inputs.texture("coverageMap", coverage_->map());
        defines.emplace_back("COVERAGE_MAP", "1");
    } else {
        coverage_.reset();
    }
    const auto timed = frame.timer.scope("build/tuples");
    glNamedFramebufferParameteri(target_.name(), GL_FRAMEBUFFER_DEFAULT_WIDTH, size.width);
    glNamedFramebufferParameteri(target_.name(), GL_FRAMEBUFFER_DEFAULT_HEIGHT, size.height);
    glDisable(GL_DEPTH_TEST);
    heads_.reserve(texels_, "lower --map");
    const auto makeRoom = [&](std::size_t tuples) {
        tuples_.reserve(std::max<std::size_t>(tuples, 1) * LINKED_INTERVAL_WORDS,
                        "the lists of tuples are too long: lower --map");
        return tuples_.capacity() / LINKED_INTERVAL_WORDS;
    };
    const auto draw = [&](std::size_t room) {
        const GLuint nothing = NO_INTERVAL;
        glClearNamedBufferData(heads_.buffer().name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &nothing);
        const DeviceCounts zero;
        glNamedBufferSubData(counts_.name(), 0, sizeof zero, &zero);
        heads_.bindForWriting(LINKED_HEADS_BINDING);
        tuples_.bindForWriting(LINKED_TUPLES_BINDING);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, TUPLE_COUNTS_BINDING, counts_.name());
        target_.bindForDrawing(size.width, size.height);
        covers_.draw(programs_, "techniques/temporal/published_tuples.frag", defines,
                     gl::Inputs(inputs).set("capacity", static_cast<std::uint32_t>(room)));
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
    };
    count_ = gl::drawCounted(frame.counts, {counts_, foreseen_, count_, makeRoom, draw});
}

void PublishedTuples::addInputs(gl::Inputs& inputs) const {
    inputs.texture("tupleHeads", heads_.texels()).texture("linkedTuples", tuples_.texels());
    if (coverage_) inputs.texture("coverageMap", coverage_->map());
}

void PublishedTuples::addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const {
    addLinkedMarks(plan, heads_.buffer(), tuples_.buffer(), line, marks);
}

TupleCounts PublishedTuples::counts() const {
    TupleCounts counts;
    const auto device = gl::readElement<DeviceCounts>(counts_);
    counts.tuples = device.tuples;
    const auto heads = gl::readElements<GLuint>(heads_.buffer(), 0, texels_);
    const auto tuples = gl::readElements<GLuint>(tuples_.buffer(), 0, counts.tuples * LINKED_INTERVAL_WORDS);
    for (const GLuint head : heads) {
        std::size_t length = 0;
        for (GLuint tuple = head; tuple != NO_INTERVAL; tuple = tuples[std::size_t{tuple} * LINKED_INTERVAL_WORDS + 5])
            ++length;
        counts.longestList = std::max(counts.longestList, length);
    }
    counts.predictedBytes = counts.tuples * LINKED_INTERVAL_WORDS * sizeof(GLuint) + texels_ * sizeof(GLuint) +
                            covers_.count() * sizeof(GLuint) + covers_.fixedBytes();
    if (coverage_) {
        counts.skippedTuples = device.skipped;
        const auto covered = gl::readTexture<float>(coverage_->map(), GL_RED, GL_FLOAT);
        counts.coveredTexels = static_cast<std::size_t>(
            std::count_if(covered.begin(), covered.end(), [](float id) { return id >= 0.0f; }));
        // Nearest map 8 bytes, coverage map 4, depth 4.
        counts.predictedBytes += texels_ * 16;
    }
    return counts;
}

std::vector<const gl::Texture*> PublishedTuples::textures() const {
    if (!coverage_) return {};
    return {&coverage_->map()};
}

std::size_t PublishedTuples::bytes() const {
    return covers_.bytes() + heads_.bytes() + tuples_.bytes() + counts_.bytes() + (coverage_ ? coverage_->bytes() : 0);
}

}  // namespace timeshade
