// Counts that are read later: lists that do not fit are empty, which is told, and nothing waits.
#include <span>

#include <gtest/gtest.h>

#include "gl/read_back.h"
#include "passes/cell_lists.h"
#include "shared/frame_blocks.shared.h"
#include "support/gl_environment.h"

namespace timeshade {
namespace {

using Reading = gl::LateCounts::Reading;
using State = gl::LateCounts::State;

/// Cell c has c % 7 entries, times `factor`.
class CountedLists {
  public:
    static constexpr std::size_t cells = 3000;

    CountedLists() : lists_(sharedRenderer().programs()) {}

    /// The room that scan() asked for.
    std::size_t scan(gl::LateCounts& counts, GLuint factor) {
        std::vector<GLuint> numbers(cells);
        for (GLuint cell = 0; cell < cells; ++cell) numbers[cell] = cell % 7 * factor;
        lists_.beginCount(cells);
        GLint cursors = 0;
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, LIST_CURSORS_BINDING, &cursors);
        glNamedBufferSubData(static_cast<GLuint>(cursors), 0, cells * sizeof(GLuint), numbers.data());
        return lists_.scan(counts, [](std::size_t room) { return room; });
    }
    std::size_t total() const { return lists_.total(); }
    std::size_t longest(gl::LateCounts& counts) {
        return lists_.longest(counts, [](std::size_t room) { return room; });
    }
    std::vector<GLuint> offsets() const { return gl::readElements<GLuint>(lists_.offsetsBuffer(), 0, cells + 1); }

  private:
    CellLists lists_;
};

constexpr std::size_t entriesOfOne = 8994;  // sum of c % 7 over 3000 cells

TEST(LateCounts, CostNoWaitAndFitWhereListsStayAsLongAsTheyWere) {
    CountedLists lists;
    gl::LateCounts counts;
    counts.begin(Reading::Later);
    EXPECT_EQ(lists.scan(counts, 1), entriesOfOne) << "nothing is known of them yet";
    EXPECT_EQ(lists.longest(counts), 6u);
    EXPECT_EQ(counts.state(), State::Sufficed);
    const std::uint64_t before = gl::waitsSoFar();
    counts.begin(Reading::Later);
    EXPECT_GE(lists.scan(counts, 1), entriesOfOne);
    EXPECT_GE(lists.longest(counts), 6u);
    EXPECT_EQ(counts.state(), State::Pending) << "not told all yet";
    counts.end();
    EXPECT_EQ(gl::waitsSoFar(), before);
    EXPECT_EQ(counts.settle(), State::Sufficed);
    EXPECT_EQ(lists.total(), entriesOfOne);
}

TEST(LateCounts, OfListsWithoutRoomAreToldAndLeaveThemEmpty) {
    CountedLists lists;
    gl::LateCounts counts;
    counts.begin(Reading::Later);
    lists.scan(counts, 1);
    counts.begin(Reading::Later);
    EXPECT_LT(lists.scan(counts, 10), 10 * entriesOfOne);
    counts.end();
    EXPECT_EQ(counts.settle(), State::TooMany);
    for (const GLuint offset : lists.offsets()) ASSERT_EQ(offset, 0u);
    GLuint cursor = 0;
    glGetNamedBufferSubData(
        [] {
            GLint name = 0;
            glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, LIST_CURSORS_BINDING, &name);
            return static_cast<GLuint>(name);
        }(),
        0, sizeof cursor, &cursor);
    EXPECT_EQ(cursor, NO_LIST_SLOT);
    counts.begin(Reading::Later);
    EXPECT_FALSE(counts.later()) << "the same frame once more";
    EXPECT_EQ(lists.scan(counts, 10), 10 * entriesOfOne);
    EXPECT_EQ(lists.offsets().back(), 10 * entriesOfOne);
    counts.begin(Reading::Later);
    EXPECT_TRUE(counts.later());
    EXPECT_GE(lists.scan(counts, 10), 10 * entriesOfOne);
}

TEST(ForeseenCount, MakesRoomForMoreThanThereWasAndSeldomAnew) {
    gl::ForeseenCount count;
    EXPECT_FALSE(count.known());
    std::size_t held = 0;
    int made = 0;
    const auto make = [&](std::size_t wanted) {
        if (wanted > held) {
            held = wanted;
            ++made;
        }
        return held;
    };
    for (std::size_t found = 100000; found < 160000; found += 1000) {
        count.note(found);
        EXPECT_GE(count.makeRoom(make), found + found / 8);
    }
    EXPECT_LE(made, 3);
    count.forget();
    EXPECT_FALSE(count.known());
}

}  // namespace
}  // namespace timeshade
