#pragma once

#include <map>
#include <string>
#include <vector>

#include "measure/sweep.h"

namespace timeshade {

/// What a frame of one point takes in one state, in milliseconds.
struct FrameTimesRow {
    SweepPoint point;
    FrameState state = FrameState::Steady;
    int renders = 1;                       ///< of brute force, whose times are those of all of them together
    std::map<std::string, Timing> device;  ///< by step, as SweepRow::steps
    std::map<std::string, Timing> host;    ///< what the processor spent on telling the device; "plan": before that
    Timing whole;                          ///< by the clock on the wall, from the plan to the device having done all
    Timing waits;                          ///< how often the processor waited for the device before the frame's end
    Timing uploaded;                       ///< MiB that the processor handed to the device
    std::size_t bytes = 0;                 ///< GPU memory, all of the frame
};

/// Times every point once in each round, interleaved, by a FrameClock; no errors, no references. Of the options it
/// takes scenes, techniques without the Embree baseline, settings, sample counts, maps, rounds, sequence and progress.
std::vector<FrameTimesRow> measureFrameTimes(FrameRenderer& renderer, const SweepOptions& options);

/// A table in Markdown, a line each row: whole frame, processor, waits, and the device's steps.
std::string frameTimesTable(const std::vector<FrameTimesRow>& rows);
/// Every number, a line for each row and step: median, lowest, highest.
std::string frameTimesCsv(const std::vector<FrameTimesRow>& rows);

}  // namespace timeshade
