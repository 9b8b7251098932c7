#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reproduce/paper_result.h"

namespace timeshade {

/// What is to be redrawn of one paper.
struct PaperRequest {
    PaperList list;
    std::vector<PaperFigure> figures;  ///< those of the list that are wanted
    std::filesystem::path folder;
    std::string commit, program, command;  ///< `program`: as runStep() has it
    bool quick = false;
};

/// Runs what has not run yet, and prints a line for each step that ends. A step that fails does not end the others; a
/// stop signal does: then the result holds the figures that were finished before.
PaperResult runPaper(const PaperRequest& request);

}  // namespace timeshade
