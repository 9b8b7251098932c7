#include "chart/chart_font.h"

#include "core/error.h"
#include "core/file_bytes.h"

#include <fmt/format.h>
#include <stb_truetype.h>

#include <algorithm>
#include <cmath>

namespace timeshade {
namespace {

constexpr std::uint32_t replacement = 0xfffd;

/// Takes one code point off the front of UTF-8 text.
std::uint32_t takeCodePoint(std::string_view& text) {
    const auto first = static_cast<std::uint8_t>(text.front());
    text.remove_prefix(1);
    if (first < 0x80) {
        return first < 0x20 ? ' ' : first;
    }
    const std::size_t following = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
    if (first < 0xc2 || first > 0xf4 || text.size() < following) {
        return replacement;
    }
    std::uint32_t code = first & (0x3fu >> following);
    for (std::size_t i = 0; i < following; ++i) {
        const auto next = static_cast<std::uint8_t>(text[i]);
        if ((next & 0xc0) != 0x80) {
            return replacement;
        }
        code = code << 6 | (next & 0x3fu);
    }
    text.remove_prefix(following);
    return code;
}

/// Adds a glyph to the mask; where two overlap, coverages are added and clamped.
void addGlyph(CoverageMask& mask, const CoverageMask& glyph) {
    for (int row = 0; row < glyph.height; ++row) {
        for (int column = 0; column < glyph.width; ++column) {
            const int x = glyph.left + column - mask.left;
            const int y = glyph.top + row - mask.top;
            if (x < 0 || y < 0 || x >= mask.width || y >= mask.height) {
                continue;
            }
            std::uint8_t& target = mask.coverage[static_cast<std::size_t>(y * mask.width + x)];
            const int sum = target + glyph.coverage[static_cast<std::size_t>(row * glyph.width + column)];
            target = static_cast<std::uint8_t>(std::min(sum, 255));
        }
    }
}

}  // namespace

struct ChartFont::Data {
    std::vector<unsigned char> bytes;
    stbtt_fontinfo info{};

    float scale(double size) const { return stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(size)); }
};

ChartFont::ChartFont(const std::filesystem::path& path) : data_(std::make_unique<Data>()) {
    try {
        data_->bytes = readFileBytes(path);
    } catch (const Error& error) {
        throw Error(fmt::format("{}; expected the font of the package fonts-dejavu-core", error.what()));
    }
    const int offset = data_->bytes.size() < 12 ? -1 : stbtt_GetFontOffsetForIndex(data_->bytes.data(), 0);
    if (offset < 0 || stbtt_InitFont(&data_->info, data_->bytes.data(), offset) == 0) {
        throw Error(fmt::format("cannot read {}: not a font, expected TrueType", path.string()));
    }
}

ChartFont::~ChartFont() = default;

/// visit(glyph, x of its origin, x of its end), both from the start of the text.
template <class Visit>
void ChartFont::forEachGlyph(std::string_view text, double size, const Visit& visit) const {
    const double scale = static_cast<double>(data_->scale(size));
    double x = 0.0;
    int previous = 0;
    while (!text.empty()) {
        const int glyph = stbtt_FindGlyphIndex(&data_->info, static_cast<int>(takeCodePoint(text)));
        if (previous != 0) {
            x += scale * stbtt_GetGlyphKernAdvance(&data_->info, previous, glyph);
        }
        int advance = 0;
        int bearing = 0;
        stbtt_GetGlyphHMetrics(&data_->info, glyph, &advance, &bearing);
        visit(glyph, x, x + scale * advance);
        x += scale * advance;
        previous = glyph;
    }
}

double ChartFont::width(std::string_view text, double size) const {
    double end = 0.0;
    forEachGlyph(text, size, [&](int, double, double glyphEnd) { end = glyphEnd; });
    return end;
}

double ChartFont::capHeight(double size) const {
    int left = 0;
    int bottom = 0;
    int right = 0;
    int top = 0;
    stbtt_GetCodepointBox(&data_->info, 'H', &left, &bottom, &right, &top);
    return static_cast<double>(data_->scale(size)) * top;
}

CoverageMask ChartFont::render(std::string_view text, double size, double x, double y) const {
    const float scale = data_->scale(size);
    CoverageMask mask;
    mask.left = static_cast<int>(std::floor(x - size));
    mask.top = static_cast<int>(std::floor(y - 1.5 * size));
    mask.width = static_cast<int>(std::ceil(width(text, size) + 2.0 * size)) + 1;
    mask.height = static_cast<int>(std::ceil(2.0 * size)) + 1;
    mask.coverage.resize(static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height));
    // Sub-pixel positions horizontally, whole pixels vertically: baselines stay sharp.
    const int baseline = static_cast<int>(std::lround(y));
    forEachGlyph(text, size, [&](int glyph, double offset, double) {
        const double origin = x + offset;
        const double whole = std::floor(origin);
        const auto shift = static_cast<float>(origin - whole);
        CoverageMask one;
        int right = 0;
        int bottom = 0;
        stbtt_GetGlyphBitmapBoxSubpixel(&data_->info, glyph, scale, scale, shift, 0.0f, &one.left, &one.top, &right,
                                        &bottom);
        one.width = right - one.left;
        one.height = bottom - one.top;
        if (one.width <= 0 || one.height <= 0) {
            return;
        }
        one.coverage.resize(static_cast<std::size_t>(one.width) * static_cast<std::size_t>(one.height));
        stbtt_MakeGlyphBitmapSubpixel(&data_->info, one.coverage.data(), one.width, one.height, one.width, scale, scale,
                                      shift, 0.0f, glyph);
        one.left += static_cast<int>(whole);
        one.top += baseline;
        addGlyph(mask, one);
    });
    return mask;
}

std::vector<std::string> ChartFont::wrap(std::string_view text, double size, double width) const {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (word.empty()) {
            continue;
        }
        const std::string longer = lines.empty() ? std::string(word) : fmt::format("{} {}", lines.back(), word);
        if (!lines.empty() && this->width(longer, size) <= width) {
            lines.back() = longer;
        } else {
            lines.emplace_back(word);
        }
    }
    return lines;
}

std::string ChartFont::shorten(const std::string& text, double size, double width) const {
    if (this->width(text, size) <= width) {
        return text;
    }
    // Where code points begin; text is cut only there.
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if ((static_cast<std::uint8_t>(text[i]) & 0xc0) != 0x80) {
            starts.push_back(i);
        }
    }
    const auto cut = [&](std::size_t start) { return text.substr(0, start) + "…"; };
    // The first cut that is too wide; the result is the one before it.
    const auto tooWide = std::partition_point(
        starts.begin(), starts.end(), [&](std::size_t start) { return this->width(cut(start), size) <= width; });
    return cut(tooWide == starts.begin() ? 0 : *(tooWide - 1));
}

}  // namespace timeshade
