// What can't be drawn is said, and counts as a failure.

#include "reproduce/paper_result.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/temporary_folder.h"

namespace timeshade {
namespace {

TEST(PaperCharts, AreDrawnOrSayWhyNot) {
    namespace fs = std::filesystem;
    const test::TemporaryFolder folder;
    const fs::path& paper = folder.path();
    PaperFigure figure;
    figure.number = "7";
    figure.charts.resize(1);
    PaperChart& chart = figure.charts.front();
    chart.file = "times.csv";
    chart.x = "spp";
    chart.y = "ms";
    chart.by = "technique";
    fs::create_directory(paper / folderOf(figure));
    std::ofstream(paper / folderOf(figure) / chart.file) << "technique,spp,ms\ntsm,1,2.5\ntsm,2,4\n";

    const FigureResult drawn = figureResult(figure, {}, paper, {});
    EXPECT_EQ(drawn.charts.front().file, "chart-1.png");
    EXPECT_TRUE(fs::exists(paper / folderOf(figure) / "chart-1.png"));
    EXPECT_FALSE(drawn.failed());

    chart.y = "watts";
    const FigureResult without = figureResult(figure, {}, paper, {});
    EXPECT_EQ(without.charts.front().file, "");
    EXPECT_EQ(without.charts.front().missing, "times.csv: there is no column watts");
    EXPECT_FALSE(fs::exists(paper / folderOf(figure) / "chart-1.png")) << "that of an earlier run is gone";
    EXPECT_TRUE(without.failed());
}

}  // namespace
}  // namespace timeshade
