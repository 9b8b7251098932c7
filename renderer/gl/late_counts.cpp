#include "gl/late_counts.h"

#include <limits>

#include "core/check.h"
#include "gl/waits.h"

namespace timeshade::gl {

LateCounts::~LateCounts() {
    if (buffer_ != 0) glDeleteBuffers(1, &buffer_);
}

void LateCounts::makeMemory() {
    constexpr GLbitfield access = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    constexpr auto bytes = static_cast<GLsizeiptr>(slots * sizeof(GLuint));
    glCreateBuffers(1, &buffer_);
    glNamedBufferStorage(buffer_, bytes, nullptr, access | GL_CLIENT_STORAGE_BIT);
    mapped_ = static_cast<const GLuint*>(glMapNamedBufferRange(buffer_, 0, bytes, access));
}

void LateCounts::begin(Reading reading) {
    if (reading == Reading::Later && buffer_ == 0) makeMemory();
    later_ = reading == Reading::Later && !tooMany_ && mapped_ != nullptr;
    tooMany_ = false;
    expected_.clear();
    end_.reset();
}

void LateCounts::expect(const Buffer& counts, std::size_t place, std::size_t room,
                        std::shared_ptr<ForeseenCount> foreseen) {
    CHECK(later());
    glCopyNamedBufferSubData(counts.name(), buffer_, static_cast<GLintptr>(place * sizeof(GLuint)),
                             static_cast<GLintptr>(expected_.size() * sizeof(GLuint)), sizeof(GLuint));
    expected_.push_back({room, std::move(foreseen)});
}

void LateCounts::end() {
    if (expected_.empty()) return;
    glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
    end_.emplace();
}

LateCounts::State LateCounts::state() {
    if (!expected_.empty()) {
        if (!end_ || !end_->passed()) return State::Pending;
        readAll();
    }
    return tooMany_ ? State::TooMany : State::Sufficed;
}

LateCounts::State LateCounts::settle() {
    if (state() != State::Pending) return state();
    CHECK(end_.has_value());
    countWait();
    end_->wait(std::numeric_limits<GLuint64>::max());
    return state();
}

void LateCounts::readAll() {
    for (std::size_t i = 0; i < expected_.size(); ++i) {
        expected_[i].foreseen->note(mapped_[i]);
        tooMany_ = tooMany_ || mapped_[i] > expected_[i].room;
    }
    expected_.clear();
    end_.reset();
}

}  // namespace timeshade::gl
