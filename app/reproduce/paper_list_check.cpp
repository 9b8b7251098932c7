#include "reproduce/paper_list_check.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "core/error.h"
#include "reproduce/verdict.h"

namespace timeshade {

namespace {

struct Names {
    std::set<std::string> steps, values;
};

void requireFile(const std::string& file, const Names& names) {
    const std::size_t slash = file.find('/');
    if (slash == std::string::npos || names.steps.count(file.substr(0, slash)) == 0 ||
        file.find("..") != std::string::npos)
        throw Error(fmt::format("file '{}' found, expected STEP/FILE with one of the figure's steps", file));
}

void requireValue(const std::string& value, const Names& names) {
    if (names.values.count(value) == 0) throw Error(fmt::format("value '{}' is named and not declared", value));
}

void requireSource(const PaperValue& value, const Names& names) {
    for (const auto& [name, factor] : value.sum) requireValue(name, names);
    const auto& [dividend, divisor] = value.quotient;
    if (!dividend.empty()) {
        requireValue(dividend, names);
        requireValue(divisor, names);
    }
    const int sources = !value.at.empty() + !value.column.empty() + !value.sum.empty() + !dividend.empty();
    if (sources != 1)
        throw Error(
            fmt::format("value '{}' has {} sources, expected one of at, column, sum, quotient", value.name, sources));
    if (!value.at.empty() || !value.column.empty()) requireFile(value.file, names);
}

void requireRule(const PaperRule& rule, const Names& names) {
    requireKnownRule(rule);
    for (const std::string& value : rule.of) requireValue(value, names);
    for (const PaperRule& each : rule.all) requireRule(each, names);
}

void requireTable(const PaperTable& table, const Names& names) {
    for (const std::vector<std::string>& row : table.rows) {
        if (row.size() != table.columns.size())
            throw Error(fmt::format("table '{}': a row of {} cells, expected {}", table.caption, row.size(),
                                    table.columns.size()));
        for (const std::string& cell : row)
            if (cell.starts_with("=")) requireValue(cell.substr(1), names);
    }
}

void requireClaim(const PaperClaim& claim, const Names& names) {
    requireRule(claim.rule, names);
    for (const std::string& value : claim.shown) requireValue(value, names);
    if (!claim.picture.empty()) requireFile(claim.picture, names);
}

void requireSteps(const PaperFigure& figure) {
    const bool redrawn = figure.kind == FigureKind::Reproduced;
    if (redrawn == figure.steps.empty())
        throw Error(redrawn ? "it is reproduced and has no steps" : "it has steps and is not reproduced");
    if (figure.kind == FigureKind::NotPossible && figure.reason.empty())
        throw Error("it is not possible; expected a reason");
    for (const PaperStep& step : figure.steps) {
        const bool plain = std::all_of(step.name.begin(), step.name.end(),
                                       [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
        if (!plain || step.name.empty() || step.arguments.empty())
            throw Error(fmt::format("step '{}': expected a name of letters and digits, and a command", step.name));
    }
}

}  // namespace

void requireWhole(const PaperFigure& figure) {
    requireSteps(figure);
    Names names;
    for (const PaperStep& step : figure.steps) names.steps.insert(step.name);
    for (const PaperValue& value : figure.values) {
        requireSource(value, names);  // so that a value depends on earlier ones alone
        names.values.insert(value.name);
    }
    for (const PaperPicture& picture : figure.pictures) requireFile(picture.file, names);
    for (const PaperPair& pair : figure.pairs) {
        requireFile(pair.left.file, names);
        requireFile(pair.right.file, names);
    }
    for (const PaperTable& table : figure.tables) requireTable(table, names);
    for (const PaperChart& chart : figure.charts) requireFile(chart.file, names);
    for (const PaperClaim& claim : figure.claims) requireClaim(claim, names);
}

}  // namespace timeshade
