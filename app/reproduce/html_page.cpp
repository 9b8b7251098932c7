#include "reproduce/html_page.h"

#include <fmt/format.h>

#include "core/data_folder.h"
#include "core/file_bytes.h"
#include "reproduce/html_text.h"

namespace timeshade {

namespace {

constexpr std::size_t mostEmbedded = std::size_t{11} << 20;  // of files; in base 64 a third more

std::string partOfPage(const char* name) { return readFileText(dataFolder() / "assets" / "papers" / name); }

/// Writes the figures one after another, and counts what it embeds.
class PageWriter {
  public:
    explicit PageWriter(const PaperResult& result) : result_(result) {}

    std::string figure(const FigureResult& result);
    bool leftOut() const { return leftOut_; }

  private:
    std::string image(const FigureResult& result, const std::string& file, const std::string& name);
    std::string pictures(const FigureResult& result);
    std::string pair(const FigureResult& result, const PaperPair& pair);

    const PaperResult& result_;
    std::size_t embedded_ = 0;
    bool leftOut_ = false;
};

std::string PageWriter::image(const FigureResult& result, const std::string& file, const std::string& name) {
    const std::string path = result.folder + "/" + file;
    std::vector<unsigned char> bytes;
    try {
        bytes = readFileBytes(result_.folder / path);
    } catch (const std::exception&) {
        return fmt::format("<p class=\"failed\">{} is missing: its step has failed.</p>", forHtml(path));
    }
    if (embedded_ + bytes.size() > mostEmbedded) {
        leftOut_ = true;
        return fmt::format("<p><a href=\"{0}\">{0}</a></p>", forHtml(path));
    }
    embedded_ += bytes.size();
    return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", forHtml(name), base64(bytes));
}

std::string PageWriter::pair(const FigureResult& result, const PaperPair& pair) {
    return fmt::format(
        "<figure class=\"pair\"><div class=\"wipe\"><div class=\"right\">{}</div><div class=\"left\">{}</div></div>"
        "<input type=\"range\" min=\"0\" max=\"1000\" value=\"500\" aria-label=\"seam\">"
        "<figcaption><span>left: {}</span><span>right: {}</span></figcaption></figure>\n",
        image(result, pair.right.file, pair.right.caption), image(result, pair.left.file, pair.left.caption),
        forHtml(pair.left.caption), forHtml(pair.right.caption));
}

std::string PageWriter::pictures(const FigureResult& result) {
    std::string text;
    for (const PaperPair& each : result.figure.pairs) text += pair(result, each);
    text += "<div class=\"pictures\">\n";
    for (const PaperPicture& picture : result.figure.pictures)
        text += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                            image(result, picture.file, picture.caption), forHtml(picture.caption));
    for (std::size_t i = 0; i < result.charts.size(); ++i)
        if (const DrawnChart& chart = result.charts[i]; chart.file.empty())
            text += fmt::format("<p class=\"failed\">A chart is missing: {}</p>\n", forHtml(chart.missing));
        else
            text += fmt::format("<figure class=\"chart\">{}</figure>\n",
                                image(result, chart.file, result.figure.charts[i].caption));
    return text + "</div>\n";
}

std::string table(const PaperTable& table, const MeasuredValues& values) {
    std::string text = fmt::format("<table><caption>{}</caption><tr>", forHtml(table.caption));
    for (const std::string& column : table.columns) text += fmt::format("<th>{}</th>", forHtml(column));
    text += "</tr>\n";
    for (const std::vector<std::string>& row : table.rows) {
        text += "<tr>";
        for (const std::string& cell : row) text += fmt::format("<td>{}</td>", forHtml(cellText(cell, values)));
        text += "</tr>\n";
    }
    return text + "</table>\n";
}

const char* classOf(Verdict verdict) {
    constexpr const char* classes[] = {"confirmed", "refuted", "open"};
    return classes[static_cast<int>(verdict)];
}

std::string claimRow(const PaperClaim& claim, const VerdictOf& verdict, const MeasuredValues& values) {
    return fmt::format(
        "<tr><td>{} <span class=\"where\">{}</span></td><td>{}</td><td>{}</td>"
        "<td><b class=\"{}\">{}</b> {}</td></tr>\n",
        forHtml(claim.says), forHtml(claim.stands), forHtml(claim.number), forHtml(shownValues(claim, values)),
        classOf(verdict.verdict), wordFor(verdict.verdict), forHtml(verdict.why));
}

std::string claims(const FigureResult& result) {
    if (result.figure.claims.empty()) return "";
    std::string text =
        "<table class=\"claims\"><tr><th>the paper says</th><th>its number</th><th>ours</th><th>verdict</th></tr>\n";
    for (std::size_t i = 0; i < result.figure.claims.size(); ++i)
        text += claimRow(result.figure.claims[i], result.verdicts[i], result.values);
    return text + "</table>\n";
}

std::string steps(const FigureResult& result) {
    if (result.steps.empty()) return "";
    std::string text = "<details><summary>Commands</summary><table class=\"steps\">\n";
    for (const StepRecord& step : result.steps)
        text += fmt::format(
            "<tr><td><code>{}</code></td><td class=\"{}\">{}</td><td>{:.1f} s</td>"
            "<td><a href=\"{}/{}/step.json\">record</a></td></tr>\n",
            forHtml(step.command), step.succeeded() ? "" : "failed",
            step.succeeded() ? "done" : forHtml(fmt::format("exit code {}: {}", step.exitCode, step.complaint)),
            step.seconds, forHtml(result.folder), forHtml(step.name));
    return text + "</table></details>\n";
}

std::string PageWriter::figure(const FigureResult& result) {
    const PaperFigure& figure = result.figure;
    std::string text = fmt::format("<section id=\"{}\" class=\"{}\"><h2>{}</h2><p>{}</p>\n", forHtml(result.folder),
                                   figure.kind == FigureKind::Reproduced ? "redrawn" : "drawing",
                                   forHtml(titleOf(figure)), forHtml(figure.caption));
    if (figure.kind == FigureKind::Drawing)
        text += "<p class=\"note\">An explanatory drawing: there is nothing to measure.</p>\n";
    if (figure.kind == FigureKind::NotPossible)
        text += fmt::format("<p class=\"note\">Not redrawn: {}</p>\n", forHtml(figure.reason));
    if (!figure.note.empty()) text += fmt::format("<p class=\"note\">{}</p>\n", forHtml(figure.note));
    if (result.failed())
        text += "<p class=\"failed\">A step or a chart has failed; what depends on it is missing.</p>\n";
    text += claims(result);
    text += pictures(result);
    for (const PaperTable& each : figure.tables) text += table(each, result.values);
    return text + steps(result) + "</section>\n";
}

std::string head(const PaperResult& result) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}, redrawn</title>\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
        "'unsafe-inline'; script-src 'unsafe-inline'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<style>\n{1}</style></head><body>\n",
        forHtml(result.list.name), partOfPage("page.css"));
}

