#pragma once

#include <map>
#include <optional>
#include <string>

#include "reproduce/paper_list.h"

namespace timeshade {

/// What a value of a figure has come to.
struct MeasuredValue {
    std::optional<double> number;  ///< none where it could not be read
    std::string label, unit;
    std::string missing;  ///< why there is none
};

using MeasuredValues = std::map<std::string, MeasuredValue>;

/// What the outputs of a paper were drawn on.
struct UsedDevice {
    std::string name;
    bool software = false;
};

enum class Verdict { Confirmed, Refuted, NotComparable };

struct VerdictOf {
    Verdict verdict = Verdict::NotComparable;
    std::string why;  ///< the rule with its numbers, or why there is none
};

/// The verdict that a rule gives. Kinds, of values a, b, ...:
///
/// - less: a < by b. greater: a > by b.
/// - at_most: a <= expected. at_least: a >= expected.
/// - near: a is off from expected by at most the share `within` of it; with two values, from the second.
/// - ratio: a / b and expected differ by a factor of at most `within`.
/// - rises, falls: each is greater, less, than the one before. flat: the greatest is at most 1 + within times the
/// least.
/// - crosses: of the values of the first half, the first is less than that of the second half and the last is greater.
/// - all: all of its rules hold.
/// - none: there is nothing to compare, `why` says for what reason, `hardware` what it would take.
///
/// Not comparable where the first two values differ by less than the share `clear` of the greater, where a value is
/// missing, or where a rule is of some hardware and the device is another: its name
/// does not hold that of the rule, or it is a software renderer and the rule is of "a GPU".
VerdictOf verdictOf(const PaperRule& rule, const MeasuredValues& values, const UsedDevice& device);

/// Throws Error for a rule of another kind, or with too few values.
void requireKnownRule(const PaperRule& rule);

/// "confirmed", "refuted", "not comparable".
const char* wordFor(Verdict verdict);

/// Four digits, or all before the point, and the unit: "12.35 ms", "45,120 ppm". "-" where there is none.
std::string inWords(const MeasuredValue& value);

}  // namespace timeshade
