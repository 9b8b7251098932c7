#pragma once

#include <string>
#include <vector>

namespace timeshade {

/// What a technique says of itself to people: in lists, in the window, and on its page.
struct TechniqueDescription {
    std::string name;        ///< as on the command line: lower case, also the name of its folders
    std::string title;       ///< "Time-dependent shadow maps"
    std::string shortTitle;  ///< for labels: "TSM"
    std::string summary;     ///< one sentence: the idea and the price
    std::string source;      ///< paper, year
    /// What its picture gets wrong and why, a sentence or two; and what to look at, or to set, to see it.
    std::string wrong, look;
    /// What page.png in its folder shows, left and right; empty where there is no such picture.
    std::string picture;
    std::vector<std::string> references;  ///< in full: authors, year, title, where
};

}  // namespace timeshade
