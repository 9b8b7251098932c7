#include "core/one_line.h"

namespace timeshade {

std::string oneLine(std::string_view text, std::size_t limit) {
    constexpr std::string_view ellipsis = "...";
    std::string line(text);
    for (char& c : line) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) c = ' ';
    }
    while (!line.empty() && line.back() == ' ') line.pop_back();
    if (line.size() <= limit) return line;

    std::size_t end = limit > ellipsis.size() ? limit - ellipsis.size() : 0;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xc0u) == 0x80u) --end;  // a continuation byte
    return line.substr(0, end).append(ellipsis);
}

}  // namespace timeshade
