#include "reproduce/reproduce.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <timeshade/commit.h>  // generated

#include "core/error.h"
#include "core/file_bytes.h"
#include "core/folder_lock.h"
#include "image/image_file.h"
#include "measure/made_with.h"
#include "output_path.h"
#include "record/stop_signals.h"
#include "reproduce/html_page.h"
#include "reproduce/markdown_report.h"
#include "reproduce/paper_run.h"
#include "standard_error.h"

namespace timeshade {

namespace {

constexpr const char* claimPictures = "pictures/claims";  // beside the table

/// The figures of these numbers, in the list's order; all of none.
std::vector<PaperFigure> chosen(const PaperList& list, const std::vector<std::string>& numbers) {
    if (numbers.empty()) return list.figures;
    std::vector<std::string> known;
    for (const PaperFigure& figure : list.figures) known.push_back(folderOf(figure));
    for (const std::string& number : numbers)
        if (std::find(known.begin(), known.end(), number) == known.end())
            throw UsageError(fmt::format("reproduce {} {}: no such figure; expected some of {}", list.name, number,
                                         fmt::join(known, ", ")));
    std::vector<PaperFigure> figures;
    for (const PaperFigure& figure : list.figures)
        if (std::find(numbers.begin(), numbers.end(), folderOf(figure)) != numbers.end()) figures.push_back(figure);
    return figures;
}

/// The names between commas, each once, or all.
std::vector<std::string> papersIn(const std::string& text) {
    if (text == "all") return paperNames();
    std::istringstream stream(text);
    std::vector<std::string> names;
    for (std::string name; std::getline(stream, name, ',');)
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    return names;
}

std::vector<PaperRequest> requestsOf(const ReproduceOptions& options) {
    const std::vector<std::string> names = papersIn(options.paper);
    const bool several = options.paper == "all" || names.size() > 1;
    if (several && !options.figures.empty())
        throw UsageError(
            fmt::format("reproduce {} {}: expected no figures, or one paper", options.paper, options.figures.front()));
    std::vector<std::string> madeWith;
    for (const auto& [part, value] : madeWithBinary(TIMESHADE_COMMIT)) madeWith.push_back(value);
    const std::string program = fmt::format("{}", fmt::join(madeWith, " "));
    std::vector<PaperRequest> requests;
    for (const std::string& name : names) {
        PaperRequest request{readPaperList(name, options.quick),
                             {},
                             options.output,
                             TIMESHADE_COMMIT,
                             program,
                             options.commandLine,
                             options.quick};
        request.figures = chosen(request.list, options.figures);
        if (several) request.folder /= name;
        requests.push_back(std::move(request));
    }
    return requests;
}

void writeReports(const PaperResult& result) {
    writeFileAtomically(result.folder / "report.md", markdownReport(result));
    writeFileAtomically(result.folder / "index.html", htmlPage(result));
    fmt::print("{}  {} confirmed, {} refuted, {} not comparable\n", fullPath(result.folder / "index.html"),
               result.count(Verdict::Confirmed), result.count(Verdict::Refuted), result.count(Verdict::NotComparable));
}

std::string claimsDocument(const std::vector<PaperResult>& results, const ReproduceOptions& options) {
    std::string text = "# Claims of the papers, and what comes of them here\n\n";
    text +=
        "Made by the command below; every verdict follows from a rule in assets/papers and from the numbers "
        "beside it.\n";
    text += fmt::format("\n    {}\n\n", options.commandLine);
    text += fmt::format("{}{}.\n\n", options.quick ? "Quick form. " : "", deviceInWords(results.front().device));
    return text + claimsTable(results, claimPictures);
}

/// The table, and the pictures that it links to.
void writeClaims(const std::vector<PaperResult>& results, const ReproduceOptions& options) {
    const std::filesystem::path folder = std::filesystem::path(options.claims).parent_path() / claimPictures;
    const std::vector<ClaimPicture> pictures = refutedPictures(results);
    if (!pictures.empty()) madeFolder(folder);
    for (const ClaimPicture& picture : pictures) {
        writeFileAtomically(folder / picture.name, readFileText(picture.from));
    }
    writeFileAtomically(options.claims, claimsDocument(results, options));
    fmt::print("{}\n", fullPath(options.claims));
}

}  // namespace

int runReproduce(const ReproduceOptions& options) {
    const std::vector<PaperRequest> requests = requestsOf(options);
    if (!options.claims.empty()) requireWritable(options.claims);
    const FolderLock lock(madeFolder(options.output));
    const StopSignals signals;
    std::vector<PaperResult> results;
    for (const PaperRequest& request : requests) {
        madeFolder(request.folder);
        results.push_back(runPaper(request));
        if (StopSignals::count() > 0)
            throw Error(fmt::format("{}: {}; the same command goes on from here", options.output, StopSignals::name()));
        writeReports(results.back());
    }
    if (!options.claims.empty()) writeClaims(results, options);
    const auto failed = [](const PaperResult& result) { return result.failed(); };
    if (std::none_of(results.begin(), results.end(), failed)) return 0;
    tell("error: some steps have failed; the pages say which");
    return 1;
}

}  // namespace timeshade
