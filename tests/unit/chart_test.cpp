// The chart shows the numbers that it was given: every marker's pixel, read back through its axes, is its point.

#include "chart/chart.h"
#include "chart/chart_layout.h"
#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace timeshade {
namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

const ChartFonts& fonts() {
    static const ChartFonts loaded;
    return loaded;
}

ChartLayout layoutOf(const Chart& chart, int width = 1200, int height = 800, double scale = 1.0) {
    return layoutChart(chart, fonts(), width, height, scale);
}

Rgb pixelAt(const DisplayImage& image, PixelPoint point) {
    const auto x = static_cast<std::size_t>(point.x);
    const auto y = static_cast<std::size_t>(point.y);
    const std::uint8_t* pixel = &image.rgb[(y * static_cast<std::size_t>(image.width) + x) * 3];
    return {pixel[0], pixel[1], pixel[2]};
}

constexpr const char* table = R"(technique,spp,milliseconds,rmse
tsm,1,12.25,0.0912
tsm,4,19.5,0.0731
tsm,16,51.125,0.0702
prisms,1,31.75,0.0613
prisms,4,55.0,0.0298
prisms,16,160.5,0.0149
exact,1,48.0,0.0405
exact,4,81.0,0.0199
exact,16,217.0,0.00981
)";

Chart chartOf(const std::string& csv) {
    Chart chart{"Error against time", "pillars, 8 spp", "milliseconds", "RMSE", {}, {}, true, "a footnote"};
    chart.slopes = {{-0.5, "slope −½"}, {-1.0, "slope −1"}};
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        std::string name, spp, x, y;
        std::getline(std::getline(std::getline(std::getline(cells, name, ','), spp, ','), x, ','), y);
        if (chart.series.empty() || chart.series.back().name != name) {
            chart.series.push_back({name, {}});
        }
        chart.series.back().points.push_back({std::stod(x), std::stod(y), spp});
    }
    return chart;
}

Chart chartOfPoints(const std::vector<ChartPoint>& points) {
    Chart chart;
    chart.series = {{"only", points}};
    return chart;
}

/// Names, labels and markers: what must not lie over one another.
std::vector<PixelBox> boxesOf(const ChartLayout& layout) {
    std::vector<PixelBox> boxes;
    for (const PlacedSeries& series : layout.series) {
        if (series.name) {
            boxes.push_back(series.name->box);
        }
        for (const PlacedText& label : series.labels) {
            boxes.push_back(label.box);
        }
    }
    return boxes;
}

void expectApart(const ChartLayout& layout) {
    const std::vector<PixelBox> boxes = boxesOf(layout);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_TRUE(layout.plot.contains(boxes[i])) << i;
        for (std::size_t k = i + 1; k < boxes.size(); ++k) {
            EXPECT_FALSE(boxes[i].overlaps(boxes[k])) << i << " and " << k;
        }
        for (const PlacedSeries& series : layout.series) {
            for (const PlacedPoint& point : series.points) {
                const PixelBox marker{point.pixel.x, point.pixel.y, point.pixel.x, point.pixel.y};
                EXPECT_FALSE(boxes[i].overlaps(marker.grown(layout.markerRadius())));
            }
        }
    }
}

TEST(ChartLayout, PointsAreTheNumbersOfTheTable) {
    const Chart chart = chartOf(table);
    ASSERT_EQ(chart.series.size(), 3u);
    for (const double scale : {1.0, 2.0}) {
        const int width = static_cast<int>(1200 * scale);
        const int height = static_cast<int>(800 * scale);
        const ChartLayout layout = layoutOf(chart, width, height, scale);
        for (std::size_t i = 0; i < chart.series.size(); ++i) {
            ASSERT_EQ(layout.series[i].points.size(), 3u);
            for (const PlacedPoint& placed : layout.series[i].points) {
                const ChartPoint& point = chart.series[i].points[placed.index];
                EXPECT_NEAR(layout.x.valueOf(placed.pixel.x) / point.x, 1.0, 1e-12);
                EXPECT_NEAR(layout.y.valueOf(placed.pixel.y) / point.y, 1.0, 1e-12);
                EXPECT_TRUE(layout.plot.contains({placed.pixel.x, placed.pixel.y, placed.pixel.x, placed.pixel.y}));
            }
        }
    }
}

