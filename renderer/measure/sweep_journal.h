#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/sweep.h"

namespace timeshade {

/// Finished rows on disk, one JSON object a line, appended and flushed as they are made: a sweep that is interrupted
/// goes on where it was. A last line that is cut off is dropped. The first line names the experiment; a journal of
/// another experiment is started anew.
class SweepJournal {
  public:
    SweepJournal(std::filesystem::path path, const std::string& experiment);
    const SweepRow* find(const SweepPoint& point, FrameState state) const;
    void append(const SweepRow& row);

  private:
    std::filesystem::path path_;
    std::vector<SweepRow> rows_;
};

/// A row as JSON, every figure with all its digits, and back. A row without a state comes from a version that drew a
/// point twice and timed the second time: its state is Filling.
std::string rowAsJson(const SweepRow& row);
SweepRow rowFromJson(const std::string& text);

}  // namespace timeshade
