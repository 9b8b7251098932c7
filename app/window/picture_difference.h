#pragma once

#include <array>
#include <optional>

#include "gl/texture.h"
#include "image/image_file.h"

namespace timeshade {

/// How far two pictures of one size are apart, and both pixel by pixel: levels from 0 to 255 of red, green and blue.
class PictureDifference {
  public:
    /// What the two were: while that stays, so does their difference.
    using Key = std::array<int, 4>;

    PictureDifference(const Key& key, DisplayImage first, DisplayImage second, int gain);

    const Key& key() const { return key_; }
    /// As many times as bright as the gain says; its first row is the uppermost.
    const gl::Texture& picture() const { return *texture_; }
    int gain() const { return gain_; }

    struct Pixel {
        std::array<int, 3> first, second, apart;
    };
    /// Column and row from the upper left; nothing beside the picture.
    std::optional<Pixel> at(int x, int y) const;
    std::size_t bytes() const;

  private:
    Key key_;
    DisplayImage first_, second_;
    int gain_;
    std::optional<gl::Texture> texture_;
};

}  // namespace timeshade
