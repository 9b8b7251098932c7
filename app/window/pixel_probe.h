#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "gl/texture.h"

namespace timeshade {

struct Session;

/// One pixel under a magnifier: its surroundings, and what each technique and the ray-traced truth say of its camera
/// samples, along the shutter.
class PixelProbe {
  public:
    static constexpr int side = 17;  ///< pixels of the magnified square

    /// What one of them says: lit of each camera sample, from the first stratum of the shutter to the last; negative
    /// where the oracle tests nothing (nothing is seen, or a surface that faces away from the light or lies outside its
    /// cone).
    struct Row {
        std::string name;
        std::vector<float> lit;
        double mean() const;  ///< of those that are asked
    };

    bool on() const { return on_; }
    /// x from the left, y from the top.
    void pick(int x, int y);
    void clear();
    int x() const { return x_; }
    int y() const { return y_; }

    /// Does a step once the picture is still: the picture's own answers, then one other technique after the other, then
    /// the truth. True if the window has to be drawn again.
    bool update(Session& session);

    /// The square around the pixel, first row uppermost; null until it has been read.
    const gl::Texture* square() const { return square_ ? &*square_ : nullptr; }
    const std::vector<Row>& rows() const { return rows_; }
    bool complete() const { return complete_; }
    /// What is being asked; or why something can't be.
    const std::string& caption() const { return caption_; }

  private:
    void begin(Session& session);
    void askNext(Session& session);
    void traceTruth(const Session& session);
    std::vector<float> litOf(const FrameRenderer& renderer) const;

    bool on_ = false, complete_ = false;
    int x_ = 0, y_ = 0;
    int of_ = -1;                            ///< number of the picture that is magnified
    std::size_t next_ = 0;                   ///< technique of the registry
    std::optional<FrameRenderer> renderer_;  ///< made when first needed
    std::optional<gl::Texture> square_;
    std::vector<Row> rows_;
    std::string caption_;
};

}  // namespace timeshade
