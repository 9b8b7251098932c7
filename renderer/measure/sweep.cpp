#include "measure/sweep.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "frame/warm_up.h"
#include "measure/display_encoding.h"
#include "measure/embree_baseline.h"
#include "measure/made_with.h"
#include "measure/reference.h"
#include "measure/reference_noise.h"
#include "measure/reference_technique.h"
#include "measure/stopwatch.h"
#include "measure/sweep_journal.h"
#include "measure/sweep_points.h"
#include "measure/technique_variant.h"

namespace timeshade {

namespace {

using Clock = std::chrono::steady_clock;

/// One point while it is being measured.
struct Subject {
    SweepPoint point;
    std::unique_ptr<Technique> technique;
    std::map<FrameState, std::map<std::string, std::vector<double>>> times;
    std::vector<LinearImage> images;
    SweepRow row;  ///< of any state, without times
};

/// The states in which a point must have been measured: there may be rows for Filling as well.
std::vector<FrameState> statesOf(const SweepPoint& point, const SweepScene& scene) {
    if (isBaseline(point) || !scene.request.useCaches || scene.request.forceDynamic) return {FrameState::Cold};
    return {FrameState::Cold, FrameState::Steady};
}

/// Counts steps for the progress line and guesses the time left from the steps so far.
class Steps {
  public:
    Steps(const SweepOptions& options, int total) : options_(options), total_(total) {}
    void next(const std::string& what) {
        if (!options_.progress) return;
        const double each = done_ > 0 ? millisecondsSince(begin_) / 1000.0 / done_ : -1.0;
        options_.progress(what, done_, total_, each < 0.0 ? -1.0 : each * (total_ - done_));
        ++done_;
    }

  private:
    const SweepOptions& options_;
    int total_, done_ = 0;
    Clock::time_point begin_ = Clock::now();
};

class SceneSweep {
  public:
    SceneSweep(FrameRenderer& renderer, const SweepOptions& options, const SweepScene& scene, ReferenceCache& cache,
               Steps& steps)
        : renderer_(renderer),
          options_(options),
          scene_(scene),
          cache_(cache),
          steps_(steps),
          planner_(*scene.scene),
          clock_(renderer, planner_, View::Final) {}

    void run(std::vector<Subject>& subjects) {
        steps_.next(scene_.varied.empty()
                        ? scene_.name + ": reference"
                        : fmt::format("{} {}={}: reference", scene_.name, scene_.varied, scene_.variedValue));
        ReferenceOptions how;
        how.samplesPerPixel = options_.referenceSamples;
        reference_ = referenceImage(renderer_, planFor(subjects.front().point, 0), how, cache_);
        displayedReference_ = displayed(reference_);
        referenceNoise_ = referenceNoise(renderer_, planner_, scene_.request, reference_, options_.referenceSamples);
        if (options_.referenceRays > 0)
            visibility_ = referenceVisibility(planFor(subjects.front().point, 0), options_.referenceRays, cache_);
        for (const Subject& subject : subjects)
            if (const auto lowered = loweredMotionSteps(requestFor(subject, 0)); lowered && options_.note)
                options_.note(subject.point.key() + ": " + *lowered);
        for (int round = 0; round < options_.rounds; ++round)
            for (Subject& subject : subjects) {
                steps_.next(fmt::format("{}: round {}", subject.point.key(), round + 1));
                time(subject, round);
            }
        for (Subject& subject : subjects) {
            steps_.next(subject.point.key() + ": against the oracle");
            finish(subject);
        }
    }

  private:
    FrameRequest requestFor(const SweepPoint& point, int round) const {
        FrameRequest request = requestOf(scene_, point);
        request.seed += static_cast<std::uint32_t>(round);
        return request;
    }
    /// Each technique on the samples that it asks for: what is compared here are errors, each against the truth of its
    /// own samples, or against the whole pixel's.
    FrameRequest requestFor(const Subject& subject, int round) const {
        return subject.technique->asked(requestFor(subject.point, round));
    }

    FramePlan planFor(const SweepPoint& point, int round) { return planner_.plan(requestFor(point, round)); }

