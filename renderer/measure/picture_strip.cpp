#include "measure/picture_strip.h"

#include <cmath>

namespace timeshade {

namespace {
constexpr int stripHeight = 34;
constexpr double letterSize = 12.0;
}  // namespace

DisplayImage withStrip(const DisplayImage& picture, const std::function<void(ChartCanvas&, const ChartFont&)>& draw) {
    ChartCanvas canvas(picture.width, stripHeight, Rgb{20, 20, 24});
    const ChartFonts fonts;
    draw(canvas, fonts.regular);
    const DisplayImage strip = canvas.picture();
    DisplayImage whole{picture.width, picture.height + stripHeight, picture.rgb};
    whole.rgb.insert(whole.rgb.end(), strip.rgb.begin(), strip.rgb.end());
    return whole;
}

void writeOnStrip(ChartCanvas& canvas, const ChartFont& font, const std::string& text, double x, double y) {
    canvas.drawMask(font.render(text, letterSize, x, y), Rgb{225, 225, 230});
}

double widthOnStrip(const ChartFont& font, const std::string& text) { return font.width(text, letterSize); }

Rgb eightBits(const glm::vec3& color) {
    const auto bits = [](float value) { return static_cast<std::uint8_t>(std::lround(255.0f * value)); };
    return {bits(color.x), bits(color.y), bits(color.z)};
}

}  // namespace timeshade
