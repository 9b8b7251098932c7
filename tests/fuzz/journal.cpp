// Journals of measured rows. What was read is written and read again.
#include <cstdint>
#include <string>

#include "core/check.h"
#include "measure/sweep_row_json.h"
#include "read_or_refused.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    timeshade::fuzz::readOrRefused([&] {
        std::string again;
        for (const timeshade::JournalEntry& entry :
             timeshade::journalOf(std::string(reinterpret_cast<const char*>(data), size)).entries)
            again += timeshade::lineOf(entry);
        CHECK_EQ(timeshade::journalOf(again).wholeLines, again);
    });
    return 0;
}
