#pragma once

#include <string>

#include <gtest/gtest.h>

#include "support/thorough.h"

namespace timeshade {

/// A suite with three values or more, of which each test is as a rule drawn for every third, others than a test whose
/// name is one letter longer; for every second in thorough tests, for all where TIMESHADE_TESTS=all.
template <typename Value>
class DrawnHere : public testing::TestWithParam<Value> {
  protected:
    void SetUp() override {
        const testing::UnitTest& all = *testing::UnitTest::GetInstance();
        const testing::TestSuite& suite = *all.current_test_suite();
        const std::string name = all.current_test_info()->name(), test = name.substr(0, name.find('/') + 1);
        std::size_t number = test.size();
        for (int i = 0; suite.GetTestInfo(i)->name() != name; ++i)
            if (std::string(suite.GetTestInfo(i)->name()).rfind(test, 0) == 0) ++number;
        if (!isDrawn(number)) GTEST_SKIP() << "drawn where TIMESHADE_TESTS=all";
    }
};

}  // namespace timeshade
