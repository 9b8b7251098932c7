#include "core/nearest_word.h"

#include <algorithm>
#include <cctype>

namespace timeshade {

namespace {

constexpr std::size_t longest = 64;  // letters; what is longer is no misspelt name

std::string small(const std::string& word) {
    std::string letters;
    for (const char c : word) letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return letters;
}

/// Changes from one word to the other, a swap of neighbours being one.
std::size_t changesBetween(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> to(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) to[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) to[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            to[i][j] =
                std::min({to[i - 1][j] + 1, to[i][j - 1] + 1, to[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                to[i][j] = std::min(to[i][j], to[i - 2][j - 2] + 1);
        }
    return to[a.size()][b.size()];
}

}  // namespace

std::optional<std::string> nearestWord(const std::string& word, const std::vector<std::string>& known) {
    if (word.empty() || word.size() > longest) return std::nullopt;
    const std::string given = small(word);
    const std::string* best = nullptr;
    std::size_t fewest = longest;
    std::vector<const std::string*> begun;
    for (const std::string& candidate : known) {
        if (candidate == word) return std::nullopt;
        if (candidate.size() > longest) continue;
        const std::string letters = small(candidate);
        if (letters.starts_with(given)) begun.push_back(&candidate);
        const std::size_t changes = changesBetween(given, letters);
        if (changes < fewest && 3 * changes <= std::max<std::size_t>(3, letters.size())) {
            fewest = changes;
            best = &candidate;
        }
    }
    if (best != nullptr && fewest < given.size()) return *best;
    if (begun.size() == 1 && given.size() > 1) return *begun.front();
    return std::nullopt;
}

std::string didYouMean(const std::string& word, const std::vector<std::string>& known) {
    const std::optional<std::string> meant = nearestWord(word, known);
    return meant ? " (did you mean " + *meant + "?)" : "";
}

}  // namespace timeshade
