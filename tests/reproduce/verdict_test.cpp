// A verdict turns when the numbers do, and is never given without them.

#include "reproduce/verdict.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"

namespace timeshade {
namespace {

MeasuredValues values(std::initializer_list<std::pair<const char*, double>> numbers) {
    MeasuredValues all;
    for (const auto& [name, number] : numbers) all[name] = {number, name, "ms", ""};
    return all;
}

PaperRule rule(const std::string& kind, std::vector<std::string> of, double expected = 0.0, double within = 0.0) {
    PaperRule made;
    made.kind = kind;
    made.of = std::move(of);
    made.expected = expected;
    made.within = within;
    return made;
}

Verdict verdict(const PaperRule& of, const MeasuredValues& numbers) {
    return verdictOf(of, numbers, {"llvmpipe", true}).verdict;
}

constexpr Verdict yes = Verdict::Confirmed, no = Verdict::Refuted, open = Verdict::NotComparable;

TEST(Verdict, OfAnOrderTurnsWithTheNumbers) {
    PaperRule less = rule("less", {"a", "b"});
    EXPECT_EQ(verdict(less, values({{"a", 1.0}, {"b", 2.0}})), yes);
    EXPECT_EQ(verdict(less, values({{"a", 2.0}, {"b", 1.0}})), no);
    EXPECT_EQ(verdict(less, values({{"a", 1.0}, {"b", 1.0}})), no);
    less.by = 0.5;
    EXPECT_EQ(verdict(less, values({{"a", 1.1}, {"b", 2.0}})), no);
    EXPECT_EQ(verdict(less, values({{"a", 0.9}, {"b", 2.0}})), yes);
    EXPECT_EQ(verdict(rule("greater", {"a", "b"}), values({{"a", 2.0}, {"b", 1.0}})), yes);
    EXPECT_EQ(verdict(rule("greater", {"a", "b"}), values({{"a", 1.0}, {"b", 2.0}})), no);
}

TEST(Verdict, IsNotGivenOnADifferenceThatIsNotClear) {
    PaperRule greater = rule("greater", {"a", "b"});
    greater.clear = 0.02;
    EXPECT_EQ(verdict(greater, values({{"a", 1.01}, {"b", 1.0}})), open);
    EXPECT_EQ(verdict(greater, values({{"a", 1.0}, {"b", 1.01}})), open);
    EXPECT_EQ(verdict(greater, values({{"a", 0.0}, {"b", 0.0}})), no) << "nothing is no difference";
    EXPECT_EQ(verdict(greater, values({{"a", 1.03}, {"b", 1.0}})), yes);
    EXPECT_EQ(verdict(greater, values({{"a", 1.0}, {"b", 1.03}})), no);
}

TEST(Verdict, OfALimitTurnsAtIt) {
    EXPECT_EQ(verdict(rule("at_most", {"a"}, 3.0), values({{"a", 3.0}})), yes);
    EXPECT_EQ(verdict(rule("at_most", {"a"}, 3.0), values({{"a", 3.01}})), no);
    EXPECT_EQ(verdict(rule("at_least", {"a"}, 3.0), values({{"a", 3.0}})), yes);
    EXPECT_EQ(verdict(rule("at_least", {"a"}, 3.0), values({{"a", 2.99}})), no);
    EXPECT_EQ(verdict(rule("near", {"a"}, 100.0, 0.05), values({{"a", 104.0}})), yes);
    EXPECT_EQ(verdict(rule("near", {"a"}, 100.0, 0.05), values({{"a", 94.0}})), no);
    EXPECT_EQ(verdict(rule("near", {"a", "b"}, 0.0, 0.1), values({{"a", 105.0}, {"b", 100.0}})), yes);
    EXPECT_EQ(verdict(rule("near", {"a", "b"}, 0.0, 0.1), values({{"a", 111.0}, {"b", 100.0}})), no);
}

TEST(Verdict, OfARatioTurnsOnBothSides) {
    const PaperRule twice = rule("ratio", {"a", "b"}, 2.0, 1.25);
    EXPECT_EQ(verdict(twice, values({{"a", 2.4}, {"b", 1.0}})), yes);
    EXPECT_EQ(verdict(twice, values({{"a", 2.6}, {"b", 1.0}})), no);
    EXPECT_EQ(verdict(twice, values({{"a", 1.7}, {"b", 1.0}})), yes);
    EXPECT_EQ(verdict(twice, values({{"a", 1.5}, {"b", 1.0}})), no);
    EXPECT_EQ(verdict(twice, values({{"a", 1.0}, {"b", 0.0}})), no) << "a division by 0 confirms nothing";
}

TEST(Verdict, OfATrendTurnsWithOneOfItsNumbers) {
    EXPECT_EQ(verdict(rule("rises", {"a", "b", "c"}), values({{"a", 1.0}, {"b", 2.0}, {"c", 3.0}})), yes);
    EXPECT_EQ(verdict(rule("rises", {"a", "b", "c"}), values({{"a", 1.0}, {"b", 2.0}, {"c", 2.0}})), no);
    EXPECT_EQ(verdict(rule("falls", {"a", "b"}), values({{"a", 2.0}, {"b", 1.0}})), yes);
    EXPECT_EQ(verdict(rule("falls", {"a", "b"}), values({{"a", 1.0}, {"b", 2.0}})), no);
    EXPECT_EQ(verdict(rule("flat", {"a", "b"}, 0.0, 0.1), values({{"a", 10.5}, {"b", 10.0}})), yes);
    EXPECT_EQ(verdict(rule("flat", {"a", "b"}, 0.0, 0.1), values({{"a", 10.0}, {"b", 11.5}})), no);
    const PaperRule crosses = rule("crosses", {"a", "b", "c", "d"});
    EXPECT_EQ(verdict(crosses, values({{"a", 1.0}, {"b", 4.0}, {"c", 2.0}, {"d", 3.0}})), yes);
    EXPECT_EQ(verdict(crosses, values({{"a", 1.0}, {"b", 2.5}, {"c", 2.0}, {"d", 3.0}})), no);
}

TEST(Verdict, OfSeveralRulesNeedsAllOfThem) {
    PaperRule all;
    all.kind = "all";
    all.all = {rule("less", {"a", "b"}), rule("less", {"b", "c"})};
    EXPECT_EQ(verdict(all, values({{"a", 1.0}, {"b", 2.0}, {"c", 3.0}})), yes);
    EXPECT_EQ(verdict(all, values({{"a", 1.0}, {"b", 2.0}, {"c", 1.5}})), no);
    EXPECT_EQ(verdict(all, values({{"a", 1.0}, {"b", 2.0}})), open);
}

TEST(Verdict, IsNotGivenWithoutNumbersOrOnOtherHardware) {
    MeasuredValues missing = values({{"a", 1.0}});
    missing["b"] = {std::nullopt, "the other", "", "step/f.json: cannot read"};
    const VerdictOf none = verdictOf(rule("less", {"a", "b"}), missing, {});
    EXPECT_EQ(none.verdict, open);
    EXPECT_NE(none.why.find("the other is missing: step/f.json"), std::string::npos) << none.why;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(verdict(rule("near", {"a"}, 1.0, 0.1), values({{"a", nan}})), no) << "NaN confirms nothing";
    PaperRule card = rule("at_most", {"a"}, 3.0);
    card.hardware = "GTX 980";
    EXPECT_EQ(verdictOf(card, missing, {"NVIDIA GeForce GTX 980/PCIe", false}).verdict, yes);
    const VerdictOf other = verdictOf(card, missing, {"llvmpipe", true});
    EXPECT_EQ(other.verdict, open);
    EXPECT_EQ(other.why, "stated for GTX 980, drawn on llvmpipe");
    card.hardware = "a GPU";
    EXPECT_EQ(verdictOf(card, missing, {"NVIDIA GeForce GTX 980/PCIe", false}).verdict, yes);
    EXPECT_EQ(verdictOf(card, missing, {"llvmpipe", true}).verdict, open);
    EXPECT_EQ(verdictOf(card, missing, {}).verdict, open);
}

TEST(Verdict, SaysItsRuleWithItsNumbers) {
    PaperRule less = rule("less", {"a", "b"});
    less.by = 0.5;
    EXPECT_EQ(verdictOf(less, values({{"a", 1.0}, {"b", 4.0}}), {}).why,
              "holds: a (1 ms) is less than 0.5 times b (4 ms)");
    EXPECT_EQ(verdictOf(less, values({{"a", 3.0}, {"b", 4.0}}), {}).why,
              "does not hold: a (3 ms) is less than 0.5 times b (4 ms)");
}

TEST(Verdict, RefusesRulesThatItDoesNotKnow) {
    EXPECT_THROW(requireKnownRule(rule("lesser", {"a", "b"})), Error);
    EXPECT_THROW(requireKnownRule(rule("less", {"a"})), Error);
    EXPECT_THROW(requireKnownRule(rule("crosses", {"a", "b", "c", "d", "e"})), Error);
    EXPECT_THROW(requireKnownRule(rule("none", {})), Error);
    EXPECT_NO_THROW(requireKnownRule(rule("less", {"a", "b"})));
}

}  // namespace
}  // namespace timeshade
