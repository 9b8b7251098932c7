#include "reproduce/verdict.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"

namespace timeshade {

namespace {

/// Four digits, or all of those before the point in groups of three.
std::string digits(double number) {
    if (!(std::abs(number) >= 1000.0 && std::abs(number) < 1e15)) return fmt::format("{:.4g}", number);
    std::string text = fmt::format("{:.0f}", number);
    const std::size_t first = text.front() == '-' ? 1 : 0;
    for (std::size_t at = text.size(); at > first + 3;) text.insert(at -= 3, ",");
    return text;
}

struct Outcome {
    bool holds = false;
    std::string statement;  ///< with its numbers
};

using Measured = std::vector<const MeasuredValue*>;

double numberOf(const Measured& of, std::size_t i) { return *of[i]->number; }

std::string named(const MeasuredValue& value) { return fmt::format("{} ({})", value.label, inWords(value)); }

Outcome compared(const PaperRule& rule, const Measured& of) {
    const bool less = rule.kind == "less";
    const double bound = rule.by * numberOf(of, 1);
    const std::string times = rule.by == 1.0 ? "" : fmt::format("{:g} times ", rule.by);
    return {less ? numberOf(of, 0) < bound : numberOf(of, 0) > bound,
            fmt::format("{} is {} than {}{}", named(*of[0]), less ? "less" : "greater", times, named(*of[1]))};
}

Outcome limited(const PaperRule& rule, const Measured& of) {
    const bool most = rule.kind == "at_most";
    return {most ? numberOf(of, 0) <= rule.expected : numberOf(of, 0) >= rule.expected,
            fmt::format("{} is at {} {:.6g}{}{}", named(*of[0]), most ? "most" : "least", rule.expected,
                        of[0]->unit.empty() ? "" : " ", of[0]->unit)};
}

Outcome nearTo(const PaperRule& rule, const Measured& of) {
    const double expected = of.size() > 1 ? numberOf(of, 1) : rule.expected;
    const std::string to = of.size() > 1 ? named(*of[1]) : fmt::format("{:.6g}", expected);
    return {std::abs(numberOf(of, 0) - expected) <= rule.within * std::abs(expected),
            fmt::format("{} is within {:g} % of {}", named(*of[0]), 100.0 * rule.within, to)};
}

Outcome ratioOf(const PaperRule& rule, const Measured& of) {
    const double ratio = numberOf(of, 0) / numberOf(of, 1);
    const double off = ratio / rule.expected;
    return {off <= rule.within && off >= 1.0 / rule.within,
            fmt::format("{} is {:.4g} times {}; {:g} to {:g} times were expected", named(*of[0]), ratio, named(*of[1]),
                        rule.expected / rule.within, rule.expected * rule.within)};
}

std::string listed(const Measured& of) {
    std::vector<std::string> all;
    for (const MeasuredValue* value : of) all.push_back(named(*value));
    return fmt::format("{}", fmt::join(all, ", "));
}

Outcome trendOf(const PaperRule& rule, const Measured& of) {
    const bool rises = rule.kind == "rises";
    bool holds = true;
    for (std::size_t i = 1; i < of.size(); ++i)
        holds = holds && (rises ? numberOf(of, i) > numberOf(of, i - 1) : numberOf(of, i) < numberOf(of, i - 1));
    return {holds, fmt::format("{}: each {} than the one before", listed(of), rises ? "greater" : "less")};
}

Outcome flatness(const PaperRule& rule, const Measured& of) {
    double least = numberOf(of, 0), most = least;
    for (const MeasuredValue* value : of) {
        least = std::min(least, *value->number);
        most = std::max(most, *value->number);
    }
    return {most <= (1.0 + rule.within) * least,
            fmt::format("{}: the greatest at most {:g} times the least", listed(of), 1.0 + rule.within)};
}

Outcome crossing(const PaperRule&, const Measured& of) {
    const std::size_t half = of.size() / 2;
    return {numberOf(of, 0) < numberOf(of, half) && numberOf(of, half - 1) > numberOf(of, 2 * half - 1),
            fmt::format("{} is less than {}, and {} is greater than {}", named(*of[0]), named(*of[half]),
                        named(*of[half - 1]), named(*of[2 * half - 1]))};
}

struct Kind {
    const char* name;
    std::size_t leastValues;
    Outcome (*outcome)(const PaperRule&, const Measured&);
};

constexpr Kind kinds[] = {{"less", 2, compared},    {"greater", 2, compared}, {"at_most", 1, limited},
                          {"at_least", 1, limited}, {"near", 1, nearTo},      {"ratio", 2, ratioOf},
                          {"rises", 2, trendOf},    {"falls", 2, trendOf},    {"flat", 2, flatness},
                          {"crosses", 4, crossing}};

const Kind* kindOf(const std::string& name) {
    const Kind* found = std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& k) { return k.name == name; });
    return found == std::end(kinds) ? nullptr : found;
}

