#pragma once

#include <string>

#include "gl/object.h"
#include "gl/waits.h"

namespace timeshade::gl {

struct DeleteQuery {
    void operator()(GLuint name) const { glDeleteQueries(1, &name); }
};

/// Counts the fragments that pass the depth test between begin() and end().
class FragmentCount : public Object<DeleteQuery> {
  public:
    explicit FragmentCount(const std::string& labelText) : Object(create()) { label(GL_QUERY, name(), labelText); }

    void begin() const { glBeginQuery(GL_SAMPLES_PASSED, name()); }
    void end() const { glEndQuery(GL_SAMPLES_PASSED); }
    /// Of the last begin and end. Waits for the device.
    GLuint64 read() const {
        GLuint64 count = 0;
        countWait();
        glGetQueryObjectui64v(name(), GL_QUERY_RESULT, &count);
        return count;
    }

  private:
    static GLuint create() {
        GLuint query = 0;
        glCreateQueries(GL_SAMPLES_PASSED, 1, &query);
        return query;
    }
};

}  // namespace timeshade::gl
