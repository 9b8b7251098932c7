#include "reproduce/step_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <timeshade/commit.h>  // generated
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/file_bytes.h"
#include "core/one_line.h"
#include "core/sha256.h"
#include "gl/shader_source.h"
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
        const std::vector<unsigned char> bytes = readFileBytes(folder / recordName);
        const Json json = Json::parse(bytes.begin(), bytes.end());
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

std::string lastLineOf(const fs::path& path) {
    const std::vector<unsigned char> bytes = readFileBytes(path);
    std::string text(bytes.begin(), bytes.end());
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    return oneLine(text.substr(text.find_last_of("\r\n") + 1), 300);
}

}  // namespace

std::string thisProgram() {
    std::vector<unsigned char> all = readFileBytes("/proc/self/exe");
    std::vector<fs::path> shaders;
    for (const auto& entry : fs::recursive_directory_iterator(gl::shaderDirectory()))
        if (entry.is_regular_file()) shaders.push_back(entry.path());
    std::sort(shaders.begin(), shaders.end());
    for (const fs::path& shader : shaders) {
        const std::vector<unsigned char> text = readFileBytes(shader);
        all.insert(all.end(), text.begin(), text.end());
    }
    return fmt::format("{} {}", TIMESHADE_COMMIT, toHex(sha256(all)).substr(0, 16));
}

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
    if (!record.succeeded()) record.complaint = lastLineOf(folder / "complained.txt");
    record.files = filesIn(folder);
    writeRecord(folder, record);
    return record;
}

}  // namespace timeshade
