#pragma once

#include <string>
#include <utility>

#include <glad/gl.h>

namespace timeshade::gl {

/// Owner of one OpenGL name: made in a constructor, deleted in the destructor, movable, not copyable. `Delete` is a
/// function object called with the name. A moved-from object owns nothing and may only be assigned or destroyed.
template <typename Delete>
class Object {
  public:
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;
    Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Object() {
        if (name_ != 0) Delete{}(name_);
    }
    GLuint name() const { return name_; }

  protected:
    explicit Object(GLuint name) : name_(name) {}

  private:
    GLuint name_ = 0;
};

/// Names an object for debuggers and for the messages of KHR_debug.
inline void label(GLenum kind, GLuint name, const std::string& text) {
    glObjectLabel(kind, name, static_cast<GLsizei>(text.size()), text.c_str());
}

}  // namespace timeshade::gl
