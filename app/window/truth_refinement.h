#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gl/texture.h"
#include "measure/reference.h"
#include "window/frame_driver.h"

namespace timeshade {

/// The ground truth of a moment at the picture's full size: more samples with every step while nothing changes, kept on
/// disk once it is whole. With a renderer of its own, which is there only as long as it works.
class TruthRefinement {
  public:
    /// Does a step towards the truth of what is wanted, or begins it anew. True if what is shown has changed. Where a
    /// pause ends the step, the steps before it stay.
    bool update(const FrameDriver::Wanted& wanted);
    /// Is what has been found that of what is wanted?
    bool follows(const FrameDriver::Wanted& wanted) const;
    void clear();

    /// Keeps what has been found so far, until resume() is called or something changes.
    void stop() { stopped_ = !complete(); }
    void resume() { stopped_ = false; }
    bool stopped() const { return stopped_; }
    bool complete() const { return builder_ && builder_->complete(); }
    /// Nothing more comes by itself.
    bool rests() const { return complete() || stopped_; }

    /// Per pixel, of what is shown; 0 as long as there is none.
    int samples() const { return samples_; }
    /// Null as long as there is none.
    const gl::Texture* picture() const { return samples_ > 0 ? &*texture_ : nullptr; }
    /// The same for a file, and in linear light.
    const DisplayImage& image() const { return image_; }
    LinearImage radiance() const { return builder_->soFar(); }
    /// Bytes in main memory and on the device.
    std::size_t bytes() const;

  private:
    void begin(const FrameDriver::Wanted& wanted, std::vector<double> key);
    void show(const FrameDriver::Wanted& wanted);

    ReferenceCache cache_;
    std::optional<FrameRenderer> renderer_;
    std::unique_ptr<ReferenceBuilder> builder_;
    std::vector<double> key_;
    DisplayLook look_;  ///< of what is shown
    int samples_ = 0;
    bool stopped_ = false;
    DisplayImage image_;
    std::optional<gl::Texture> texture_;
};

}  // namespace timeshade
