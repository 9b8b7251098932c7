#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "measure/sweep_row_json.h"

namespace timeshade {

/// Finished rows on disk, one JSON object a line, appended and flushed as they are made: a sweep that is interrupted
/// goes on where it was. Every row says what it was made with, and is found again for just that; rows of other models,
/// sizes, shaders lie beside it untouched. A last line that is cut off is dropped. Throws Error where the file is there
/// and is no journal, or has more than 256 MiB.
class SweepJournal {
  public:
    explicit SweepJournal(const std::filesystem::path& path);
    const SweepRow* find(const SweepPoint& point, FrameState state, const MadeWith& madeWith) const;
    /// What tells the newest row of this point from one made with this; empty where there is none, or one that fits.
    std::vector<std::string> staleParts(const SweepPoint& point, const MadeWith& madeWith) const;
    void append(const SweepRow& row, const MadeWith& madeWith);

  private:
    std::filesystem::path path_;
    std::deque<JournalEntry> entries_;  ///< a pointer to a row stays good while others are added
};

}  // namespace timeshade
