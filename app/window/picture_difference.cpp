#include "window/picture_difference.h"

#include <cstdlib>
#include <utility>

#include "compare/composed_picture.h"
#include "window/display_texture.h"

namespace timeshade {

PictureDifference::PictureDifference(const Key& key, DisplayImage first, DisplayImage second, int gain)
    : key_(key), first_(std::move(first)), second_(std::move(second)), gain_(gain) {
    upload(texture_, composed(first_, second_, CompareMode::Difference, 0.5, gain_));
}

std::optional<PictureDifference::Pixel> PictureDifference::at(int x, int y) const {
    if (x < 0 || y < 0 || x >= first_.width || y >= first_.height) return std::nullopt;
    const std::size_t place =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(first_.width) + static_cast<std::size_t>(x));
    Pixel pixel{};
    for (std::size_t c = 0; c < 3; ++c) {
        pixel.first[c] = first_.rgb[place + c];
        pixel.second[c] = second_.rgb[place + c];
        pixel.apart[c] = std::abs(pixel.first[c] - pixel.second[c]);
    }
    return pixel;
}

std::size_t PictureDifference::bytes() const { return 2 * first_.rgb.size() + first_.rgb.size() / 3 * 4; }

}  // namespace timeshade
