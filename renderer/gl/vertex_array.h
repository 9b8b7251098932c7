#pragma once

#include <string>

#include "gl/object.h"

namespace timeshade::gl {

struct DeleteVertexArray {
    void operator()(GLuint name) const { glDeleteVertexArrays(1, &name); }
};

/// A vertex array; its bindings are set with the direct-state-access calls on name().
class VertexArray : public Object<DeleteVertexArray> {
  public:
    explicit VertexArray(const std::string& labelText) : Object(create()) { label(GL_VERTEX_ARRAY, name(), labelText); }

    /// Attribute `index` reads `components` floats from binding `binding` at `offset` bytes into each element.
    void floats(GLuint index, GLuint binding, GLint components, GLuint offset) const {
        glEnableVertexArrayAttrib(name(), index);
        glVertexArrayAttribFormat(name(), index, components, GL_FLOAT, GL_FALSE, offset);
        glVertexArrayAttribBinding(name(), index, binding);
    }

  private:
    static GLuint create() {
        GLuint vertexArray = 0;
        glCreateVertexArrays(1, &vertexArray);
        return vertexArray;
    }
};

}  // namespace timeshade::gl
