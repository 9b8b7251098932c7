#pragma once

#include <string>
#include <vector>

namespace timeshade {

/// `timeshade reproduce`: the figures of a paper, redrawn.
struct ReproduceOptions {
    std::string paper;  ///< names of lists between commas, or "all"; several go into folders of their names
    std::vector<std::string> figures;  ///< numbers as the paper has them; empty for all
    std::string output;                ///< folder
    std::string claims;                ///< F.md for the table of claims; empty for none
    bool quick = false;                ///< the smaller form of every command
    std::string commandLine;           ///< as typed
};

}  // namespace timeshade
