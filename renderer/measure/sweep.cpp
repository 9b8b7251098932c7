#include "measure/sweep.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include <fmt/format.h>

#include "frame/warm_up.h"
#include "measure/display_encoding.h"
#include "measure/embree_baseline.h"
#include "measure/reference.h"
#include "measure/reference_noise.h"
#include "measure/reference_technique.h"
#include "measure/sweep_journal.h"
#include "measure/technique_variant.h"

namespace timeshade {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

Timing timingOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return {values[values.size() / 2], values.front(), values.back()};
}

/// One point while it is being measured.
struct Subject {
    SweepPoint point;
    std::unique_ptr<Technique> technique;
    std::map<FrameState, std::map<std::string, std::vector<double>>> times;
    std::vector<LinearImage> images;
    SweepRow row;  ///< of any state, without times
};

bool isBaseline(const SweepPoint& point) { return point.technique == "embree"; }

/// The states in which a point must have been measured: there may be rows for Filling as well.
std::vector<FrameState> statesOf(const SweepPoint& point, const SweepScene& scene) {
    if (isBaseline(point) || !scene.request.useCaches || scene.request.forceDynamic) return {FrameState::Cold};
    return {FrameState::Cold, FrameState::Steady};
}

std::unique_ptr<Technique> makeSubject(const SweepPoint& point, const SweepOptions& options,
                                       gl::ProgramCache& programs) {
    if (isBaseline(point)) return std::make_unique<ReferenceTechnique>();
    std::unique_ptr<Technique> technique = TechniqueVariant::of(point.technique).make(options.settings, programs);
    if (technique->renders() > 1)
        setFromText(*technique, "renders", std::to_string(bruteForceRenders(point.sampleCount)));
    return technique;
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
        displayedReference_ = displayed(reference_, true);
        referenceNoise_ = referenceNoise(renderer_, planner_, scene_.request, reference_, options_.referenceSamples);
        if (options_.referenceRays > 0)
            visibility_ = referenceVisibility(planFor(subjects.front().point, 0), options_.referenceRays, cache_);
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
        FrameRequest request = scene_.request;
        request.samplesPerPixel = point.sampleCount;
        request.mapSize = point.mapSize;
        request.seed = scene_.request.seed + static_cast<std::uint32_t>(round);
        return request;
    }

    FramePlan planFor(const SweepPoint& point, int round) { return planner_.plan(requestFor(point, round)); }

    void time(Subject& subject, int round) {
        const FrameRequest request = requestFor(subject.point, round);
        if (isBaseline(subject.point)) {
            renderer_.draw(planner_.plan(request), *subject.technique, View::Final);
            std::map<std::string, double> steps = stepsOf(renderer_.timer().finishFrame());
            timeEmbree(planner_.plan(request), steps);
            add(subject, FrameState::Cold, steps);
        } else {
            if (round == 0) clock_.warmUp(*subject.technique, request);
            for (const ClockedFrame& frame : clock_.time(*subject.technique, request, std::max(1, options_.sequence)))
                add(subject, frame.state, stepsOf(frame.readings));
        }
        subject.images.push_back(renderer_.readRadiance());
        if (round == 0) {
            const GpuMemory memory = renderer_.memory();
            subject.row.bytes = memory.total();
            subject.row.techniqueBytes = memory.technique;
            subject.row.statistics = subject.technique->statistics();
            subject.row.renders = renderer_.renders();
        }
    }

    static void add(Subject& subject, FrameState state, const std::map<std::string, double>& steps) {
        for (const auto& [name, milliseconds] : steps) subject.times[state][name].push_back(milliseconds);
    }

    /// Embree at its best on the same camera samples: building, primary rays, shadow rays, without any transfer.
    void timeEmbree(const FramePlan& plan, std::map<std::string, double>& times) const {
        auto begin = Clock::now();
        EmbreeBaseline baseline(plan);
        times["build"] = millisecondsSince(begin);
        begin = Clock::now();
        baseline.tracePrimaries();
        times["sample"] = millisecondsSince(begin);
        begin = Clock::now();
        baseline.traceShadows();
        times["lookup"] = millisecondsSince(begin);
        times["total"] = times["build"] + times["sample"] + times["lookup"] + times["shade"];
    }

    void finish(Subject& subject) {
        SweepRow& row = subject.row;
        row.point = subject.point;
        const LinearImage& image = subject.images.front();
        row.error = compareImages(image, reference_, displayed(image, true), displayedReference_);
        row.referenceNoise = referenceNoise_;
        row.biasAndNoise = biasAndNoise(subject.images, reference_);
        VerificationOptions how;
        how.checkPrimaries = subject.technique->renders() == 1;
        how.reference = visibility_;
        drawWarmUp(renderer_, planner_, *subject.technique, requestFor(subject.point, 0), View::Final);
        row.verification = verifyFrame(renderer_, planFor(subject.point, 0), *subject.technique, how);
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

std::vector<SweepPoint> pointsOf(const SweepOptions& options, const SweepScene& scene) {
    std::vector<SweepPoint> points;
    for (const std::string& technique : options.techniques)
        for (const int mapSize : options.mapSizes) {
            for (const int sampleCount : options.sampleCounts) {
                points.push_back({scene.name, technique, sampleCount, mapSize, scene.varied, scene.variedValue});
                if (isBaseline(points.back()) && mapSize != options.mapSizes.front()) points.pop_back();  // has no map
            }
        }
    return points;
}

bool wanted(FrameState state, const SweepOptions& options) {
    return state != FrameState::Filling || options.sequence > 0;
}

bool measured(const SweepJournal& journal, const SweepPoint& point, const SweepScene& scene) {
    for (const FrameState state : statesOf(point, scene))
        if (!journal.find(point, state)) return false;
    return true;
}

/// A row for every state in which the subject was timed, but for those that the journal has.
void write(SweepJournal& journal, const Subject& subject) {
    for (const auto& [state, times] : subject.times) {
        if (journal.find(subject.point, state)) continue;  // of a sweep that was interrupted right behind it
        SweepRow row = subject.row;
        row.state = state;
        for (const auto& [name, values] : times) row.steps[name] = timingOf(values);
        journal.append(row);
    }
}

/// What a journal must have been made with for its rows to be used again.
std::string experimentOf(const FrameRenderer& renderer, const SweepOptions& options) {
    std::string text =
        fmt::format("{}; rounds {}; reference {}", renderer.device().renderer + " " + renderer.device().version,
                    options.rounds, options.referenceSamples);
    if (options.sequence > 0) text += fmt::format("; sequence {}", options.sequence);
    for (const auto& [name, value] : options.settings) text += fmt::format("; {}={}", name, value);
    for (const SweepScene& scene : options.scenes)
        text += fmt::format("; {} {}x{} frame {} shutter {} fps {} seed {} camera {}", scene.name, scene.request.width,
                            scene.request.height, scene.request.frame, scene.request.shutter.length,
                            scene.request.shutter.framesPerSecond, scene.request.seed, scene.request.cameraIndex) +
                (scene.varied.empty() ? "" : fmt::format(" {}={}", scene.varied, scene.variedValue));
    return text;
}

}  // namespace

