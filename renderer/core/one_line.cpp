#include "core/one_line.h"

#include <cstdint>

namespace timeshade {

namespace {

/// Length of the character at the place if it is one that acts on what stands around it: a control character of ASCII
/// or of Unicode's C1, or one that turns the direction of writing; 0 for any other.
std::size_t lengthOfControl(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return at + i < text.size() ? static_cast<std::uint8_t>(text[at + i]) : std::uint8_t{0};
    };
    if (byte(0) < 0x20 || byte(0) == 0x7f) return 1;
    if (byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) <= 0x9f) return 2;  // U+0080 to U+009F
    if (byte(0) == 0xd8 && byte(1) == 0x9c) return 2;                     // U+061C
    if (byte(0) != 0xe2) return 0;
    const bool mark = byte(1) == 0x80 && (byte(2) == 0x8e || byte(2) == 0x8f);   // U+200E, U+200F
    const bool line = byte(1) == 0x80 && byte(2) >= 0xa8 && byte(2) <= 0xae;     // U+2028 to U+202E
    const bool isolate = byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9;  // U+2066 to U+2069
    return mark || line || isolate ? 3 : 0;
}

}  // namespace

std::string oneLine(std::string_view text, std::size_t limit) {
    constexpr std::string_view ellipsis = "...";
    std::string line;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t control = lengthOfControl(text, at);
        line += control > 0 ? ' ' : text[at];
        at += control > 0 ? control : 1;
    }
    while (!line.empty() && line.back() == ' ') line.pop_back();
    if (line.size() <= limit) return line;

    std::size_t end = limit > ellipsis.size() ? limit - ellipsis.size() : 0;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xc0u) == 0x80u) --end;  // a continuation byte
    return line.substr(0, end).append(ellipsis);
}

std::string lastLine(std::string_view text, std::size_t limit) {
    text = text.substr(0, text.find_last_not_of("\r\n ") + 1);
    return oneLine(text.substr(text.find_last_of("\r\n") + 1), limit);
}

}  // namespace timeshade
