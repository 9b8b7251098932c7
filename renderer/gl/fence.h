#pragma once

#include <utility>

#include <glad/gl.h>

namespace timeshade::gl {

/// Put behind all that the device has been told so far.
class Fence {
  public:
    Fence() : sync_(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)) {}
    Fence(Fence&& other) noexcept : sync_(std::exchange(other.sync_, nullptr)) {}
    Fence& operator=(Fence&& other) noexcept {
        std::swap(sync_, other.sync_);
        return *this;
    }
    ~Fence() { glDeleteSync(sync_); }

    /// Has the device done all of it? Does not wait.
    bool passed() const { return wait(0); }
    /// Waits for at most so long. True where the device has done all of it.
    bool wait(GLuint64 nanoseconds) const {
        return glClientWaitSync(sync_, GL_SYNC_FLUSH_COMMANDS_BIT, nanoseconds) != GL_TIMEOUT_EXPIRED;
    }

  private:
    GLsync sync_;
};

}  // namespace timeshade::gl
