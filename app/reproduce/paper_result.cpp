#include "reproduce/paper_result.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "chart/chart.h"
#include "core/error.h"
#include "image/image_file.h"

namespace timeshade {

namespace {

constexpr int chartWidth = 720, chartHeight = 440;

Chart chartOf(const PaperChart& wanted, const std::filesystem::path& folder) {
    Chart chart;
    chart.title = wanted.caption;
    chart.xLabel = wanted.xLabel;
    chart.yLabel = wanted.yLabel;
    for (const CsvRow& row : rowsWhere(readCsv(folder / wanted.file), wanted.where)) {
        const auto cell = [&row](const std::string& column) {
            const auto found = row.find(column);
            if (found == row.end()) throw Error("there is no column " + column);
            return found->second;
        };
        const std::string of = cell(wanted.by);
        const auto name = wanted.names.find(of);
        if (!wanted.names.empty() && name == wanted.names.end()) continue;
        const std::string shown = wanted.names.empty() ? of : name->second;
        auto series = std::find_if(chart.series.begin(), chart.series.end(),
                                   [&](const ChartSeries& each) { return each.name == shown; });
        if (series == chart.series.end()) series = chart.series.insert(series, {shown, {}});
        series->points.push_back({numberIn(cell(wanted.x)), wanted.scale * numberIn(cell(wanted.y)), ""});
    }
    if (chart.series.empty()) throw Error("no row fits");
    return chart;
}

DrawnChart drawn(const PaperChart& chart, std::size_t number, const std::filesystem::path& folder) {
    const std::string name = fmt::format("chart-{}.png", number);
    try {
        writePng(folder / name, drawChart(chartOf(chart, folder), chartWidth, chartHeight));
    } catch (const std::exception& error) {
        std::filesystem::remove(folder / name);  // of an earlier run
        return {"", fmt::format("{}: {}", chart.file, error.what())};
    }
    return {name, ""};
}

}  // namespace

bool FigureResult::failed() const {
    return std::any_of(steps.begin(), steps.end(), [](const StepRecord& step) { return !step.succeeded(); }) ||
           std::any_of(charts.begin(), charts.end(), [](const DrawnChart& chart) { return chart.file.empty(); });
}

bool PaperResult::failed() const {
    return std::any_of(figures.begin(), figures.end(), [](const FigureResult& figure) { return figure.failed(); });
}

double PaperResult::seconds() const {
    double sum = 0.0;
    for (const FigureResult& figure : figures)
        for (const StepRecord& step : figure.steps) sum += step.seconds;
    return sum;
}

int PaperResult::count(Verdict verdict) const {
    int sum = 0;
    for (const FigureResult& figure : figures)
        for (const VerdictOf& each : figure.verdicts) sum += each.verdict == verdict ? 1 : 0;
    return sum;
}

std::string folderOf(const PaperFigure& figure) {
    std::string name = figure.number;
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

std::string titleOf(const PaperFigure& figure) {
    return figure.isNumbered() ? "Figure " + figure.number : "S" + figure.number.substr(1);
}

FigureResult figureResult(const PaperFigure& figure, std::vector<StepRecord> steps, const std::filesystem::path& paper,
                          const UsedDevice& device) {
    FigureResult result{figure, std::move(steps), {}, {}, {}, folderOf(figure)};
    const std::filesystem::path folder = paper / result.folder;
    result.values = readValues(figure, folder);
    for (const PaperClaim& claim : figure.claims)
        result.verdicts.push_back(verdictOf(claim.rule, result.values, device));
    for (const PaperChart& chart : figure.charts)
        result.charts.push_back(drawn(chart, result.charts.size() + 1, folder));
    return result;
}

std::string cellText(const std::string& cell, const MeasuredValues& values) {
    if (!cell.starts_with("=")) return cell;
    const auto value = values.find(cell.substr(1));
    return value == values.end() ? "-" : inWords(value->second);
}

std::string shownValues(const PaperClaim& claim, const MeasuredValues& values) {
    std::vector<std::string> all;
    for (const std::string& name : claim.shown)
        if (const auto value = values.find(name); value != values.end())
            all.push_back(value->second.label + " " + inWords(value->second));
    return fmt::format("{}", fmt::join(all, ", "));
}

std::string deviceInWords(const UsedDevice& device) {
    if (device.name.empty()) return "unknown, since no step has said";
    return device.name + (device.software ? ", a software renderer: its times say nothing about a GPU" : "");
}

}  // namespace timeshade
