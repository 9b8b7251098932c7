// What equal time and equal error say and draw is what was measured.
#include <gtest/gtest.h>

#include <algorithm>

#include "measure/caption_columns.h"
#include "measure/equal_report.h"

namespace timeshade {
namespace {

DisplayImage plain(int width, int height, std::uint8_t level) {
    DisplayImage image{width, height, {}};
    image.rgb.assign(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), level);
    return image;
}

EqualRow makeRow(const std::string& technique, int sampleCount, double milliseconds, double error) {
    EqualRow row;
    row.technique = technique;
    row.sampleCount = sampleCount;
    row.steady = {milliseconds, milliseconds - 1.0, milliseconds + 1.0};
    row.firstMilliseconds = 35.0;
    row.shadowError.rms = error;
    row.shadowError.standardError = 0.001;
    row.wrongPpm = 123.0;
    row.picture = plain(40, 30, 100);
    return row;
}

EqualRow levelRow(EqualFind find, double milliseconds, double error) {
    EqualRow row = makeRow("other", find.chosen.sampleCount, milliseconds, error);
    row.find = find;
    return row;
}

const EqualRow first = makeRow("simple", 8, 35.0, 0.04);

std::string saidOf(EqualLevel level, const EqualFind& find, double milliseconds, double error) {
    return verdictOf(levelRow(find, milliseconds, error), level, first);
}

TEST(EqualReport, VerdictsOfTime) {
    const EqualTrial four{4, 31.2 / 35.0}, five{5, 39.0 / 35.0};
    EXPECT_EQ(saidOf(EqualLevel::Time, {{5, 35.7 / 35.0}, true, four, EqualTrial{5, 35.7 / 35.0}}, 35.7, 0.02),
              "equal: 35.7 ms against 35.0 ms (2.0 % more)");
    EXPECT_EQ(saidOf(EqualLevel::Time, {five, false, four, five}, 39.0, 0.02),
              "could not: 4 spp 31.2 ms, 5 spp 39.0 ms against 35.0 ms");
    EXPECT_EQ(saidOf(EqualLevel::Time, {{32, 20.0 / 35.0}, false, EqualTrial{32, 20.0 / 35.0}, {}}, 20.0, 0.02),
              "could not: 32 spp 20.0 ms, the most, against 35.0 ms");
    EXPECT_EQ(saidOf(EqualLevel::Time, {{1, 50.0 / 35.0}, false, {}, EqualTrial{1, 50.0 / 35.0}}, 50.0, 0.02),
              "could not: 1 spp 50.0 ms, the fewest, against 35.0 ms");
    EXPECT_EQ(verdictOf(first, EqualLevel::Time, first), "");
}

TEST(EqualReport, VerdictsOfError) {
    const EqualTrial three{3, 0.05 / 0.04}, four{4, 0.039 / 0.04}, five{5, 0.03 / 0.04};
    EXPECT_EQ(saidOf(EqualLevel::Error, {four, true, three, four}, 20.0, 0.039),
              "equal: 0.03900 against 0.04000 (2.5 % less)");
    EXPECT_EQ(saidOf(EqualLevel::Error, {five, true, three, five}, 20.0, 0.03),
              "less: 0.03000 against 0.04000 (25.0 % less); 3 spp 0.05000");
    EXPECT_EQ(saidOf(EqualLevel::Error, {{1, 0.5}, true, {}, EqualTrial{1, 0.5}}, 20.0, 0.02),
              "less: 0.02000 against 0.04000 (50.0 % less), the fewest samples");
    EXPECT_EQ(saidOf(EqualLevel::Error, {{32, 2.0}, false, EqualTrial{32, 2.0}, {}}, 20.0, 0.08),
              "could not: 32 spp come nearest with 0.08000 against 0.04000");
}

TEST(EqualReport, BruteForceCountsRenders) {
    EqualRow row = levelRow({{5, 1.2}, false, EqualTrial{4, 0.8}, EqualTrial{5, 1.2}}, 42.0, 0.02);
    row.bruteForce = true;
    EXPECT_EQ(verdictOf(row, EqualLevel::Time, first),
              "could not: 4 renders 28.0 ms, 5 renders 42.0 ms against 35.0 ms");
    const std::string csv = equalCsv({{"scene", {first, row}, plain(40, 30, 90), 64}}, EqualLevel::Time);
    EXPECT_NE(csv.find("\n\"scene\",\"simple\",8,,512,35,34,36,35,0.04,0.001,64,123,0,0,time,,,\n"), std::string::npos)
        << csv;
    EXPECT_NE(csv.find("\n\"scene\",\"other\",,5,512,42,41,43,35,0.02,0.001,64,123,0,0,time,1.2,no,\"could not: "),
              std::string::npos)
        << csv;
}

TEST(EqualReport, APictureHasAColumnForEachAndForTheReference) {
    EqualScene scene{
        "scene", {first, levelRow({{5, 1.0}, true, {}, EqualTrial{5, 1.0}}, 35.0, 0.02)}, plain(40, 30, 90), 64};
    scene.rows[1].picture = plain(40, 30, 200);
    const DisplayImage picture = equalPicture(scene, true);
    const int column = 40 * 7;  // the least factor with room for words
    EXPECT_EQ(picture.width, 3 * column + 2 * 6);
    EXPECT_GT(picture.height, 30 * 7 + column);
    const auto at = [&](int x, int y) {
        return picture.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                static_cast<std::size_t>(x))];
    };
    const int detail = 30 * 7 + 6 + 20;
    for (const auto& [left, level] : {std::pair{0, 100}, {column + 6, 200}, {2 * (column + 6), 90}}) {
        EXPECT_EQ(at(left + column - 1, 30 * 7 - 1), level);
        EXPECT_EQ(at(left + 10, detail), level);
    }
    EXPECT_EQ(picture.rgb, equalPicture(scene, true).rgb);
    EXPECT_NE(picture.rgb, equalPicture(scene, false).rgb) << "whose milliseconds they are";
}

TEST(CaptionColumns, TheDetailIsTheSquareMagnified) {
    DisplayImage picture = plain(300, 200, 50);
    const PixelSquare square{100, 80, 50};
    for (int y = 0; y < square.side; ++y)
        for (int x = 0; x < square.side; ++x)
            picture.rgb[3 * (static_cast<std::size_t>(square.y + y) * 300 + static_cast<std::size_t>(square.x + x))] =
                static_cast<std::uint8_t>(x + 4 * y);
    const DisplayImage whole = captionColumns({{picture, "A", {}}}, square);
    EXPECT_EQ(whole.width, 300);
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 300; ++x)
            ASSERT_EQ(whole.rgb[3 * (static_cast<std::size_t>(206 + y) * 300 + static_cast<std::size_t>(x))],
                      static_cast<std::uint8_t>(x / 6 + 4 * (y / 6)));
}

TEST(CaptionColumns, OnePixelAndLongWordsHaveRoom) {
    const std::string longest(500, 'w');
    const DisplayImage whole = captionColumns(
        {{plain(1, 1, 9), longest, {longest, longest + " and more"}}, {plain(1, 1, 9), "", {}}}, {0, 0, 1});
    EXPECT_EQ(whole.width, 2 * 256 + 6);
    EXPECT_EQ(whole.rgb.size(), 3 * static_cast<std::size_t>(whole.width) * static_cast<std::size_t>(whole.height));
}

}  // namespace
}  // namespace timeshade