    void time(Subject& subject, int round) {
        const FrameRequest request = requestFor(subject, round);
        if (isBaseline(subject.point)) {
            renderer_.draw(planner_.plan(request), *subject.technique, View::Final);
            std::map<std::string, double> steps = stepsOf(renderer_.timer().finishFrame());
            timeEmbree(planner_.plan(request), steps);
            add(subject, FrameState::Cold, steps);
        } else {
            if (round == 0) clock_.warmUp(*subject.technique, request, std::max(1, options_.sequence));
            for (const ClockedFrame& frame : clock_.time(*subject.technique, request, std::max(1, options_.sequence)))
                add(subject, frame.state, stepsOf(frame.readings));
        }
        subject.images.push_back(renderer_.readRadiance());
        if (round == 0) {
            const GpuMemory memory = renderer_.memory();
            subject.row.bytes = memory.total();
            subject.row.techniqueBytes = memory.technique;
            subject.row.statistics = subject.technique->statistics();
            subject.row.renders = subject.technique->renders();
        }
    }

    static void add(Subject& subject, FrameState state, const std::map<std::string, double>& steps) {
        for (const auto& [name, milliseconds] : steps) subject.times[state][name].push_back(milliseconds);
    }

    /// Embree at its best on the same camera samples: building, primary rays, shadow rays, without any transfer.
    void timeEmbree(const FramePlan& whole, std::map<std::string, double>& times) const {
        times["build"] = times["sample"] = times["lookup"] = 0.0;
        for (int piece = 0; piece < rendersOf(whole, 1); ++piece) timeEmbreePiece(pieceOf(whole, piece, 1), times);
        times["total"] = times["build"] + times["sample"] + times["lookup"] + times["shade"];
    }

    static void timeEmbreePiece(const FramePlan& plan, std::map<std::string, double>& times) {
        EmbreeBaseline baseline(plan);
        auto begin = Clock::now();
        baseline.build();
        times["build"] += millisecondsSince(begin);
        begin = Clock::now();
        baseline.tracePrimaries();
        times["sample"] += millisecondsSince(begin);
        begin = Clock::now();
        baseline.traceShadows();
        times["lookup"] += millisecondsSince(begin);
    }

    void finish(Subject& subject) {
        SweepRow& row = subject.row;
        row.point = subject.point;
        const LinearImage& image = subject.images.front();
        row.error = compareImages(image, reference_, displayed(image), displayedReference_);
        row.referenceNoise = referenceNoise_;
        row.biasAndNoise = biasAndNoise(subject.images, reference_);
        VerificationOptions how;
        how.checkPrimaries = subject.technique->renders() == 1;
        how.reference = visibility_;
        const FrameRequest request = requestFor(subject, 0);
        drawWarmUp(renderer_, planner_, *subject.technique, request, View::Final);
        row.verification = verifyFrame(renderer_, planner_.plan(request), *subject.technique, how);
        renderer_.timer().finishFrame();
    }