TEST(ChartLayout, MoreIsRightAndUpAndDecadesAreEquallyLong) {
    const ChartLayout layout = layoutOf(chartOfPoints({{1.0, 1.0, ""}, {10.0, 10.0, ""}, {100.0, 100.0, ""}}));
    const auto& points = layout.series[0].points;
    EXPECT_LT(points[0].pixel.x, points[1].pixel.x);
    EXPECT_GT(points[0].pixel.y, points[1].pixel.y);
    EXPECT_NEAR(points[1].pixel.x - points[0].pixel.x, points[2].pixel.x - points[1].pixel.x, 1e-9);
    EXPECT_NEAR(points[1].pixel.x - points[0].pixel.x, layout.x.pixelsPerDecade(), 1e-9);
    EXPECT_NEAR(points[0].pixel.y - points[1].pixel.y, layout.y.pixelsPerDecade(), 1e-9);
}

TEST(Chart, MarkersAndLinesAreWhereTheLayoutSays) {
    Chart chart = chartOf(table);
    chart.series.push_back({"fourth kind of marker", {{25.0, 0.004, "1"}, {60.0, 0.003, "2"}}});
    chart.series.push_back({"fifth", {{25.0, 0.002, "1"}, {60.0, 0.0015, "2"}}});
    for (const double scale : {1.0, 1.5}) {
        const int width = static_cast<int>(1200 * scale);
        const int height = static_cast<int>(800 * scale);
        const ChartLayout layout = layoutOf(chart, width, height, scale);
        const DisplayImage image = drawChart(chart, width, height, scale);
        ASSERT_EQ(image.width, width);
        ASSERT_EQ(image.height, height);
        for (const PlacedSeries& series : layout.series) {
            for (const PlacedPoint& point : series.points) {
                EXPECT_EQ(pixelAt(image, point.pixel), series.color);
            }
        }
        // The last curve runs free of all others.
        const auto& ends = layout.series.back().points;
        const PixelPoint middle{(ends[0].pixel.x + ends[1].pixel.x) / 2.0, (ends[0].pixel.y + ends[1].pixel.y) / 2.0};
        EXPECT_EQ(pixelAt(image, middle), layout.series.back().color);
    }
}

TEST(Chart, SameChartSamePixels) {
    const Chart chart = chartOf(table);
    EXPECT_EQ(drawChart(chart, 900, 600).rgb, drawChart(chart, 900, 600).rgb);
}

TEST(ChartLayout, NothingCoversAnythingElse) {
    const Chart chart = chartOf(table);
    const ChartLayout layout = layoutOf(chart);
    expectApart(layout);
    for (const PlacedSeries& series : layout.series) {
        ASSERT_TRUE(series.name.has_value());
        EXPECT_EQ(series.labels.size(), 3u) << "there is room for all";
        EXPECT_TRUE(series.leader.empty()) << "there is room beside the last point";
    }
}

TEST(ChartLayout, CurvesThatEndTogetherKeepTheirNames) {
    Chart chart;
    for (int i = 0; i < 12; ++i) {
        ChartSeries series{"technique " + std::to_string(i), {}};
        for (const int spp : {1, 2, 4, 8, 16}) {
            series.points.push_back({10.0 * spp + i, 0.1 / spp, std::to_string(spp)});
        }
        chart.series.push_back(series);
    }
    const ChartLayout layout = layoutOf(chart);
    expectApart(layout);
    std::set<std::string> names;
    for (const PlacedSeries& series : layout.series) {
        ASSERT_TRUE(series.name.has_value());
        names.insert(series.name->text);
    }
    EXPECT_EQ(names.size(), 12u);
}

TEST(ChartLayout, EveryCurveLooksDifferent) {
    Chart chart;
    chart.series.resize(40);
    std::set<std::tuple<int, int, int, ChartMarker>> looks;
    for (const PlacedSeries& series : layoutOf(chart).series) {
        looks.insert({series.color.red, series.color.green, series.color.blue, series.marker});
    }
    EXPECT_EQ(looks.size(), 40u);
}

TEST(ChartLayout, SlopesHaveTheirSlopes) {
    Chart chart = chartOf(table);
    chart.slopes.push_back({2.0, "rising"});
    const ChartLayout layout = layoutOf(chart);
    ASSERT_EQ(layout.slopes.size(), 3u);
    for (const PlacedSlope& placed : layout.slopes) {
        const double rise = std::log10(layout.y.valueOf(placed.to.y) / layout.y.valueOf(placed.from.y));
        const double run = std::log10(layout.x.valueOf(placed.to.x) / layout.x.valueOf(placed.from.x));
        const double expected = placed.label.text == "rising" ? 2.0 : placed.label.text == "slope −1" ? -1.0 : -0.5;
        EXPECT_NEAR(rise / run, expected, 1e-9);
        EXPECT_TRUE(layout.plot.contains(placed.label.box));
        for (const PlacedSlope& other : layout.slopes) {
            EXPECT_TRUE(&other == &placed || !other.label.box.overlaps(placed.label.box));
        }
    }
}

