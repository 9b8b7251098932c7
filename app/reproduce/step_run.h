#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "reproduce/paper_list.h"

namespace timeshade {

/// A file that a step has written.
struct StepFile {
    std::string name;  ///< relative to the step's folder
    std::uintmax_t bytes = 0;
    std::string sha256;
    bool operator==(const StepFile&) const = default;
};

/// What became of a step. Stands in its folder as step.json, with the command and what the program was.
struct StepRecord {
    std::string name, command, program;
    int exitCode = -1;
    double seconds = 0.0;
    std::string complaint;  ///< the last line that it said to standard error, where it has failed
    std::vector<StepFile> files;

    bool succeeded() const { return exitCode == 0; }
};

/// "timeshade shot rising -o F.png".
std::string commandLineOf(const PaperStep& step);

/// The record of a step that has succeeded in this folder with just this command and program and whose files are all as
/// they were; else one whose exit code is -1. `program` says what draws, binary and shaders included.
StepRecord finishedStep(const PaperStep& step, const std::filesystem::path& folder, const std::string& program);

/// Runs the step in its folder, which is emptied first unless the same command was interrupted there. Throws Error
/// where it cannot be started; a step that fails is in its record. After a stop signal its exit code is -1.
StepRecord runStep(const PaperStep& step, const std::filesystem::path& folder, const std::string& program);

}  // namespace timeshade
