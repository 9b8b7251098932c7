#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace timeshade {

/// One command line of this program, without its name. Its outputs lie in a folder of the step's name.
struct PaperStep {
    std::string name;
    std::vector<std::string> arguments;
    double seconds = 10.0;  ///< about how long it takes on two cores without a GPU; for the time left
};

enum class FigureKind { Reproduced, Drawing, NotPossible };

/// A PNG that a step writes: "STEP/FILE.png".
struct PaperPicture {
    std::string file, caption;
};

/// Two pictures of the same thing, to be wiped over each other.
struct PaperPair {
    PaperPicture left, right;
};

/// Cells are text, or the value that is named behind "=".
struct PaperTable {
    std::string caption;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

/// Curves of columns of a CSV file, a curve for each value of the column `by`.
struct PaperChart {
    std::string caption, xLabel, yLabel, file, x, y, by;
    std::map<std::string, std::string> where;  ///< column and its value
    std::map<std::string, std::string> names;  ///< of curves, by the value of `by`
    double scale = 1.0;                        ///< of y
};

/// Where a number stands: a place in a JSON file, a column of the one row of a CSV file that fits, or a sum.
struct PaperValue {
    std::string name, label, unit;
    std::string file;
    std::string at;                                   ///< of JSON: "/shadow_error/rms", "/figures/name=ranges"
    std::string column;                               ///< of CSV
    std::map<std::string, std::string> where;         ///< of CSV: column and its value
    std::vector<std::pair<std::string, double>> sum;  ///< instead: values times factors ...
    std::pair<std::string, std::string> quotient;     ///< instead: one value divided by another
    double plus = 0.0, scale = 1.0;                   ///< is added; then all is multiplied
};

/// How a verdict follows from values. See verdictOf().
struct PaperRule {
    std::string kind;
    std::vector<std::string> of;  ///< names of values
    double by = 1.0, expected = 0.0, within = 0.0;
    double clear = 0.0;          ///< share by which two values must differ to be told apart
    std::string hardware;        ///< part of the name of the device that the rule is of, or "a GPU"
    std::string why;             ///< of the kind "none": what there is nothing to compare with
    std::vector<PaperRule> all;  ///< of the kind "all"
};

/// What a paper says, in our words.
struct PaperClaim {
    std::string says;
    std::string stands;              ///< where
    std::string number;              ///< the paper's own, with its unit and hardware; empty where it has none
    std::string picture;             ///< "STEP/FILE.png" that shows ours; may be empty
    std::vector<std::string> shown;  ///< values that are ours
    PaperRule rule;
};

struct PaperFigure {
    std::string number;   ///< as the paper has it: "4.1"; or "section 4.2" for numbers in its text
    std::string caption;  ///< in our words
    FigureKind kind = FigureKind::Drawing;
    std::string reason;  ///< why it is not redrawn; of NotPossible
    std::string note;    ///< what differs from the paper
    std::vector<PaperStep> steps;
    std::vector<PaperPicture> pictures;
    std::vector<PaperPair> pairs;
    std::vector<PaperTable> tables;
    std::vector<PaperChart> charts;
    std::vector<PaperValue> values;
    std::vector<PaperClaim> claims;

    bool isNumbered() const { return !number.starts_with("section"); }
};

/// The declared figures of one paper.
struct PaperList {
    std::string name, authors, title, venue, hardware;
    int year = 0;
    std::vector<PaperFigure> figures;
};

/// Names of the lists in the data folder, sorted.
std::vector<std::string> paperNames();

/// Reads the list of that name, with its words for the full or the quick form filled in. Throws UsageError for a name
/// without a list, Error that names the file for one that is broken: unknown keys, values or files that no step of the
/// figure could write, rules of no known kind.
PaperList readPaperList(const std::string& name, bool quick);

/// The same of a text; `place` names it in errors.
PaperList paperListOf(const std::string& text, const std::string& place, bool quick);

}  // namespace timeshade