TEST(ChartLayout, ParetoFront) {
    Chart chart;
    chart.series = {{"a", {{1.0, 9.0, ""}, {2.0, 9.0, ""}, {3.0, 4.0, ""}, {8.0, 1.0, ""}}},
                    {"b", {{3.0, 5.0, ""}, {3.0, 4.0, ""}, {9.0, 1.0, ""}, {5.0, 0.0, ""}, {0.5, notANumber, ""}}}};
    const std::vector<ChartPoint> front = paretoFrontOf(chart);
    ASSERT_EQ(front.size(), 3u);
    EXPECT_EQ(front[0].x, 1.0);
    EXPECT_EQ(front[1].x, 3.0);
    EXPECT_EQ(front[1].y, 4.0);
    EXPECT_EQ(front[2].x, 8.0);
    EXPECT_TRUE(layoutOf(chart).paretoFront.empty());
    chart.drawParetoFront = true;
    EXPECT_EQ(layoutOf(chart).paretoFront.size(), 3u);
    EXPECT_NE(drawChart(chart, 640, 480).rgb, drawChart(Chart{}, 640, 480).rgb);
}

TEST(ChartLayout, WhatHasNoLogarithmIsCountedInTheFootnote) {
    Chart chart;
    chart.footnote = "llvmpipe";
    chart.series = {{"exact", {{5.0, 0.0, "1"}, {6.0, 0.25, "2"}, {7.0, -0.0, "4"}, {0.0, 0.5, "8"}}},
                    {"tsm", {{-5.0, 0.1, ""}, {5.0, notANumber, ""}, {infinity, 0.1, ""}, {5.0, 0.1, ""}}}};
    const ChartLayout layout = layoutOf(chart);
    EXPECT_EQ(layout.footnote,
              "llvmpipe · 3 values at 0 not shown (exact) · 3 values negative or not finite not shown (tsm)");
    ASSERT_EQ(layout.series[0].points.size(), 1u);
    EXPECT_EQ(layout.series[0].points[0].index, 1u);
    ASSERT_EQ(layout.series[1].points.size(), 1u);
    EXPECT_EQ(layout.series[1].points[0].index, 3u);

    chart.series = {{"exact", {{5.0, 0.0, "1"}}}};
    chart.footnote = "";
    EXPECT_EQ(layoutOf(chart).footnote, "1 value at 0 not shown (exact)");
    EXPECT_FALSE(layoutOf(chart).series[0].name.has_value());
    EXPECT_EQ(layoutOf(chartOf(table)).footnote, "a footnote");
}

