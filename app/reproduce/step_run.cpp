#include "reproduce/step_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/file_bytes.h"
#include "core/one_line.h"
#include "core/sha256.h"
#include "image/image_file.h"
#include "record/stop_signals.h"
#include "reproduce/step_process.h"

namespace timeshade {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* recordName = "step.json";

std::vector<StepFile> filesIn(const fs::path& folder) {
    std::vector<StepFile> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().lexically_relative(folder).string();
        if (!entry.is_regular_file() || name == recordName) continue;
        files.push_back({name, entry.file_size(), toHex(sha256(readFileBytes(entry.path())))});
    }
    std::sort(files.begin(), files.end(), [](const StepFile& a, const StepFile& b) { return a.name < b.name; });
    return files;
}

void writeRecord(const fs::path& folder, const StepRecord& record) {
    Json json{{"step", record.name},          {"command", record.command}, {"program", record.program},
              {"exit_code", record.exitCode}, {"seconds", record.seconds}, {"complaint", record.complaint},
              {"files", Json::array()}};
    for (const StepFile& file : record.files)
        json["files"].push_back({{"name", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
    writeFileAtomically(folder / recordName, json.dump(2) + "\n");
}

/// An empty one where there is none that can be read.
StepRecord readRecord(const fs::path& folder) {
    StepRecord record;
    try {
        const Json json = Json::parse(readFileText(folder / recordName));
        record = {json.at("step"),
                  json.at("command"),
                  json.at("program"),
                  json.at("exit_code"),
                  json.at("seconds"),
                  json.at("complaint"),
                  {}};
        for (const Json& file : json.at("files"))
            record.files.push_back({file.at("name"), file.at("bytes"), file.at("sha256")});
    } catch (const std::exception&) {
        return {};
    }
    return record;
}

}  // namespace

std::string commandLineOf(const PaperStep& step) { return fmt::format("timeshade {}", fmt::join(step.arguments, " ")); }

StepRecord finishedStep(const PaperStep& step, const fs::path& folder, const std::string& program) {
    const StepRecord record = readRecord(folder);
    const bool same = record.succeeded() && record.command == commandLineOf(step) && record.program == program;
    if (!same || filesIn(folder) != record.files) return {};
    return record;
}

StepRecord runStep(const PaperStep& step, const fs::path& folder, const std::string& program) {
    StepRecord record{step.name, commandLineOf(step), program, -1, 0.0, "", {}};
    const StepRecord before = readRecord(folder);
    const bool interrupted =
        before.exitCode == -1 && before.command == record.command && before.program == record.program;
    if (!interrupted) fs::remove_all(folder);
    fs::create_directories(folder);
    writeRecord(folder, record);
    const auto begun = std::chrono::steady_clock::now();
    record.exitCode = runThisProgram(step.arguments, folder);
    if (StopSignals::count() > 0) return record;  // as begun: it goes on next time
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    record.seconds = std::round(10.0 * seconds) / 10.0;
    if (!record.succeeded()) record.complaint = lastLine(readFileText(folder / "complained.txt"), 300);
    record.files = filesIn(folder);
    writeRecord(folder, record);
    return record;
}

}  // namespace timeshade
