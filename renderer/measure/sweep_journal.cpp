#include "measure/sweep_journal.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/error.h"
#include "core/file_bytes.h"
#include "image/image_file.h"
#include "image/part_file.h"

namespace timeshade {

namespace {

constexpr std::size_t largestJournal = std::size_t{256} << 20;  // more than 100,000 rows

/// By one call, so that a line is there as a whole or is the last one.
void appendLine(const std::filesystem::path& path, const std::string& line) {
    const int file = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
    const bool written = file >= 0 && ::write(file, line.data(), line.size()) == static_cast<ssize_t>(line.size());
    const int code = errno;
    if (file >= 0) ::close(file);
    if (!written) throw Error(fmt::format("cannot write {}: {}", path.string(), std::generic_category().message(code)));
}

}  // namespace

SweepJournal::SweepJournal(const std::filesystem::path& path) : path_(followOwnLinks(path)) {
    if (!std::filesystem::exists(path_)) return;
    const std::string text = readFileText(path_, largestJournal);
    JournalText journal;
    try {
        journal = journalOf(text);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}; expected a journal of measured rows, or no file of that name", path_.string(),
                                error.what()));
    }
    entries_ = std::move(journal.entries);
    writeFileAtomically(path_, journal.wholeLines);
}

const SweepRow* SweepJournal::find(const SweepPoint& point, FrameState state, const MadeWith& madeWith) const {
    for (const JournalEntry& entry : entries_)
        if (entry.row.state == state && entry.row.point.key() == point.key() && entry.madeWith == madeWith)
            return &entry.row;
    return nullptr;
}

std::vector<std::string> SweepJournal::staleParts(const SweepPoint& point, const MadeWith& madeWith) const {
    std::vector<std::string> parts;
    for (const JournalEntry& entry : entries_) {
        if (entry.row.point.key() != point.key()) continue;
        parts = differingParts(entry.madeWith, madeWith);
        if (parts.empty()) return parts;
    }
    return parts;
}

void SweepJournal::append(const SweepRow& row, const MadeWith& madeWith) {
    entries_.push_back({row, madeWith});
    appendLine(path_, lineOf(entries_.back()));
}

}  // namespace timeshade