std::string introduction(const PaperResult& result, bool leftOut) {
    const PaperList& list = result.list;
    std::string text = fmt::format("<header><h1>{}</h1><p>{} ({}). {}</p>\n", forHtml(list.title),
                                   forHtml(list.authors), list.year, forHtml(list.venue));
    text += fmt::format("<p>Redrawn by Timeshade, commit {}, on {}.</p>\n", forHtml(result.commit),
                        forHtml(deviceInWords(result.device)));
    if (result.quick)
        text += "<p class=\"note\">Quick form: smaller pictures and fewer measurements than the full form.</p>\n";
    if (result.failed()) text += "<p class=\"failed\">Some steps have failed: see below.</p>\n";
    if (leftOut) text += "<p class=\"note\">To keep this page small, some pictures are links into its folder.</p>\n";
    if (result.figures.size() < list.figures.size())
        text += fmt::format("<p class=\"note\">{} of {} figures; the others were not asked for.</p>\n",
                            result.figures.size(), list.figures.size());
    text += fmt::format(
        "<p><b class=\"confirmed\">{} confirmed</b> <b class=\"refuted\">{} refuted</b> <b class=\"open\">{} not "
        "comparable</b>. All steps together took {:.0f} s.</p>\n<p><code>{}</code></p>\n<nav>",
        result.count(Verdict::Confirmed), result.count(Verdict::Refuted), result.count(Verdict::NotComparable),
        result.seconds(), forHtml(result.command));
    for (const FigureResult& figure : result.figures)
        text +=
            fmt::format("<a class=\"{2}\" href=\"#{0}\">{1}</a>", forHtml(figure.folder), forHtml(figure.figure.number),
                        figure.figure.kind == FigureKind::Reproduced ? "redrawn" : "drawing");
    return text + "</nav></header>\n";
}

}  // namespace

std::string htmlPage(const PaperResult& result) {
    PageWriter writer(result);
    std::string figures;
    for (const FigureResult& figure : result.figures) figures += writer.figure(figure);
    return head(result) + introduction(result, writer.leftOut()) + "<main>\n" + figures + "</main>\n" +
           "<div id=\"zoom\" hidden></div>\n<script>\n" + partOfPage("page.js") + "</script></body></html>\n";
}

}  // namespace timeshade
