#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "image/image_file.h"
#include "plan/display_look.h"

namespace timeshade {

/// A picture from a PNG or EXR file, to be compared with.
class FilePicture {
  public:
    /// Throws Error that names the file: it can't be read, or has more than `mostPixels`.
    explicit FilePicture(std::string path);

    const std::string& path() const { return path_; }
    /// What it is called on a picture: the file's name.
    std::string label() const;
    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t bytes() const { return display_.rgb.size() + linear_.rgb.size() * sizeof(float); }
    /// A PNG as it is; an EXR, which holds linear light, as a picture of that look.
    DisplayImage shown(const DisplayLook& look) const;
    /// Throws Error for a PNG: what light it was made of is not known.
    const LinearImage& radiance() const;
    /// Throws Error where it is of another size: "saved.png: is 640 x 480, expected 900 x 600".
    void requireSize(int width, int height) const;
    bool hasSize(int width, int height) const { return width == width_ && height == height_; }

    static constexpr long mostPixels = 64l << 20;

  private:
    std::string path_;
    int width_ = 0, height_ = 0;
    DisplayImage display_;
    LinearImage linear_;  ///< empty for a PNG
};

}  // namespace timeshade
