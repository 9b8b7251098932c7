// What measure writes is what was measured: chart, table and journal hold the same numbers.

#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

#include <gtest/gtest.h>

#include "chart/chart_layout.h"
#include "core/error.h"
#include "measure/sweep_charts.h"
#include "measure/sweep_journal.h"
#include "measure/sweep_report.h"
#include "measure/technique_variant.h"

namespace timeshade {

namespace {

SweepRow makeRow(const std::string& technique, int sampleCount, double milliseconds, double rmse, std::uint64_t wrong) {
    SweepRow row;
    row.point = {"chess", technique, sampleCount, 512, "", 0.0};
    row.steps["total"] = {milliseconds, milliseconds - 1.0, milliseconds + 1.0};
    row.steps["build"] = {milliseconds / 3.0, 0.1, 7.0};
    row.renders = technique == "accumulation" ? 64 : 1;
    row.error.rmse = rmse;
    row.error.psnr = 40.0;
    row.error.offBy30 = 0.0125;
    row.biasAndNoise = {0.5 * rmse, 0.8 * rmse, 0.4 * rmse};
    row.verification.samples = 2'000'000;
    row.verification.tested = 1'000'000;
    row.verification.falseShadow = wrong;
    row.verification.shadowError.emplace();
    row.verification.shadowError->rays = 1024;
    row.verification.shadowError->error = {1000, 0.5 * rmse, 2.0 * rmse, 0.75, 0.001, 4.0 * rmse * rmse, 0.0001};
    row.verification.footprintError.error = {500, 0.25 * rmse, 0.5 * rmse, 0.5, 0.001, 0.25 * rmse * rmse, 0.0001};
    row.bytes = 12345678;
    return row;
}

std::vector<SweepRow> makeRows() {
    return {makeRow("static", 1, 10.25, 0.1, 40000), makeRow("static", 4, 41.5, 0.05, 40100),
            makeRow("tsm", 1, 31.0 / 3.0, 0.2, 9000), makeRow("tsm", 4, 123.456789012345, 0.0123456789, 7000)};
}

/// Each row twice, as measure has them: cold, which takes longer, then steady.
std::vector<SweepRow> inBothStates(const std::vector<SweepRow>& steady) {
    std::vector<SweepRow> rows;
    for (const SweepRow& row : steady) {
        rows.push_back(row);
        rows.back().state = FrameState::Cold;
        for (auto& [name, timing] : rows.back().steps) timing.median *= 2.0;
        rows.push_back(row);
    }
    return rows;
}

std::vector<std::vector<std::string>> tableOf(const std::string& csv) {
    std::vector<std::vector<std::string>> table;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        table.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) table.back().push_back(cell);
        if (line.ends_with(',')) table.back().emplace_back();
    }
    return table;
}

std::size_t columnOf(const std::vector<std::string>& header, const std::string& name) {
    const auto found = std::find(header.begin(), header.end(), name);
    EXPECT_NE(found, header.end()) << name;
    return static_cast<std::size_t>(found - header.begin());
}

