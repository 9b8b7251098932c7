#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace timeshade::detail {

/// A value as text; "?" for a type that has none.
template <class T>
std::string checkedValue(const T& value) {
    if constexpr (std::is_enum_v<T>)
        return fmt::format("{}", static_cast<long long>(value));
    else if constexpr (fmt::is_formattable<T>::value)
        return fmt::format("{}", value);
    else
        return "?";
}

/// Prints "FILE:LINE: check failed: EXPRESSION (VALUES)" on standard error and aborts.
[[noreturn]] void failCheck(const char* file, int line, const char* expression, const std::string& values);

/// Compares numbers by value: a negative one is less than any unsigned one. NaN satisfies no comparison but "!=".
template <class Compare, class A, class B>
void checkCompare(const A& left, const B& right, const char* expression, const char* file, int line) {
    constexpr bool whole = std::is_integral_v<A> && std::is_integral_v<B> && !std::is_same_v<A, bool> &&
                           !std::is_same_v<B, bool> && !std::is_same_v<A, char> && !std::is_same_v<B, char>;
    bool holds = false;
    if constexpr (whole)
        holds = Compare::ofIntegers(left, right);
    else
        holds = Compare::ofOthers(left, right);
    if (!holds) [[unlikely]]
        failCheck(file, line, expression, checkedValue(left) + " and " + checkedValue(right));
}

#define TIMESHADE_COMPARISON(name, integers, others)            \
    struct name {                                               \
        template <class A, class B>                             \
        static bool ofIntegers(const A& left, const B& right) { \
            return integers(left, right);                       \
        }                                                       \
        template <class A, class B>                             \
        static bool ofOthers(const A& left, const B& right) {   \
            return others{}(left, right);                       \
        }                                                       \
    };
TIMESHADE_COMPARISON(Equal, std::cmp_equal, std::equal_to<>)
TIMESHADE_COMPARISON(NotEqual, std::cmp_not_equal, std::not_equal_to<>)
TIMESHADE_COMPARISON(Less, std::cmp_less, std::less<>)
TIMESHADE_COMPARISON(LessEqual, std::cmp_less_equal, std::less_equal<>)
TIMESHADE_COMPARISON(Greater, std::cmp_greater, std::greater<>)
TIMESHADE_COMPARISON(GreaterEqual, std::cmp_greater_equal, std::greater_equal<>)
#undef TIMESHADE_COMPARISON

}  // namespace timeshade::detail

/// Checks of what only a mistake in this program can break: a caller outside a function's contract, an index out of
/// range. In every build. A failure prints the expression, both values, file and line, and aborts. What a user, a file,
/// a shader or a driver can cause is an exception (core/error.h) and never a check. Arguments are evaluated once.
#define CHECK(condition)                                                             \
    do {                                                                             \
        if (!(condition)) [[unlikely]]                                               \
            ::timeshade::detail::failCheck(__FILE__, __LINE__, #condition, "false"); \
    } while (false)

#define TIMESHADE_CHECK_COMPARE(compare, left, sign, right)                                                           \
    ::timeshade::detail::checkCompare<::timeshade::detail::compare>(left, right, #left " " sign " " #right, __FILE__, \
                                                                    __LINE__)

#define CHECK_EQ(left, right) TIMESHADE_CHECK_COMPARE(Equal, left, "==", right)
#define CHECK_NE(left, right) TIMESHADE_CHECK_COMPARE(NotEqual, left, "!=", right)
#define CHECK_LT(left, right) TIMESHADE_CHECK_COMPARE(Less, left, "<", right)
#define CHECK_LE(left, right) TIMESHADE_CHECK_COMPARE(LessEqual, left, "<=", right)
#define CHECK_GT(left, right) TIMESHADE_CHECK_COMPARE(Greater, left, ">", right)
#define CHECK_GE(left, right) TIMESHADE_CHECK_COMPARE(GreaterEqual, left, ">=", right)
