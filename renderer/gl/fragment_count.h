#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gl/object.h"
#include "gl/waits.h"

namespace timeshade::gl {

struct DeleteQuery {
    void operator()(GLuint name) const { glDeleteQueries(1, &name); }
};

/// Counts the fragments that pass the depth test between every begin() and end() since it was restarted.
class FragmentCount {
  public:
    explicit FragmentCount(std::string labelText) : label_(std::move(labelText)) {}

    void restart() { used_ = 0; }
    void begin() {
        if (used_ == queries_.size()) queries_.emplace_back(label_);
        glBeginQuery(GL_SAMPLES_PASSED, queries_[used_++].name());
    }
    void end() const { glEndQuery(GL_SAMPLES_PASSED); }
    /// Waits for the device.
    GLuint64 read() const {
        GLuint64 sum = 0;
        countWait();
        for (std::size_t i = 0; i < used_; ++i) {
            GLuint64 count = 0;
            glGetQueryObjectui64v(queries_[i].name(), GL_QUERY_RESULT, &count);
            sum += count;
        }
        return sum;
    }

  private:
    struct Query : Object<DeleteQuery> {
        explicit Query(const std::string& text) : Object(create()) { label(GL_QUERY, name(), text); }
        static GLuint create() {
            GLuint query = 0;
            glCreateQueries(GL_SAMPLES_PASSED, 1, &query);
            return query;
        }
    };

    std::string label_;
    std::vector<Query> queries_;
    std::size_t used_ = 0;
};

}  // namespace timeshade::gl
