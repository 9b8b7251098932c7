#pragma once

#include <string>

#include "image/image_file.h"

namespace timeshade {

/// Where the frames of a recording go, in order, all of one size.
class FrameSink {
  public:
    FrameSink() = default;
    virtual ~FrameSink() = default;
    FrameSink(const FrameSink&) = delete;
    FrameSink& operator=(const FrameSink&) = delete;

    /// Throws Error where it can't be kept.
    virtual void add(const DisplayImage& frame) = 0;
    /// To be called after the last frame, be it as many as were planned or not. Throws Error. A sink that goes without
    /// it leaves nothing broken behind.
    virtual void finish() = 0;
    /// What is there after finish(): "F.mp4"
    virtual std::string kept() const = 0;
};

}  // namespace timeshade
