#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reproduce/paper_result.h"

namespace timeshade {

/// The result as report.md, whose pictures are links into the folder.
std::string markdownReport(const PaperResult& result);

/// A refuted claim whose picture is copied beside the table of claims.
struct ClaimPicture {
    std::filesystem::path from;
    std::string name;  ///< "hong2019-9-wrong_published.png"
};

/// The pictures of all refuted claims that have one and whose step has drawn it.
std::vector<ClaimPicture> refutedPictures(const std::vector<PaperResult>& results);

/// A table of every claim of the papers: what is said, where, the paper's number, ours, the verdict, and a link to
/// `pictures`/NAME for those of refutedPictures().
std::string claimsTable(const std::vector<PaperResult>& results, const std::string& pictures);

/// Text for a cell of a table.
std::string forMarkdownCell(std::string text);

}  // namespace timeshade
