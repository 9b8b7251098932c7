#include "reproduce/paper_run.h"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "record/stop_signals.h"
#include "standard_error.h"

namespace timeshade {

namespace {

/// Steps done and to be done, and from both how long the rest may take.
class TimeLeft {
  public:
    explicit TimeLeft(const std::vector<PaperFigure>& figures) {
        for (const PaperFigure& figure : figures)
            for (const PaperStep& step : figure.steps) {
                ++steps_;
                expected_ += step.seconds;
            }
    }
    /// On a terminal, what runs now.
    void show(const PaperList& list, const PaperFigure& figure, const PaperStep& step) const {
        if (isatty(STDERR_FILENO) != 1) return;
        const double pace = spent_ > 5.0 ? spent_ / expectedOfSpent_ : 1.0;
        writeToStandardError(fmt::format("\r\033[Ktimeshade: {} {}, {}: step {} of {}, about {:.0f} min left",
                                         list.name, titleOf(figure), step.name, done_ + 1, steps_,
                                         (expected_ - expectedDone_) * pace / 60.0));
    }
    void count(const PaperStep& step, double seconds, bool fresh) {
        ++done_;
        expectedDone_ += step.seconds;
        if (!fresh) return;
        spent_ += seconds;
        expectedOfSpent_ += step.seconds;
    }
    std::string place() const { return fmt::format("{}/{}", done_, steps_); }

  private:
    int steps_ = 0, done_ = 0;
    double expected_ = 0.0, expectedDone_ = 0.0, expectedOfSpent_ = 0.0, spent_ = 0.0;
};

std::string lineFor(const StepRecord& record, bool fresh) {
    if (!record.succeeded()) return fmt::format("failed with exit code {}: {}", record.exitCode, record.complaint);
    return fmt::format("{} ({:.1f} s)", fresh ? "done" : "was done", record.seconds);
}

/// Records of the figure's steps; fewer after a stop signal.
std::vector<StepRecord> runSteps(const PaperRequest& request, const PaperFigure& figure, TimeLeft& time) {
    std::vector<StepRecord> records;
    for (const PaperStep& step : figure.steps) {
        const std::filesystem::path folder = request.folder / folderOf(figure) / step.name;
        StepRecord record = finishedStep(step, folder, request.program);
        const bool fresh = !record.succeeded();
        if (fresh) {
            time.show(request.list, figure, step);
            record = runStep(step, folder, request.program);
            if (StopSignals::count() > 0) return records;
        }
        time.count(step, record.seconds, fresh);
        if (isatty(STDERR_FILENO) == 1) writeToStandardError("\r\033[K");
        fmt::print("{} {} {}, {}: {}\n", time.place(), request.list.name, titleOf(figure), step.name,
                   lineFor(record, fresh));
        std::fflush(stdout);
        records.push_back(std::move(record));
    }
    return records;
}

}  // namespace

PaperResult runPaper(const PaperRequest& request) {
    PaperResult result{request.list, {}, request.folder, request.commit, request.command, request.quick, {}};
    TimeLeft time(request.figures);
    std::vector<std::vector<StepRecord>> records;
    for (const PaperFigure& figure : request.figures) {
        std::vector<StepRecord> of = runSteps(request, figure, time);
        if (StopSignals::count() > 0) break;
        records.push_back(std::move(of));
    }
    for (std::size_t i = 0; i < records.size() && result.device.name.empty(); ++i)
        result.device = deviceIn(request.folder / folderOf(request.figures[i]));
    for (std::size_t i = 0; i < records.size(); ++i)
        result.figures.push_back(
            figureResult(request.figures[i], std::move(records[i]), request.folder, result.device));
    return result;
}

}  // namespace timeshade
