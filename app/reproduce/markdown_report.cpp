#include "reproduce/markdown_report.h"

#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace timeshade {

namespace {

std::string rowOf(const std::vector<std::string>& cells) {
    std::string row = "|";
    for (const std::string& cell : cells) row += " " + forMarkdownCell(cell) + " |";
    return row + "\n";
}

std::string ruler(std::size_t columns) {
    std::string line = "|";
    for (std::size_t i = 0; i < columns; ++i) line += " --- |";
    return line + "\n";
}

std::string tableText(const PaperTable& table, const MeasuredValues& values) {
    std::string text = table.caption.empty() ? "" : table.caption + "\n\n";
    text += rowOf(table.columns) + ruler(table.columns.size());
    for (const std::vector<std::string>& row : table.rows) {
        std::vector<std::string> cells;
        for (const std::string& cell : row) cells.push_back(cellText(cell, values));
        text += rowOf(cells);
    }
    return text + "\n";
}

std::string image(const FigureResult& result, const PaperPicture& picture) {
    return fmt::format("![{0}]({1}/{2})\n*{0}*\n\n", picture.caption, result.folder, picture.file);
}

std::string claimsText(const FigureResult& result) {
    if (result.figure.claims.empty()) return "";
    std::string text = rowOf({"the paper says", "its number", "ours", "verdict"}) + ruler(4);
    for (std::size_t i = 0; i < result.figure.claims.size(); ++i) {
        const PaperClaim& claim = result.figure.claims[i];
        const VerdictOf& verdict = result.verdicts[i];
        text +=
            rowOf({fmt::format("{} ({})", claim.says, claim.stands), claim.number, shownValues(claim, result.values),
                   fmt::format("**{}**: {}", wordFor(verdict.verdict), verdict.why)});
    }
    return text + "\n";
}

/// Of a refuted claim, where it has one and it is there.
std::optional<ClaimPicture> pictureOf(const PaperResult& result, const FigureResult& figure, std::size_t claim) {
    const std::string& file = figure.figure.claims[claim].picture;
    if (figure.verdicts[claim].verdict != Verdict::Refuted || file.empty()) return std::nullopt;
    const std::filesystem::path path = result.folder / figure.folder / file;
    if (!std::filesystem::is_regular_file(path)) return std::nullopt;
    return ClaimPicture{path, fmt::format("{}-{}-{}.png", result.list.name, figure.folder,
                                          std::filesystem::path(file).parent_path().string())};
}

std::string stepsText(const FigureResult& result) {
    std::string text;
    for (const StepRecord& step : result.steps) {
        const std::string state =
            step.succeeded() ? "" : fmt::format("  # exit code {}: {}", step.exitCode, step.complaint);
        text += fmt::format("    {}{}\n", step.command, state);
    }
    return text.empty() ? "" : text + "\n";
}

std::string figureText(const FigureResult& result) {
    const PaperFigure& figure = result.figure;
    std::string text = fmt::format("## {}: {}\n\n", titleOf(figure), figure.caption);
    if (figure.kind == FigureKind::Drawing) text += "An explanatory drawing: there is nothing to measure.\n\n";
    if (figure.kind == FigureKind::NotPossible) text += fmt::format("Not redrawn: {}\n\n", figure.reason);
    if (!figure.note.empty()) text += figure.note + "\n\n";
    if (result.failed()) text += "**A step or a chart has failed; what depends on it is missing.**\n\n";
    text += claimsText(result);
    for (const PaperPicture& picture : figure.pictures) text += image(result, picture);
    for (const PaperPair& pair : figure.pairs) text += image(result, pair.left) + image(result, pair.right);
    for (std::size_t i = 0; i < result.charts.size(); ++i)
        if (const DrawnChart& chart = result.charts[i]; chart.file.empty())
            text += fmt::format("**A chart is missing: {}**\n\n", chart.missing);
        else
            text += image(result, {chart.file, figure.charts[i].caption});
    for (const PaperTable& table : figure.tables) text += tableText(table, result.values);
    return text + stepsText(result);
}

}  // namespace

std::string forMarkdownCell(std::string text) {
    for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
        text.replace(at, 1, "\\|");
    return text;
}

std::string markdownReport(const PaperResult& result) {
    const PaperList& list = result.list;
    std::string text =
        fmt::format("# {} ({})\n\n{}: *{}*. {}\n\n", list.name, list.year, list.authors, list.title, list.venue);
    text += fmt::format("Redrawn by Timeshade, commit {}, on {}.\n\n", result.commit, deviceInWords(result.device));
    if (result.quick) text += "**Quick form**: smaller pictures and fewer measurements than the full form.\n\n";
    if (result.failed()) text += "**Some steps have failed**: see below.\n\n";
    if (result.figures.size() < list.figures.size())
        text += fmt::format("{} of {} figures; the others were not asked for.\n\n", result.figures.size(),
                            list.figures.size());
    text += fmt::format("{} claims are confirmed, {} refuted, {} not comparable. All steps together took {:.0f} s.\n\n",
                        result.count(Verdict::Confirmed), result.count(Verdict::Refuted),
                        result.count(Verdict::NotComparable), result.seconds());
    text += fmt::format("    {}\n\n", result.command);
    for (const FigureResult& figure : result.figures) text += figureText(figure);
    while (text.ends_with("\n\n")) text.pop_back();
    return text;
}

std::vector<ClaimPicture> refutedPictures(const std::vector<PaperResult>& results) {
    std::vector<ClaimPicture> pictures;
    for (const PaperResult& result : results)
        for (const FigureResult& figure : result.figures)
            for (std::size_t i = 0; i < figure.verdicts.size(); ++i)
                if (const std::optional<ClaimPicture> picture = pictureOf(result, figure, i))
                    pictures.push_back(*picture);
    return pictures;
}

std::string claimsTable(const std::vector<PaperResult>& results, const std::string& pictures) {
    std::string text =
        rowOf({"paper", "where", "what it says", "its number", "ours", "verdict", "why", "picture"}) + ruler(8);
    for (const PaperResult& result : results)
        for (const FigureResult& figure : result.figures)
            for (std::size_t i = 0; i < figure.verdicts.size(); ++i) {
                const PaperClaim& claim = figure.figure.claims[i];
                const std::optional<ClaimPicture> picture = pictureOf(result, figure, i);
                text +=
                    rowOf({result.list.name, claim.stands, claim.says, claim.number, shownValues(claim, figure.values),
                           fmt::format("**{}**", wordFor(figure.verdicts[i].verdict)), figure.verdicts[i].why,
                           picture ? fmt::format("[ours]({}/{})", pictures, picture->name) : ""});
            }
    return text;
}

}  // namespace timeshade
