#include "gl/pass_timer.h"

#include <algorithm>

#include "core/pause.h"
#include "gl/errors.h"
#include "gl/waits.h"

namespace timeshade::gl {

PassTimer::PassTimer(Clock clock) : clock_(clock) {}

PassTimer::~PassTimer() {
    recycle(current_);
    for (const Frame& frame : pending_) recycle(frame);
    if (!freeQueries_.empty()) glDeleteQueries(static_cast<GLsizei>(freeQueries_.size()), freeQueries_.data());
}

PassTimer::Scope::Scope(PassTimer& timer, std::string name) : timer_(timer), step_(timer.current_.size()) {
    Step step;
    step.name = std::move(name);
    if (timer.clock_ == Clock::Finish) {
        glFinish();
    } else {
        step.beginQuery = timer.timestamp();
    }
    step.begin = std::chrono::steady_clock::now();
    step.paused = millisecondsPaused();
    injectErrorForTest(step.name);
    timer.current_.push_back(std::move(step));
}

PassTimer::Scope::~Scope() {
    Step& step = timer_.current_[step_];
    if (timer_.clock_ == Clock::Finish) {
        glFinish();
        step.end = std::chrono::steady_clock::now();
    } else {
        step.end = std::chrono::steady_clock::now();
        step.endQuery = timer_.timestamp();
    }
    step.paused = millisecondsPaused() - step.paused;
}

GLuint PassTimer::timestamp() {
    GLuint query = 0;
    if (freeQueries_.empty()) {
        glCreateQueries(GL_TIMESTAMP, 1, &query);
    } else {
        query = freeQueries_.back();
        freeQueries_.pop_back();
    }
    glQueryCounter(query, GL_TIMESTAMP);
    return query;
}

std::vector<PassTimer::Reading> PassTimer::read(const Frame& frame) {
    std::vector<Reading> readings;
    for (const Step& step : frame) {
        const double host = std::chrono::duration<double, std::milli>(step.end - step.begin).count() - step.paused;
        double milliseconds = host;
        if (clock_ == Clock::Timestamps) {
            GLuint64 begin = 0, end = 0;
            glGetQueryObjectui64v(step.beginQuery, GL_QUERY_RESULT, &begin);
            glGetQueryObjectui64v(step.endQuery, GL_QUERY_RESULT, &end);
            milliseconds = static_cast<double>(end - begin) * 1e-6;
        }
        const auto same =
            std::find_if(readings.begin(), readings.end(), [&](const Reading& r) { return r.name == step.name; });
        if (same == readings.end())
            readings.push_back({step.name, milliseconds, host});
        else {
            same->milliseconds += milliseconds;
            same->hostMilliseconds += host;
        }
    }
    return readings;
}

void PassTimer::recycle(const Frame& frame) {
    for (const Step& step : frame)
        for (const GLuint query : {step.beginQuery, step.endQuery})
            if (query != 0) freeQueries_.push_back(query);
}

void PassTimer::closeFrame() {
    pending_.push_back(std::move(current_));
    current_.clear();
}

std::optional<std::vector<PassTimer::Reading>> PassTimer::endFrame() {
    closeFrame();
    return arrived();
}

std::optional<std::vector<PassTimer::Reading>> PassTimer::arrived() {
    std::optional<std::vector<Reading>> newest;
    while (!pending_.empty()) {
        const Frame& oldest = pending_.front();
        if (clock_ == Clock::Timestamps && !oldest.empty()) {
            GLint available = GL_FALSE;
            glGetQueryObjectiv(oldest.back().endQuery, GL_QUERY_RESULT_AVAILABLE, &available);
            if (available == GL_FALSE) break;
        }
        newest = read(oldest);
        recycle(oldest);
        pending_.erase(pending_.begin());
    }
    return newest;
}

void PassTimer::dropFrame() {
    recycle(current_);
    current_.clear();
}

void PassTimer::dropAll() {
    dropFrame();
    for (const Frame& frame : pending_) recycle(frame);
    pending_.clear();
}

std::vector<PassTimer::Reading> PassTimer::finishFrame() {
    closeFrame();
    if (clock_ == Clock::Timestamps && !pending_.back().empty()) countWait();
    const std::vector<Reading> readings = read(pending_.back());
    for (const Frame& frame : pending_) recycle(frame);
    pending_.clear();
    return readings;
}

double totalOf(const std::vector<PassTimer::Reading>& readings) {
    double sum = 0.0;
    for (const PassTimer::Reading& reading : readings)
        if (!reading.isPart()) sum += reading.milliseconds;
    return sum;
}

}  // namespace timeshade::gl
