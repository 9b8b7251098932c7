#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/font_file.h"

namespace timeshade {

/// How much of each pixel a shape covers, 0 to 255.
struct CoverageMask {
    int left = 0;  ///< of the first column, in pixels of the picture
    int top = 0;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> coverage;
};

/// A TrueType font. Sizes are pixels per em. Text is UTF-8; invalid bytes are drawn as U+FFFD.
class ChartFont {
  public:
    /// Throws Error that names the file.
    explicit ChartFont(const std::filesystem::path& path);
    ~ChartFont();

    double width(std::string_view text, double size) const;
    /// Height of a capital letter, for centring a line of text on a point.
    double capHeight(double size) const;

    /// The text with its baseline starting at x, y.
    CoverageMask render(std::string_view text, double size, double x, double y) const;

    /// Lines no wider than `width`, broken between words. A word that is wider gets a line of its own.
    std::vector<std::string> wrap(std::string_view text, double size, double width) const;
    /// The text, or its beginning and an ellipsis, no wider than `width`.
    std::string shorten(const std::string& text, double size, double width) const;

  private:
    struct Data;
    template <class Visit>
    void forEachGlyph(std::string_view text, double size, const Visit& visit) const;

    std::unique_ptr<Data> data_;
};

/// DejaVu Sans (core/font_file.h).
struct ChartFonts {
    ChartFont regular{fontFile("DejaVuSans.ttf")};
    ChartFont bold{fontFile("DejaVuSans-Bold.ttf")};

    const ChartFont& of(bool isBold) const { return isBold ? bold : regular; }
};

}  // namespace timeshade
