// Scripts of recordings.
#include <cstdint>
#include <string>

#include "read_or_refused.h"
#include "record/script_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    timeshade::fuzz::readOrRefused(
        [&] { timeshade::scriptOfJson(std::string(reinterpret_cast<const char*>(data), size), "file"); });
    return 0;
}