std::string SweepPoint::key() const {
    const std::string place = varied.empty() ? scene : fmt::format("{} {}={}", scene, varied, variedValue);
    return fmt::format("{} {} spp {} map {}", place, technique, sampleCount, mapSize);
}

std::vector<SweepRow> runSweep(FrameRenderer& renderer, const SweepOptions& options, ReferenceCache& cache) {
    SweepJournal journal(options.journal, experimentOf(renderer, options));
    int total = 0;
    for (const SweepScene& scene : options.scenes) {
        int missing = 0;
        for (const SweepPoint& point : pointsOf(options, scene)) missing += measured(journal, point, scene) ? 0 : 1;
        total += missing > 0 ? 1 + missing * (options.rounds + 1) : 0;
    }
    Steps steps(options, total);
    for (const SweepScene& scene : options.scenes) {
        std::vector<Subject> subjects;
        for (const SweepPoint& point : pointsOf(options, scene))
            if (!measured(journal, point, scene))
                subjects.push_back({point, makeSubject(point, options, renderer.programs()), {}, {}, {}});
        if (subjects.empty()) continue;
        SceneSweep(renderer, options, scene, cache, steps).run(subjects);
        for (const Subject& subject : subjects) write(journal, subject);
    }
    std::vector<SweepRow> rows;
    for (const SweepScene& scene : options.scenes)
        for (const SweepPoint& point : pointsOf(options, scene))
            for (const FrameState state : {FrameState::Cold, FrameState::Filling, FrameState::Steady})
                if (const SweepRow* row = journal.find(point, state); row && wanted(state, options))
                    rows.push_back(*row);
    return rows;
}

}  // namespace timeshade
