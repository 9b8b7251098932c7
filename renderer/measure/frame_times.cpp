#include "measure/frame_times.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "measure/frame_clock.h"
#include "measure/sweep_points.h"

namespace timeshade {

namespace {

constexpr double mebibyte = 1024.0 * 1024.0;

/// All figures of a state, by name.
struct Collected {
    std::map<std::string, std::vector<double>> device, host;
    std::vector<double> whole, waits, uploaded;

    void add(const ClockedFrame& frame) {
        double told = 0.0;
        for (const gl::PassTimer::Reading& reading : frame.readings) {
            host[reading.name].push_back(reading.hostMilliseconds);
            if (!reading.isPart()) told += reading.hostMilliseconds;
        }
        for (const auto& [step, milliseconds] : stepsOf(frame.readings)) device[step].push_back(milliseconds);
        host["plan"].push_back(frame.planMilliseconds);
        host["total"].push_back(frame.planMilliseconds + told);
        whole.push_back(frame.wholeMilliseconds);
        waits.push_back(static_cast<double>(frame.waits));
        uploaded.push_back(static_cast<double>(frame.uploaded) / mebibyte);
    }
};

struct Subject {
    SweepPoint point;
    std::unique_ptr<Technique> technique;
    std::map<FrameState, Collected> figures;
    std::size_t bytes = 0;
};

std::map<std::string, Timing> timingsOf(const std::map<std::string, std::vector<double>>& figures) {
    std::map<std::string, Timing> timings;
    for (const auto& [name, values] : figures) timings[name] = timingOf(values);
    return timings;
}

void addRows(const Subject& subject, std::vector<FrameTimesRow>& rows) {
    for (const auto& [state, figures] : subject.figures)
        rows.push_back({subject.point, state, subject.technique->renders(), timingsOf(figures.device),
                        timingsOf(figures.host), timingOf(figures.whole), timingOf(figures.waits),
                        timingOf(figures.uploaded), subject.bytes});
}

double medianOf(const std::map<std::string, Timing>& steps, const std::string& name) {
    const auto step = steps.find(name);
    return step == steps.end() ? 0.0 : step->second.median;
}

}  // namespace

std::vector<FrameTimesRow> measureFrameTimes(FrameRenderer& renderer, const SweepOptions& options) {
    std::vector<FrameTimesRow> rows;
    const int frames = std::max(1, options.sequence);
    int done = 0, total = 0;
    for (const SweepScene& scene : options.scenes)
        total += static_cast<int>(pointsOf(options, scene).size()) * options.rounds;
    for (const SweepScene& scene : options.scenes) {
        FramePlanner planner(*scene.scene);
        FrameClock clock(renderer, planner, View::Final, {}, gl::LateCounts::Reading::Later);
        std::vector<Subject> subjects;
        for (SweepPoint& point : pointsOf(options, scene)) {
            std::unique_ptr<Technique> technique = makeSubject(point, options, renderer.programs());
            subjects.push_back({std::move(point), std::move(technique), {}, 0});
        }
        for (int round = 0; round < options.rounds; ++round)
            for (Subject& subject : subjects) {
                if (options.progress)
                    options.progress(fmt::format("{}: round {}", subject.point.key(), round + 1), done++, total, -1.0);
                FrameRequest request = requestOf(scene, subject.point);
                request.seed += static_cast<std::uint32_t>(round);
                request = subject.technique->asked(request);
                if (round == 0) clock.warmUp(*subject.technique, request, frames);
                for (const ClockedFrame& frame : clock.time(*subject.technique, request, frames))
                    if (frame.state != FrameState::Filling || options.sequence > 0)
                        subject.figures[frame.state].add(frame);
                subject.bytes = renderer.memory().total();
            }
        for (const Subject& subject : subjects) addRows(subject, rows);
    }
    return rows;
}

std::string frameTimesTable(const std::vector<FrameTimesRow>& rows) {
    std::string text =
        "| scene | technique | spp | map | state | whole frame | processor | of it planning | waits | uploaded MiB | "
        "device | camera "
        "samples | shadow structure | shadow test | shading | GPU MiB |\n"
        "| --- | --- | --: | --: | --- | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |\n";
    for (const FrameTimesRow& row : rows)
        text += fmt::format(
            "| {} | {} | {} | {} | {} | {:.2f} ({:.2f} to {:.2f}) | {:.2f} | {:.2f} | {:.0f} | {:.3f} | {:.2f} | "
            "{:.2f} | "
            "{:.2f} | {:.2f} | {:.2f} | {:.1f} |\n",
            row.point.scene, row.point.technique,
            row.renders > 1 ? fmt::format("{}x", row.renders) : std::to_string(row.point.sampleCount),
            row.point.mapSize.text(), nameOf(row.state), row.whole.median, row.whole.low, row.whole.high,
            medianOf(row.host, "total"), medianOf(row.host, "plan"), row.waits.median, row.uploaded.median,
            medianOf(row.device, "total"), medianOf(row.device, "sample"), medianOf(row.device, "build"),
            medianOf(row.device, "lookup"), medianOf(row.device, "shade"), static_cast<double>(row.bytes) / mebibyte);
    return text;
}

std::string frameTimesCsv(const std::vector<FrameTimesRow>& rows) {
    std::string text = "scene,technique,spp,map,state,clock,step,median_ms,low_ms,high_ms\n";
    for (const FrameTimesRow& row : rows) {
        const auto add = [&](const char* clock, const std::string& step, const Timing& t) {
            text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", row.point.scene, row.point.technique,
                                row.point.sampleCount, row.point.mapSize.text(), nameOf(row.state), clock, step,
                                t.median, t.low, t.high);
        };
        for (const auto& [step, timing] : row.device) add("device", step, timing);
        for (const auto& [step, timing] : row.host) add("processor", step, timing);
        add("wall", "whole", row.whole);
    }
    return text;
}

}  // namespace timeshade
