// How the window cuts long work into slices, how coarsely it draws meanwhile, and what it undoes: without a window.

#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "core/pause.h"
#include "core/work_part.h"
#include "image/image_file.h"
#include "window/free_name.h"
#include "window/preview_quality.h"
#include "window/slices.h"
#include "window/undo_history.h"

namespace timeshade {
namespace {

TEST(PreviewQuality, LowersTheMapLastOfAll) {
    PreviewQuality quality(true);
    FrameRequest full;
    full.width = full.height = 1000;
    FrameRequest before = full;
    for (int level = 0; level < PreviewQuality::levels; ++level) {
        const FrameRequest drawn = quality.reduced(full, level);
        EXPECT_LE(drawn.width, before.width);
        EXPECT_LE(drawn.samplesPerPixel, before.samplesPerPixel);
        if (drawn.mapSize != full.mapSize) {
            EXPECT_LE(drawn.width, 200) << "pixels go before texels";
            EXPECT_LT(drawn.samplesPerPixel, full.samplesPerPixel);
        }
        before = drawn;
    }
    EXPECT_LT(before.mapSize.width, full.mapSize.width);
    full.mapSize = 8192;
    EXPECT_EQ(quality.reduced(full, 0).mapSize, 8192);
    EXPECT_LE(quality.reduced(full, 1).mapSize.width, 2048) << "no preview needs more";
}

TEST(PreviewQuality, DoesAsItsChoiceSays) {
    PreviewQuality quality(true);
    EXPECT_GT(quality.level(), 0);
    quality.setChoice(PreviewQuality::Choice::Full);
    EXPECT_EQ(quality.level(), 0);
    quality.setChoice(PreviewQuality::Choice::Coarse);
    for (int i = 0; i < 100; ++i) quality.measured(quality.level(), 1.0);
    EXPECT_GT(quality.level(), 0) << "however fast";
    for (const auto choice :
         {PreviewQuality::Choice::Full, PreviewQuality::Choice::Automatic, PreviewQuality::Choice::Coarse})
        EXPECT_EQ(previewOf(nameOf(choice)), choice);
    EXPECT_FALSE(previewOf("fine"));
}

/// Work of so many pause points. How many it has come past.
int workOf(int points) {
    int passed = 0;
    for (; passed < points; ++passed) pausePoint();
    return passed;
}

TEST(Slices, TheWindowDrawsBetweenThem) {
    int drawn = 0;
    Slices slices([&] { ++drawn; }, [] { return false; }, std::chrono::milliseconds(0));
    {
        const Slices::Work work(slices);
        EXPECT_EQ(workOf(7), 7);
    }
    EXPECT_EQ(drawn, 7);
    EXPECT_EQ(slices.ended(), 7);
    EXPECT_EQ(workOf(7), 7);
    EXPECT_EQ(drawn, 7) << "nothing pauses outside";
}

TEST(Slices, WhatIsUnwantedEndsWithItsSlice) {
    int drawn = 0;
    Slices slices([&] { ++drawn; }, [&] { return drawn == 3; }, std::chrono::milliseconds(0));
    const Slices::Work work(slices);
    EXPECT_THROW(workOf(7), WorkCancelled);
    EXPECT_EQ(drawn, 3);
    EXPECT_EQ(slices.cancelled(), 1);
}

TEST(Slices, NothingPausesWithinAPause) {
    int depth = 0;
    Slices slices(
        [&] {
            EXPECT_EQ(++depth, 1);
            pausePoint();
            --depth;
        },
        [] { return false; }, std::chrono::milliseconds(0));
    const Slices::Work work(slices);
    workOf(2);
    const NoPauses whole;
    workOf(2);
    EXPECT_EQ(slices.ended(), 2);
}

TEST(WorkPart, NestedLoopsTellHowFarTheyAre) {
    std::vector<double> done;
    {
        const WorkPart half(0.0, 0.5);
        for (int i = 0; i < 2; ++i) {
            const WorkPart part = workPart(i, 2);
            done.push_back(workDone());
        }
    }
    done.push_back(workDone());
    const WorkPart rest(0.5, 1.0);
    done.push_back(workDone());
    EXPECT_EQ(done, (std::vector<double>{0.0, 0.25, 0.5, 0.5}));
}

TEST(UndoHistory, IsBoundedAndForgetsWhatWasUndone) {
    UndoHistory<int> history;
    EXPECT_FALSE(history.undo());
    const int steps = static_cast<int>(UndoHistory<int>::most) + 50;
    for (int i = 0; i <= steps; ++i) history.keep(i);
    history.keep(steps);
    EXPECT_EQ(history.undoable(), UndoHistory<int>::most) << "what is the same is no step";
    EXPECT_EQ(history.undo(), steps - 1);
    EXPECT_EQ(history.undo(), steps - 2);
    EXPECT_EQ(history.redo(), steps - 1);
    history.keep(-1);
    EXPECT_FALSE(history.redo());
    EXPECT_EQ(history.undo(), steps - 1);
    int last = 0;
    while (const std::optional<int> before = history.undo()) last = *before;
    EXPECT_EQ(last, 50);
}

TEST(FreeName, IsNumberedWhereThereIsOne) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "timeshade-free-name-test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const std::filesystem::path path = folder / "a.b.png";
    EXPECT_EQ(freeName(path), path);
    writeFileAtomically(path, "1");
    EXPECT_EQ(freeName(path), folder / "a.b-2.png");
    std::filesystem::create_symlink(folder / "nowhere", folder / "a.b-2.png");
    EXPECT_EQ(freeName(path), folder / "a.b-3.png");
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace timeshade
