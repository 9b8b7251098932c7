#pragma once

namespace timeshade {

/// While one exists, OpenGL draws and computes nothing, and new buffers hold zeros: frames are planned, allocated and
/// their programs compiled and linked as ever, but no driver makes device code of them. For tests of which programs
/// there are: on a device without a GPU that code takes minutes. One at a time.
class NoDrawing {
  public:
    NoDrawing();
    ~NoDrawing();
    NoDrawing(const NoDrawing&) = delete;
    NoDrawing& operator=(const NoDrawing&) = delete;
};

}  // namespace timeshade