bool isOf(const std::string& hardware, const UsedDevice& device) {
    if (hardware == "a GPU") return !device.software && !device.name.empty();
    return device.name.find(hardware) != std::string::npos;
}

bool isUnclear(const PaperRule& rule, const Measured& of) {
    const double a = numberOf(of, 0), b = numberOf(of, 1);
    return std::abs(a - b) < rule.clear * std::max(std::abs(a), std::abs(b));
}

VerdictOf ofAll(const PaperRule& rule, const MeasuredValues& values, const UsedDevice& device) {
    VerdictOf whole{Verdict::Confirmed, ""};
    for (const PaperRule& each : rule.all) {
        const VerdictOf part = verdictOf(each, values, device);
        whole.why += (whole.why.empty() ? "" : "; ") + part.why;
        if (part.verdict == Verdict::NotComparable) return part;
        if (part.verdict == Verdict::Refuted) whole.verdict = Verdict::Refuted;
    }
    return whole;
}

}  // namespace

VerdictOf verdictOf(const PaperRule& rule, const MeasuredValues& values, const UsedDevice& device) {
    if (!isOf(rule.hardware, device))
        return {Verdict::NotComparable, fmt::format("stated for {}, drawn on {}", rule.hardware,
                                                    device.name.empty() ? "an unknown device" : device.name)};
    if (rule.kind == "all") return ofAll(rule, values, device);
    Measured of;
    for (const std::string& name : rule.of) {
        const auto value = values.find(name);
        if (value == values.end() || !value->second.number)
            return {Verdict::NotComparable,
                    fmt::format("{} is missing: {}", value == values.end() ? name : value->second.label,
                                value == values.end() ? "no such value" : value->second.missing)};
        of.push_back(&value->second);
    }
    const Kind* kind = kindOf(rule.kind);
    if (!kind) return {Verdict::NotComparable, rule.why.empty() ? "there is no number to compare with" : rule.why};
    if (of.size() > 1 && isUnclear(rule, of))
        return {Verdict::NotComparable,
                fmt::format("{} and {} differ by less than {:g} %", named(*of[0]), named(*of[1]), 100.0 * rule.clear)};
    const Outcome outcome = kind->outcome(rule, of);
    return {outcome.holds ? Verdict::Confirmed : Verdict::Refuted,
            (outcome.holds ? "holds: " : "does not hold: ") + outcome.statement};
}

void requireKnownRule(const PaperRule& rule) {
    if (rule.kind == "all" && !rule.all.empty()) return;
    if (rule.kind == "none" && !(rule.hardware + rule.why).empty()) return;
    const Kind* kind = kindOf(rule.kind);
    if (!kind) throw Error(fmt::format("test '{}' found, expected one of those of verdictOf", rule.kind));
    const bool even = rule.kind != "crosses" || rule.of.size() % 2 == 0;
    if (rule.of.size() < kind->leastValues || !even)
        throw Error(
            fmt::format("rule {} has {} values, expected {} or more", rule.kind, rule.of.size(), kind->leastValues));
}

const char* wordFor(Verdict verdict) {
    constexpr const char* words[] = {"confirmed", "refuted", "not comparable"};
    return words[static_cast<int>(verdict)];
}

std::string inWords(const MeasuredValue& value) {
    if (!value.number) return "-";
    return digits(*value.number) + (value.unit.empty() ? "" : " " + value.unit);
}

}  // namespace timeshade