    FrameRenderer& renderer_;
    const SweepOptions& options_;
    const SweepScene& scene_;
    ReferenceCache& cache_;
    Steps& steps_;
    FramePlanner planner_;
    FrameClock clock_;
    LinearImage reference_;
    double referenceNoise_ = 0.0;
    std::shared_ptr<const ReferenceVisibility> visibility_;
    DisplayImage displayedReference_;
};

bool isWanted(FrameState state, const SweepOptions& options) {
    return state != FrameState::Filling || options.sequence > 0;
}

/// A point and everything that its rows depend on.
struct WantedPoint {
    SweepPoint point;
    MadeWith madeWith;
};

std::vector<WantedPoint> wantedPoints(const SweepOptions& options, const SweepScene& scene, FrameRenderer& renderer,
                                      const MadeWith& program) {
    std::vector<WantedPoint> wanted;
    for (const SweepPoint& point : pointsOf(options, scene)) {
        MadeWith madeWith = program;
        for (auto& part : madeWithScene(*scene.scene, requestOf(scene, point))) madeWith.push_back(std::move(part));
        const std::unique_ptr<Technique> technique = makeSubject(point, options, renderer.programs());
        madeWith.emplace_back("settings", settingsText(*technique));
        madeWith.emplace_back("measurement",
                              fmt::format("rounds {}, sequence {}, reference {} samples, {} rays", options.rounds,
                                          options.sequence, options.referenceSamples, options.referenceRays));
        wanted.push_back({point, std::move(madeWith)});
    }
    return wanted;
}

bool measured(const SweepJournal& journal, const WantedPoint& wanted, const SweepScene& scene) {
    for (const FrameState state : statesOf(wanted.point, scene))
        if (!journal.find(wanted.point, state, wanted.madeWith)) return false;
    return true;
}

/// A row for every state in which the subject was timed, but for those that the journal has.
void write(SweepJournal& journal, const Subject& subject, const MadeWith& madeWith) {
    for (const auto& [state, times] : subject.times) {
        if (journal.find(subject.point, state, madeWith)) continue;  // of a sweep that was interrupted right behind it
        SweepRow row = subject.row;
        row.state = state;
        for (const auto& [name, values] : times) row.steps[name] = timingOf(values);
        journal.append(row, madeWith);
    }
}

/// Says which parts make earlier rows useless, and of how many points.
void noteStaleRows(const SweepJournal& journal, const SweepOptions& options,
                   const std::vector<std::vector<WantedPoint>>& wanted) {
    std::set<std::string> parts;
    int points = 0;
    for (const std::vector<WantedPoint>& ofScene : wanted)
        for (const WantedPoint& point : ofScene) {
            const std::vector<std::string> stale = journal.staleParts(point.point, point.madeWith);
            points += stale.empty() ? 0 : 1;
            parts.insert(stale.begin(), stale.end());
        }
    if (points > 0 && options.note)
        options.note(fmt::format("{}: {} points were measured with another {}; they are measured again",
                                 options.journal.string(), points, fmt::join(parts, ", ")));
}

}  // namespace

Timing timingOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return {values[values.size() / 2], values.front(), values.back()};
}

std::string SweepPoint::key() const {
    const std::string place = varied.empty() ? scene : fmt::format("{} {}={}", scene, varied, variedValue);
    return fmt::format("{} {} spp {} map {}", place, technique, sampleCount, mapSize.text());
}

std::vector<SweepRow> runSweep(FrameRenderer& renderer, const SweepOptions& options, ReferenceCache& cache) {
    SweepJournal journal(options.journal);
    const MadeWith program = madeWithProgram(options.commit, renderer.device());
    std::vector<std::vector<WantedPoint>> wanted;
    int total = 0;
    for (const SweepScene& scene : options.scenes) {
        wanted.push_back(wantedPoints(options, scene, renderer, program));
        int missing = 0;
        for (const WantedPoint& point : wanted.back()) missing += measured(journal, point, scene) ? 0 : 1;
        total += missing > 0 ? 1 + missing * (options.rounds + 1) : 0;
    }
    noteStaleRows(journal, options, wanted);
    Steps steps(options, total);
    for (std::size_t s = 0; s < options.scenes.size(); ++s) {
        std::vector<Subject> subjects;
        std::vector<const MadeWith*> madeWith;
        for (const WantedPoint& point : wanted[s])
            if (!measured(journal, point, options.scenes[s])) {
                subjects.push_back({point.point, makeSubject(point.point, options, renderer.programs()), {}, {}, {}});
                madeWith.push_back(&point.madeWith);
            }
        if (subjects.empty()) continue;
        SceneSweep(renderer, options, options.scenes[s], cache, steps).run(subjects);
        for (std::size_t i = 0; i < subjects.size(); ++i) write(journal, subjects[i], *madeWith[i]);
    }
    std::vector<SweepRow> rows;
    for (const std::vector<WantedPoint>& ofScene : wanted)
        for (const WantedPoint& point : ofScene)
            for (const FrameState state : {FrameState::Cold, FrameState::Filling, FrameState::Steady})
                if (const SweepRow* row = journal.find(point.point, state, point.madeWith);
                    row && isWanted(state, options))
                    rows.push_back(*row);
    return rows;
}

}  // namespace timeshade
