#pragma once

#include <deque>
#include <string>

#include "measure/made_with.h"
#include "measure/sweep.h"

namespace timeshade {

/// A row as JSON, every figure with all its digits, and back. A row without a state comes from a version that drew a
/// point twice and timed the second time: its state is Filling. Throws std::exception for anything else.
std::string rowAsJson(const SweepRow& row);
SweepRow rowFromJson(const std::string& text);

struct JournalEntry {
    SweepRow row;
    MadeWith madeWith;
};

/// The line of a journal, with its end.
std::string lineOf(const JournalEntry& entry);

struct JournalText {
    std::deque<JournalEntry> entries;  ///< a pointer to a row stays good while others are added
    std::string wholeLines;
};

/// What a journal holds. A last line that is cut off is dropped. Throws Error with the reason, without a file's name,
/// where the text is no journal or has a line of more than 1 MiB.
JournalText journalOf(const std::string& text);

}  // namespace timeshade
