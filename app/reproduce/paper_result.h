#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reproduce/figure_values.h"
#include "reproduce/paper_list.h"
#include "reproduce/step_run.h"
#include "reproduce/verdict.h"

namespace timeshade {

struct DrawnChart {
    std::string file;     ///< "chart-1.png"; empty for one that could not be drawn
    std::string missing;  ///< why not
};

/// What has come of one figure.
struct FigureResult {
    PaperFigure figure;
    std::vector<StepRecord> steps;
    MeasuredValues values;
    std::vector<VerdictOf> verdicts;  ///< of the figure's claims
    std::vector<DrawnChart> charts;   ///< of the figure's charts
    std::string folder;               ///< relative to the paper's

    /// A step has failed, or a chart could not be drawn.
    bool failed() const;
};

/// What has come of a paper; all that its reports are made of, so that equal results make equal bytes.
struct PaperResult {
    PaperList list;  ///< all figures, also those that were not asked for
    std::vector<FigureResult> figures;
    std::filesystem::path folder;
    std::string commit, command;
    bool quick = false;
    UsedDevice device;

    bool failed() const;
    double seconds() const;  ///< of all steps, whenever they ran
    int count(Verdict verdict) const;
};

/// "4.1" and "section-4.2": the figure's folder.
std::string folderOf(const PaperFigure& figure);

/// "Figure 4.1" and "Section 4.2".
std::string titleOf(const PaperFigure& figure);

/// Values, verdicts and charts of a figure whose steps have run; charts are written into its folder.
FigureResult figureResult(const PaperFigure& figure, std::vector<StepRecord> steps, const std::filesystem::path& paper,
                          const UsedDevice& device);

/// What the cell of a table holds: the value that it names, or its own text.
std::string cellText(const std::string& cell, const MeasuredValues& values);

/// "rules: name 1.2 ms, other 3 ms".
std::string shownValues(const PaperClaim& claim, const MeasuredValues& values);

/// Of the device, in words, with a warning for a software renderer.
std::string deviceInWords(const UsedDevice& device);

}  // namespace timeshade