/// Draws without harm, and labels both axes.
ChartLayout expectDrawn(const Chart& chart, int width = 800, int height = 500) {
    const DisplayImage image = drawChart(chart, width, height);
    EXPECT_EQ(image.rgb.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    ChartLayout layout = layoutOf(chart, width, height);
    for (const ChartAxis& axis : {layout.x, layout.y}) {
        const auto labelled = std::count_if(axis.ticks.begin(), axis.ticks.end(),
                                            [](const ChartTick& tick) { return !tick.label.empty(); });
        EXPECT_GE(labelled, 2);
        for (const ChartTick& tick : axis.ticks) {
            EXPECT_TRUE(std::isfinite(axis.pixelOf(tick.value)));
        }
    }
    for (const PlacedSeries& series : layout.series) {
        for (const PlacedPoint& point : series.points) {
            EXPECT_TRUE(layout.plot.contains({point.pixel.x, point.pixel.y, point.pixel.x, point.pixel.y}));
        }
    }
    return layout;
}

TEST(Chart, DataAtTheEdgeOfSense) {
    expectDrawn(Chart{});
    Chart empty = chartOf(table);
    for (ChartSeries& series : empty.series) {
        series.points.clear();
    }
    expectDrawn(empty);
    expectDrawn(chartOfPoints({{5.3, 0.011, "8 spp"}}));
    expectDrawn(chartOfPoints({{5.0, 0.01, "1"}, {5.0, 0.01, "2"}, {5.0, 0.01, "4"}}));
    expectDrawn(chartOfPoints({{5.0, 0.01, "1"}, {5.0001, 0.0100001, "2"}}));
    expectDrawn(chartOfPoints({{9.9, 9.9, "1"}, {1.1, 1.1, "2"}}));
    expectDrawn(chartOfPoints({{1e-300, 1e300, ""}, {1e300, 1e-300, ""}}));
    expectDrawn(chartOfPoints({{std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max(), "a"},
                               {std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min(), "b"}}));
}

TEST(Chart, TextOfAnyKind) {
    Chart chart = chartOf(table);
    const std::string endless(3000, 'w');
    std::string words;
    for (int i = 0; i < 500; ++i) {
        words += "many words ";
    }
    const std::string broken = "\xff\xc3\xe2\x88 broken \xf0\x9f";
    for (const std::string& text :
         {endless, words, broken, std::string("a\nb\tc"), std::string("½ ∝ √t — Ω 猫 🦊")}) {
        chart.title = chart.subtitle = chart.xLabel = chart.yLabel = chart.footnote = text;
        chart.series[0].name = chart.series[1].points[0].label = chart.slopes[0].label = text;
        drawChart(chart, 640, 480);
        const ChartLayout layout = layoutOf(chart, 320, 240);
        EXPECT_GT(layout.plot.width(), 100.0);
        EXPECT_GT(layout.plot.height(), 40.0);
        drawChart(chart, 320, 240);
    }
}

TEST(Chart, SizesThatHoldNoChart) {
    const Chart chart = chartOf(table);
    for (const auto& [width, height] :
         {std::pair(0, 0), std::pair(-5, 800), std::pair(319, 800), std::pair(800, 239), std::pair(100000, 800)}) {
        EXPECT_THROW(drawChart(chart, width, height), Error);
    }
    EXPECT_THROW(drawChart(chart, 600, 400, 2.0), Error);
    EXPECT_THROW(drawChart(chart, 800, 600, 0.0), Error);
    EXPECT_THROW(drawChart(chart, 800, 600, notANumber), Error);
}

TEST(ChartFont, MissingOrNoFontIsNamed) {
    try {
        const ChartFont font("/nowhere/DejaVuSans.ttf");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("/nowhere/DejaVuSans.ttf"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("fonts-dejavu-core"), std::string::npos) << error.what();
    }
    EXPECT_THROW(ChartFont("/proc/self/status"), Error);
    EXPECT_THROW(ChartFont("/dev/null"), Error);
}

TEST(ChartFont, WrapsAndShortens) {
    const ChartFont& font = fonts().regular;
    const std::string text = "lines of words that are broken between them";
    std::string joined;
    for (const std::string& line : font.wrap(text, 12.0, 90.0)) {
        EXPECT_LE(font.width(line, 12.0), 90.0);
        joined += (joined.empty() ? "" : " ") + line;
    }
    EXPECT_EQ(joined, text);
    EXPECT_TRUE(font.wrap("", 12.0, 90.0).empty());
    EXPECT_EQ(font.shorten("short", 12.0, 90.0), "short");
    EXPECT_LE(font.width(font.shorten(text, 12.0, 90.0), 12.0), 90.0);
    EXPECT_EQ(font.shorten("ÄÖÜ", 12.0, font.width("Ä…", 12.0) + 0.01), "Ä…");
    EXPECT_NEAR(font.width("abc", 24.0), 2.0 * font.width("abc", 12.0), 1e-4);
}

TEST(ChartAxis, Labels) {
    EXPECT_EQ(tickLabel(1, 0), "1");
    EXPECT_EQ(tickLabel(5, 3), "5000");
    EXPECT_EQ(tickLabel(2, 5), "200000");
    EXPECT_EQ(tickLabel(1, 6), "10⁶");
    EXPECT_EQ(tickLabel(3, 12), "3×10¹²");
    EXPECT_EQ(tickLabel(1, -1), "0.1");
    EXPECT_EQ(tickLabel(7, -4), "0.0007");
    EXPECT_EQ(tickLabel(1, -5), "10⁻⁵");
}

TEST(ChartAxis, TicksAreExactAndApart) {
    for (const double decades : {0.5, 0.7, 1.0, 2.0, 3.5, 8.0, 40.0, 600.0}) {
        for (const double pixels : {200.0, 500.0, 1100.0}) {
            for (const double shift : {0.0, 0.21, 0.5, 0.83}) {
                const ChartAxis axis{shift - decades / 2.0, shift + decades / 2.0, 0.0, pixels, {}};
                double last = -infinity;
                for (const ChartTick& tick : ticksOf(axis, 40.0)) {
                    const double pixel = axis.pixelOf(tick.value);
                    EXPECT_GE(pixel, -1e-6);
                    EXPECT_LE(pixel, pixels + 1e-6);
                    if (!tick.label.empty()) {
                        EXPECT_GE(pixel - last, 40.0 - 1e-6);
                        last = pixel;
                    }
                    const bool isPower = tick.label.find("10") == 0 || tick.label.find("×") != std::string::npos;
                    if (!tick.label.empty() && !isPower) {
                        EXPECT_EQ(std::stod(tick.label), tick.value) << "the label is the value";
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace timeshade
