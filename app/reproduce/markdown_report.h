#pragma once

#include <string>

#include "reproduce/paper_result.h"

namespace timeshade {

/// The result as report.md, whose pictures are links into the folder.
std::string markdownReport(const PaperResult& result);

/// A table of every claim of the papers: what is said, where, the paper's number, ours, the verdict. `linked` makes a
/// link of a claim's picture, where it has one and the claim is refuted; may be empty.
std::string claimsTable(const std::vector<PaperResult>& results);

/// Text for a cell of a table.
std::string forMarkdownCell(std::string text);

}  // namespace timeshade
