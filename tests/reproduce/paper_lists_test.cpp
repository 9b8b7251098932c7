// Every figure of the five papers has an entry, and every command in the lists is one that the program takes.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "options/command.h"
#include "reproduce/paper_list.h"
#include "reproduce/paper_result.h"

namespace timeshade {
namespace {

/// As counted in the papers, none of which has a numbered table.
const std::map<std::string, std::vector<std::string>>& numbersOfFigures() {
    static const std::map<std::string, std::vector<std::string>> numbers{
        {"andersson2015", {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14", "15"}},
        {"hong2017", {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12"}},
        {"hong2019", {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12"}},
        {"palmer", {"1.1", "1.2", "2.1", "2.2", "2.3", "2.4", "2.5", "2.6", "4.1", "4.2", "4.3", "4.4", "4.5", "5.1"}},
        {"scherzer2007", {"1", "2", "3", "4", "5", "6"}},
    };
    return numbers;
}

TEST(PaperLists, AreThoseOfTheFivePapers) {
    std::vector<std::string> names;
    for (const auto& [name, numbers] : numbersOfFigures()) names.push_back(name);
    EXPECT_EQ(paperNames(), names);
}

TEST(PaperLists, HaveEveryFigureOnceWithPicturesOrAReason) {
    std::size_t count = 0;
    for (const auto& [name, numbers] : numbersOfFigures()) {
        std::vector<std::string> found;
        for (const PaperFigure& figure : readPaperList(name, true).figures) {
            if (figure.isNumbered()) found.push_back(figure.number);
            EXPECT_FALSE(figure.caption.empty()) << name << " " << figure.number;
            if (figure.kind == FigureKind::Reproduced) {
                EXPECT_FALSE(figure.pictures.empty() && figure.pairs.empty() && figure.charts.empty() &&
                             figure.tables.empty())
                    << name << " " << figure.number << ": reproduced, and shows nothing";
            }
        }
        EXPECT_EQ(found, numbers) << name;
        count += found.size();
    }
    EXPECT_EQ(count, 59u);
}

TEST(PaperLists, GiveEveryFigureAFolderOfItsOwn) {
    for (const auto& [name, numbers] : numbersOfFigures()) {
        std::set<std::string> folders;
        const PaperList list = readPaperList(name, false);
        for (const PaperFigure& figure : list.figures) folders.insert(folderOf(figure));
        EXPECT_EQ(folders.size(), list.figures.size()) << name;
    }
}

TEST(PaperLists, HoldCommandLinesThatTheProgramTakes) {
    for (const bool quick : {false, true})
        for (const auto& [name, numbers] : numbersOfFigures())
            for (const PaperFigure& figure : readPaperList(name, quick).figures)
                for (const PaperStep& step : figure.steps) {
                    const std::string place = name + " " + figure.number + " " + step.name;
                    EXPECT_NO_THROW(parseArguments(step.arguments)) << place;
                    for (const std::string& word : step.arguments)
                        EXPECT_EQ(word.find_first_of("{}"), std::string::npos) << place << ": " << word;
                }
}

TEST(PaperLists, AreSmallerInTheQuickForm) {
    for (const auto& [name, numbers] : numbersOfFigures()) {
        const PaperList full = readPaperList(name, false), quick = readPaperList(name, true);
        ASSERT_EQ(full.figures.size(), quick.figures.size());
        std::size_t differ = 0;
        for (std::size_t i = 0; i < full.figures.size(); ++i) {
            ASSERT_EQ(full.figures[i].steps.size(), quick.figures[i].steps.size());
            for (std::size_t k = 0; k < full.figures[i].steps.size(); ++k)
                differ += full.figures[i].steps[k].arguments != quick.figures[i].steps[k].arguments;
        }
        EXPECT_GT(differ, 0u) << name;
    }
}

std::string listWith(const std::string& figure) {
    return R"({"name": "x", "authors": "a", "title": "t", "year": 2000, "forms": {"size": ["big", "small"]},
               "figures": [)" +
           figure + "]}";
}

std::string complaintAbout(const std::string& figure) {
    try {
        paperListOf(listWith(figure), "x.json", true);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(PaperLists, RepeatWhatVariesAndFillInTheForm) {
    const PaperList list = paperListOf(listWith(R"({"figure": "1", "status": "reproduced", "caption": "c",
        "variants": {"a": {"label": "A", "t": "one"}, "b": {"label": "B", "t": "two"}},
        "steps": {"s_{variant}": "shot {t} --size {size}"},
        "values": {"v_{variant}": {"label": "{label}", "file": "s_{variant}/f.json", "at": "/x"}},
        "tables": [{"columns": ["", "v"], "rows": [["{label}", "=v_{variant}"]]}],
        "claims": [{"says": "c", "rule": {"test": "less", "of": ["v_{variant}"]}}]})"),
                                       "x.json", true);
    const PaperFigure& figure = list.figures.front();
    ASSERT_EQ(figure.steps.size(), 2u);
    EXPECT_EQ(figure.steps[1].name, "s_b");
    EXPECT_EQ(figure.steps[1].arguments, (std::vector<std::string>{"shot", "two", "--size", "small"}));
    ASSERT_EQ(figure.tables.front().rows.size(), 2u);
    EXPECT_EQ(figure.tables.front().rows[0], (std::vector<std::string>{"A", "=v_a"}));
    EXPECT_EQ(figure.claims.front().rule.of, (std::vector<std::string>{"v_a", "v_b"}));
}

TEST(PaperLists, AreRefusedWhereTheyAreNotWhole) {
    const std::string head = R"({"figure": "7", "caption": "c", "status": )";
    EXPECT_NE(complaintAbout(head + R"("sculpture"})").find("'sculpture' found"), std::string::npos);
    EXPECT_NE(complaintAbout(head + R"("drawing", "captoin": "c"})").find("'captoin' found"), std::string::npos);
    EXPECT_NE(complaintAbout(head + R"("reproduced"})").find("no steps"), std::string::npos);
    EXPECT_NE(complaintAbout(head + R"("not possible"})").find("expected a reason"), std::string::npos);
    const std::string steps = head + R"("reproduced", "steps": {"s": "list"}, )";
    EXPECT_NE(complaintAbout(steps + R"("pictures": [{"file": "t/f.png"}]})").find("'t/f.png' found"),
              std::string::npos);
    EXPECT_NE(complaintAbout(steps + R"("claims": [{"says": "", "rule": {"test": "less", "of": ["a", "b"]}}]})")
                  .find("'a' is named and not declared"),
              std::string::npos);
    EXPECT_NE(complaintAbout(steps + R"("claims": [{"says": "", "rule": {"test": "feels right"}}]})")
                  .find("'feels right' found"),
              std::string::npos);
    EXPECT_NE(complaintAbout(steps + R"("pictures": []})"), complaintAbout(head + R"("reproduced"})"));
    EXPECT_EQ(complaintAbout(steps + R"("pictures": []})"), "");
}

}  // namespace
}  // namespace timeshade
