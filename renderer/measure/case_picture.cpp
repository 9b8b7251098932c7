#include "measure/case_picture.h"

#include <algorithm>

#include <fmt/format.h>

#include "chart/chart_canvas.h"

namespace timeshade {

namespace {

constexpr double textSize = 14.0, rowHeight = 24.0, nameWidth = 236.0, exactWidth = 76.0, cellWidth = 132.0,
                 margin = 16.0;
constexpr Rgb ink{32, 36, 42}, quiet{120, 126, 134}, ground{255, 255, 255}, rule{222, 226, 230};

Rgb colorOf(Verdict verdict) {
    switch (verdict) {
    case Verdict::Right: return {214, 236, 220};
    case Verdict::Predicted: return {252, 236, 196};
    case Verdict::Wrong: return {244, 170, 164};
    case Verdict::NotTaken: return {240, 242, 244};
    }
    return ground;
}

class MatrixPicture {
  public:
    explicit MatrixPicture(const std::vector<CaseResult>& results) : results_(results) {
        for (const CaseResult& r : results) {
            addOnce(cases_, r.caseName);
            if (r.technique != "-") addOnce(techniques_, r.technique);
        }
    }

    DisplayImage draw() const {
        const double width = 2.0 * margin + nameWidth + exactWidth +
                             cellWidth * static_cast<double>(std::max<std::size_t>(techniques_.size(), 3));
        const double height = 2.0 * margin + rowHeight * static_cast<double>(cases_.size() + 3);
        ChartCanvas canvas(static_cast<int>(width), static_cast<int>(height), ground);
        const double top = margin;
        text(canvas, margin, top, "analytic case", true, ink);
        text(canvas, margin + nameWidth, top, "exact", true, ink);
        for (std::size_t t = 0; t < techniques_.size(); ++t) text(canvas, cellLeft(t), top, techniques_[t], true, ink);
        for (std::size_t c = 0; c < cases_.size(); ++c)
            drawRow(canvas, c, top + rowHeight * static_cast<double>(c + 1));
        drawLegend(canvas, top + rowHeight * (static_cast<double>(cases_.size()) + 1.6));
        return canvas.picture();
    }

  private:
    static void addOnce(std::vector<std::string>& names, const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    static double cellLeft(std::size_t column) {
        return margin + nameWidth + exactWidth + cellWidth * static_cast<double>(column);
    }

    void text(ChartCanvas& canvas, double x, double top, const std::string& words, bool bold, Rgb color) const {
        canvas.drawMask(fonts_.of(bold).render(words, textSize, x + 6.0,
                                               top + 0.5 * (rowHeight + fonts_.of(bold).capHeight(textSize))),
                        color);
    }

    void drawRow(ChartCanvas& canvas, std::size_t c, double top) const {
        text(canvas, margin, top, cases_[c], false, ink);
        bool first = true;
        for (const CaseResult& r : results_) {
            if (r.caseName != cases_[c]) continue;
            if (first) text(canvas, margin + nameWidth, top, fmt::format("{:.4g}", r.exact), false, ink);
            first = false;
            if (r.technique == "-") {
                drawCell(canvas, 0, top, r, fmt::format("{:.4f} code", r.value));
                continue;
            }
            const auto column = static_cast<std::size_t>(
                std::find(techniques_.begin(), techniques_.end(), r.technique) - techniques_.begin());
            std::string words = r.verdict == Verdict::NotTaken ? "" : fmt::format("{:.4f}", r.value);
            if (r.verdict == Verdict::Predicted) words += fmt::format(" ({:.3f})", r.predicted);
            drawCell(canvas, column, top, r, words);
        }
        const PixelPoint line[2] = {{margin, top}, {cellLeft(techniques_.size()), top}};
        canvas.drawLine(line, {1.0, rule, 1.0, 0.0});
    }

    void drawCell(ChartCanvas& canvas, std::size_t column, double top, const CaseResult& r,
                  const std::string& words) const {
        const double left = cellLeft(column);
        canvas.fillBox({left + 1.0, top + 1.0, left + cellWidth - 1.0, top + rowHeight - 1.0}, colorOf(r.verdict));
        text(canvas, left, top, words, r.verdict == Verdict::Wrong, ink);
    }

    void drawLegend(ChartCanvas& canvas, double top) const {
        const std::pair<Verdict, const char*> entries[] = {{Verdict::Right, "right"},
                                                           {Verdict::Predicted, "off as predicted (by how it works)"},
                                                           {Verdict::Wrong, "wrong"}};
        double x = margin;
        for (const auto& [verdict, words] : entries) {
            canvas.fillBox({x, top + 4.0, x + 16.0, top + rowHeight - 4.0}, colorOf(verdict));
            text(canvas, x + 16.0, top, words, false, quiet);
            x += 52.0 + fonts_.regular.width(words, textSize);
        }
    }

    const std::vector<CaseResult>& results_;
    std::vector<std::string> cases_, techniques_;
    ChartFonts fonts_;
};

}  // namespace

DisplayImage drawCaseMatrix(const std::vector<CaseResult>& results) { return MatrixPicture(results).draw(); }

}  // namespace timeshade
