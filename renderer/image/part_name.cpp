#include "image/part_name.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>
#include <sys/random.h>

#include "core/error.h"

namespace timeshade {

namespace {

constexpr std::size_t randomDigits = 16;
constexpr std::string_view ending = ".part";
constexpr std::size_t longestStem = 200;  // room for the rest where the name has the greatest length

}  // namespace

std::string stemOfParts(const std::filesystem::path& target) {
    return target.filename().string().substr(0, longestStem) + ".";
}

std::filesystem::path newPartName(const std::filesystem::path& target) {
    std::uint64_t number = 0;
    if (::getrandom(&number, sizeof number, 0) != sizeof number) throw Error("the system has no random numbers");
    return folderOfParts(target) / fmt::format("{}{:016x}{}", stemOfParts(target), number, ending);
}

bool isPartName(const std::string& name, const std::string& stem) {
    return name.size() == stem.size() + randomDigits + ending.size() && name.starts_with(stem) &&
           name.ends_with(ending) &&
           name.find_first_not_of("0123456789abcdef", stem.size()) == stem.size() + randomDigits;
}

std::filesystem::path folderOfParts(const std::filesystem::path& target) {
    return target.parent_path().empty() ? "." : target.parent_path();
}

}  // namespace timeshade