struct Folder {
    Folder() : path(std::filesystem::temp_directory_path() / ("timeshade-sweep-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(path);
    }
    ~Folder() { std::filesystem::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::filesystem::path path;
};

TEST(SweepReport, TheChartsPointsAreTheTablesNumbers) {
    const std::vector<SweepRow> rows = makeRows();
    const auto table = tableOf(sweepCsv(rows));
    ASSERT_EQ(table.size(), rows.size() + 1);
    for (const auto& [what, column] :
         std::vector<std::pair<ChartOf, std::string>>{{ChartOf::ShadowError, "shadow_error_rms"},
                                                      {ChartOf::ImageError, "rmse"},
                                                      {ChartOf::Disagreement, "ppm"}}) {
        const Chart chart = sweepChart(rows, "chess", what, true);
        const std::size_t x = columnOf(table[0], "total_ms"), y = columnOf(table[0], column);
        std::size_t line = 1;
        for (const ChartSeries& series : chart.series)
            for (const ChartPoint& point : series.points) {
                EXPECT_EQ(series.name, table[line][columnOf(table[0], "technique")]);
                EXPECT_DOUBLE_EQ(point.x, std::stod(table[line][x]));
                EXPECT_DOUBLE_EQ(point.y, std::stod(table[line][y]));
                ++line;
            }
        EXPECT_EQ(line, table.size());
    }
}

TEST(SweepReport, ChartsShowSteadyFrames) {
    std::vector<SweepRow> rows = inBothStates(makeRows());
    SweepRow baseline = makeRow("embree", 1, 5.0, 0.1, 0);
    baseline.state = FrameState::Cold;
    rows.push_back(baseline);
    const Chart chart = sweepChart(rows, "chess", ChartOf::ShadowError, true);
    ASSERT_EQ(chart.series.size(), 3u);
    ASSERT_EQ(chart.series[0].points.size(), 2u) << "one a point, not one a row";
    EXPECT_EQ(chart.series[0].points[0].x, 10.25);
    ASSERT_EQ(chart.series[2].points.size(), 1u) << "what keeps nothing is cold in every frame";
    EXPECT_EQ(chart.series[2].points[0].x, 5.0);
}

TEST(SweepReport, RowsNameTheirState) {
    const std::vector<SweepRow> rows = inBothStates(makeRows());
    const auto table = tableOf(sweepCsv(rows));
    ASSERT_EQ(table.size(), rows.size() + 1);
    EXPECT_EQ(table[1][columnOf(table[0], "state")], "cold");
    EXPECT_EQ(table[2][columnOf(table[0], "state")], "steady");
    const Folder folder;
    writeSweepReport(folder.path, {}, rows);
    std::ifstream report(folder.path / "report.md");
    const std::string text{std::istreambuf_iterator<char>(report), {}};
    EXPECT_NE(text.find("| static | 1 | 512 | cold |"), std::string::npos) << text;
    EXPECT_NE(text.find("| static | 1 | 512 | steady |"), std::string::npos) << text;
}

TEST(SweepReport, ShadowErrorLeadsAndSaysWhatSaysNothing) {
    std::vector<SweepRow> rows{makeRow("tsm", 1, 10.0, 0.1, 40000), makeRow("static:pcf_radius=1", 1, 10.0, 0.02, 7)};
    rows[0].referenceNoise = 0.01;
    rows[1].referenceNoise = 0.015;
    rows[1].verification.footprint.filterTexels = 3.0;  // its values are no single tests
    rows.push_back(makeRow("exact", 1, 10.0, 0.1, 3));
    rows[2].verification.shadowError.reset();  // of a journal from before there was one
    const Folder folder;
    writeSweepReport(folder.path, {}, rows);
    std::ifstream report(folder.path / "report.md");
    const std::string text{std::istreambuf_iterator<char>(report), {}};
    for (const char* part : {"| 0.20000 ± 0.00100 | 0.05000 | 0.750 | 0.05000 | 40000 ppm | 0.10000 |",
                             "| 0.04000 ± 0.00100 | 0.01000 | 0.750 | 0.01000 | - | 0.02000 \\* |",
                             "| - | - | - | 0.05000 | 3 ppm | 0.10000 |"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    EXPECT_EQ(sweepChart(rows, "chess", ChartOf::ShadowError, true).series.size(), 2u);
    EXPECT_EQ(sweepChart(rows, "chess", ChartOf::Disagreement, true).series.size(), 2u);
}

TEST(SweepReport, BruteForceIsLabelledWithItsRenders) {
    const std::vector<SweepRow> rows{makeRow("accumulation", 8, 100.0, 0.01, 5)};
    EXPECT_EQ(sweepChart(rows, "chess", ChartOf::ShadowError, true).series.at(0).points.at(0).label, "64x");
}

TEST(SweepReport, EveryLineHasAllColumns) {
    const auto table = tableOf(sweepCsv(makeRows()));
    for (const auto& line : table) EXPECT_EQ(line.size(), table[0].size());
}

TEST(SweepReport, FilesAreWrittenWithTheirManifest) {
    const Folder folder;
    SweepManifest manifest;
    manifest.commandLine = "timeshade measure chess";
    manifest.commit = "0123456789ab";
    manifest.device.software = true;
    writeSweepReport(folder.path, manifest, makeRows());
    for (const char* name : {"accuracy.csv", "accuracy.json", "manifest.json", "report.md", "accuracy.png",
                             "chess-error.png", "chess-image-error.png", "chess-disagreement.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.path / name)) << name;
    std::ifstream report(folder.path / "report.md");
    const std::string text{std::istreambuf_iterator<char>(report), {}};
    EXPECT_NE(text.find("Software renderer"), std::string::npos);
    EXPECT_NE(text.find("0123456789ab"), std::string::npos);
    EXPECT_NE(text.find("| tsm | 4 | 512 | steady |"), std::string::npos);
}

/// Two values of a varied setting, a technique and a variant of it, one of them with a part of a step and a figure.
std::vector<SweepRow> makeVariedRows() {
    std::vector<SweepRow> rows;
    for (const double value : {1000.0, 2000.0})
        for (const std::string technique : {"tsm", "tsm:bias=2:dynamic_bias=on"}) {
            SweepRow row = makeRow(technique, 8, value / 100.0, 0.01, 50);
            row.point.scene = "cubes";
            row.point.varied = "cubes.count";
            row.point.variedValue = value;
            row.techniqueBytes = static_cast<std::size_t>(value) << 20;
            if (technique != "tsm") {
                row.steps["build/collect"] = {value / 1000.0, 0.5, 3.0};
                row.statistics = {{"entries", 1e7 + value, "", ""},
                                  {"lists with unpaired fragments", 3.0, "texels", "near plane"}};
            }
            rows.push_back(row);
        }
    return rows;
}

TEST(SweepReport, VariedSettingsAreTheHorizontalAxis) {
    const std::vector<SweepRow> rows = makeVariedRows();
    const Chart time = variedChart(rows, "cubes", VariedChartOf::Time, true),
                memory = variedChart(rows, "cubes", VariedChartOf::Memory, true);
    ASSERT_EQ(time.series.size(), 2u);
    EXPECT_EQ(time.xLabel, "cubes.count");
    EXPECT_EQ(time.series[1].name, "tsm:bias=2:dynamic_bias=on");
    ASSERT_EQ(time.series[1].points.size(), 2u);
    EXPECT_EQ(time.series[1].points[1].x, 2000.0);
    EXPECT_DOUBLE_EQ(time.series[1].points[1].y, 20.0 / 3.0) << "build and lookup";
    EXPECT_EQ(memory.series[0].points[0].y, 1000.0);
}

TEST(SweepReport, PartsAndVariedValuesHaveColumns) {
    const std::vector<SweepRow> rows = makeVariedRows();
    const auto table = tableOf(sweepCsv(rows));
    EXPECT_EQ(table[3][columnOf(table[0], "varied")], "cubes.count");
    EXPECT_EQ(table[3][columnOf(table[0], "value")], "2000");
    EXPECT_EQ(table[4][columnOf(table[0], "build/collect_ms")], "2");
    const Folder folder;
    writeSweepReport(folder.path, {}, rows);
    for (const char* name : {"cubes-time.png", "cubes-memory.png", "cubes-disagreement.png", "accuracy.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.path / name)) << name;
    std::ifstream report(folder.path / "report.md");
    const std::string text{std::istreambuf_iterator<char>(report), {}};
    for (const char* part :
         {"| technique | cubes.count | spp |", "| build/collect |", "| tsm | 2000 | 8 | 512 | steady |",
          "lists with unpaired fragments 3 texels (near plane)", "entries 10001000"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(SweepReport, VariantsAreTechniquesWithSettings) {
    gl::ProgramCache programs;
    const auto value = [](Technique& technique, const std::string& key) {
        for (const Setting& setting : settingsOf(technique))
            if (setting.key == key) return setting.get();
        return -1.0;
    };
    const TechniqueVariant variant = TechniqueVariant::of("tsm:bias=2:dynamic_bias=on");
    EXPECT_EQ(variant.name, "tsm");
    const std::unique_ptr<Technique> technique =
        variant.make({{"tsm.bias", "3"}, {"tsm.slope_bias", "1.5"}, {"static.bias", "7"}}, programs);
    EXPECT_EQ(value(*technique, "bias"), 2.0) << "its own settings come last";
    EXPECT_EQ(value(*technique, "dynamic_bias"), 1.0);
    EXPECT_EQ(value(*TechniqueVariant::of("tsm").make({{"tsm.bias", "3"}}, programs), "bias"), 3.0);
    for (const char* wrong :
         {"tsm:bias", "tsm:=2", "tsm:bias=much", "tsm:nonsense=1", "nonsense:bias=2", ":bias=2", ""})
        EXPECT_THROW(TechniqueVariant::of(wrong).make({}, programs), UsageError) << wrong;
}

TEST(SweepJournal, RowsSurviveTheWayThroughJson) {
    for (const SweepRow& row : makeRows()) EXPECT_EQ(rowAsJson(rowFromJson(rowAsJson(row))), rowAsJson(row));
    for (const SweepRow& row : makeVariedRows()) {
        const SweepRow back = rowFromJson(rowAsJson(row));
        EXPECT_EQ(rowAsJson(back), rowAsJson(row));
        EXPECT_EQ(back.point.key(), row.point.key());
        EXPECT_EQ(back.statistics.size(), row.statistics.size());
    }
}

/// Versions without states timed the second of two draws.
TEST(SweepJournal, ReadsRowsWithoutAState) {
    std::string text = rowAsJson(makeRows()[1]);
    for (const std::string part : {R"("state":"steady",)", R"("renders":1,)"}) {
        ASSERT_NE(text.find(part), std::string::npos) << text;
        text.erase(text.find(part), part.size());
    }
    const SweepRow row = rowFromJson(text);
    EXPECT_EQ(row.state, FrameState::Filling);
    EXPECT_EQ(row.renders, 1);
    EXPECT_EQ(row.steps.at("total").median, 41.5);
}

TEST(SweepJournal, GoesOnWhereItWasAndDropsALineThatIsCutOff) {
    const Folder folder;
    const std::filesystem::path path = folder.path / "rows.jsonl";
    const std::vector<SweepRow> rows = makeRows();
    const MadeWith madeWith{{"model", "A"}, {"frame", "12"}};
    {
        SweepJournal journal(path);
        journal.append(rows[0], madeWith);
        journal.append(rows[1], madeWith);
    }
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 5);
    SweepJournal again(path);
    ASSERT_NE(again.find(rows[0].point, FrameState::Steady, madeWith), nullptr);
    EXPECT_EQ(rowAsJson(*again.find(rows[0].point, FrameState::Steady, madeWith)), rowAsJson(rows[0]));
    EXPECT_EQ(again.find(rows[1].point, FrameState::Steady, madeWith), nullptr);
    EXPECT_EQ(again.find(rows[0].point, FrameState::Cold, madeWith), nullptr) << "one state does not stand for another";
}

TEST(SweepJournal, FindsRowsForJustWhatTheyWereMadeWith) {
    const Folder folder;
    const std::filesystem::path path = folder.path / "rows.jsonl";
    const SweepRow row = makeRows()[0];
    const MadeWith first{{"model", "A"}, {"frame", "12"}}, other{{"model", "B"}, {"frame", "12"}};
    SweepJournal(path).append(row, first);
    SweepJournal journal(path);
    EXPECT_EQ(journal.find(row.point, row.state, other), nullptr);
    EXPECT_EQ(journal.staleParts(row.point, other), std::vector<std::string>{"model"});
    EXPECT_TRUE(journal.staleParts(row.point, first).empty());
    journal.append(row, other);
    const SweepJournal both(path);
    EXPECT_NE(both.find(row.point, row.state, first), nullptr) << "rows of another model stay";
    EXPECT_NE(both.find(row.point, row.state, other), nullptr);
    EXPECT_TRUE(both.staleParts(row.point, first).empty());
}

TEST(SweepJournal, OverwritesNoFileThatIsNone) {
    const Folder folder;
    const std::filesystem::path path = folder.path / "rows.jsonl";
    std::ofstream(path) << "somebody's notes\nof today\n";
    EXPECT_THROW(SweepJournal{path}, Error);
    std::ifstream stream(path);
    std::string line;
    std::getline(stream, line);
    EXPECT_EQ(line, "somebody's notes");
}

}  // namespace

}  // namespace timeshade
