#include <algorithm>
#include <cstdio>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "frame_setup.h"
#include "headless.h"
#include "headless_gl.h"
#include "measure/case_matrix.h"
#include "measure/case_picture.h"
#include "standard_error.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

void printRow(const CaseResult& r) {
    if (r.verdict == Verdict::NotTaken) {
        fmt::print("{:<13} {:<25} {:>8.4f}  {}\n", r.technique, r.caseName, r.exact, r.reason);
        return;
    }
    fmt::print("{:<13} {:<25} {:>8.4f} {:>8.4f} {:>8.4f} {:>9.4f} {:>9.4f}  {}\n", r.technique, r.caseName, r.exact,
               r.value, r.error(), r.tolerance, r.predicted, nameOf(r.verdict));
}

std::string asJson(const std::vector<CaseResult>& results) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const CaseResult& r : results) {
        nlohmann::ordered_json cell{{"technique", r.technique}, {"case", r.caseName}, {"exact", r.exact}};
        if (r.verdict == Verdict::NotTaken) {
            cell["reason"] = r.reason;
        } else {
            cell["value"] = r.value;
            cell["error"] = r.error();
            cell["tolerance"] = r.tolerance;
            cell["predicted"] = r.predicted;
            cell["predictedTolerance"] = r.predictedTolerance;
            if (r.ties > 0.0) cell["ties"] = r.ties;
        }
        cell["verdict"] = r.verdict == Verdict::NotTaken ? "not taken" : nameOf(r.verdict);
        json.push_back(cell);
    }
    return json.dump(2) + "\n";
}

/// Three of the cases evaluate shared functions, without a technique: they are counted apart.
std::string summary(const std::vector<CaseResult>& results) {
    const auto count = [&](bool ofTechniques, Verdict verdict) {
        return std::count_if(results.begin(), results.end(), [&](const CaseResult& r) {
            return (r.technique != "-") == ofTechniques && r.verdict == verdict;
        });
    };
    return fmt::format(
        "cells of techniques: {} right, {} off as predicted, {} wrong, {} not taken; shared arithmetic: {} right, {} "
        "wrong\n",
        count(true, Verdict::Right), count(true, Verdict::Predicted), count(true, Verdict::Wrong),
        count(true, Verdict::NotTaken), count(false, Verdict::Right), count(false, Verdict::Wrong));
}

}  // namespace

int runCases(const CasesOptions& options) {
    if (!options.output.empty()) requireWritable(options.output);
    if (!options.json.empty() && options.json != "-") requireWritable(options.json);
    std::vector<std::string> names = options.measuredTechniques;
    if (names.empty())
        for (const TechniqueDescription& description : techniqueDescriptions()) names.push_back(description.name);

    const HeadlessGl opengl(options);
    FrameRenderer renderer;
    renderer.setChecked(options.debugGl);
    const bool quiet = options.json == "-";
    if (!quiet)
        fmt::print("{:<13} {:<25} {:>8} {:>8} {:>8} {:>9} {:>9}  verdict\n", "technique", "case", "exact", "value",
                   "error", "tolerance", "predicted");
    std::vector<CaseResult> results;
    const auto take = [&](CaseResult result) {
        results.push_back(std::move(result));
        if (!quiet) printRow(results.back());
        std::fflush(stdout);
    };
    for (const ClosedFormCase& c : closedFormCases())
        if (c.kind == ClosedFormCase::Kind::Numeric) take(runNumericCase(c));
    for (const std::string& name : names) {
        const std::unique_ptr<Technique> technique = techniqueFor(name, options.settings, renderer.programs());
        for (const ClosedFormCase& c : closedFormCases())
            if (c.kind != ClosedFormCase::Kind::Numeric)
                take(runCase(renderer, *technique, c, {options.samplesPerPixel, options.mapSize}));
        take(runContactGaps(renderer, *technique, {options.samplesPerPixel, options.mapSize}));
    }
    opengl.requireSilence();
    fmt::print("{}", quiet ? asJson(results) : summary(results));
    if (!quiet && !options.json.empty()) writeFileAtomically(options.json, asJson(results));
    if (!options.output.empty()) writePng(options.output, drawCaseMatrix(results));
    std::size_t wrong = 0;
    for (const CaseResult& r : results) wrong += r.verdict == Verdict::Wrong ? 1u : 0u;
    if (wrong == 0) return 0;
    tell(fmt::format("{} of {} cells are wrong", wrong, results.size()));
    return 1;
}

}  // namespace timeshade
