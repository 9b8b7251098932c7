#include "measure/equal_measurement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>

#include <fmt/format.h>

#include "frame/warm_up.h"
#include "measure/display_encoding.h"
#include "measure/reference.h"
#include "measure/technique_variant.h"

namespace timeshade {

namespace {

/// A technique at a number of samples and a map size.
struct Subject {
    std::string variant;
    std::unique_ptr<Technique> technique;
    FrameRequest request;
    bool bruteForce = false;
    bool warm = false;  ///< its programs have been compiled

    int sampleCount() const { return bruteForce ? technique->renders() : request.samplesPerPixel; }
};

/// Known by its setting: with one render it says that it draws once, as all others do.
bool isBruteForce(Technique& technique) {
    const std::vector<Setting> settings = settingsOf(technique);
    return std::any_of(settings.begin(), settings.end(),
                       [](const Setting& setting) { return setting.key == "renders"; });
}

/// Milliseconds of frames that were timed in turn.
struct PairOfTimes {
    std::vector<double> own, first;
};

/// What came of one technique with one map.
struct Candidate {
    EqualRow row;
    std::vector<double> firstFrames;  ///< timed in turn with the row's
};

/// Infinitely more than nothing, but as much if both are nothing.
double ratioOf(double value, double first) {
    if (first > 0.0) return value / first;
    return value > 0.0 ? std::numeric_limits<double>::infinity() : 1.0;
}

class SceneMeasurement {
  public:
    SceneMeasurement(FrameRenderer& renderer, const EqualOptions& options, const SweepScene& scene,
                     ReferenceCache& cache)
        : renderer_(renderer),
          options_(options),
          scene_(scene),
          cache_(cache),
          planner_(*scene.scene),
          clock_(renderer, planner_, View::Final) {}

    EqualScene run() {
        EqualScene result;
        result.name = scene_.name;
        say("references");
        ReferenceOptions how;
        how.samplesPerPixel = options_.referenceSamples;
        result.reference =
            displayed(referenceImage(renderer_, planner_.plan(scene_.request), how, cache_), scene_.request.look);
        visibility_ = referenceVisibility(planner_.plan(scene_.request), options_.referenceRays, cache_);
        result.referenceRays = visibility_->rays;

        first_ = subjectOf(options_.techniques.front(), std::nullopt, scene_.request.mapSize);
        say(inWords(first_));
        result.rows.push_back(judged(first_));
        std::vector<double> firstFrames;
        for (std::size_t i = 1; i < options_.techniques.size(); ++i) {
            Candidate best = bestOf(options_.techniques[i], result.rows.front().shadowError.rms);
            firstFrames.insert(firstFrames.end(), best.firstFrames.begin(), best.firstFrames.end());
            result.rows.push_back(std::move(best.row));
        }
        result.rows.front().steady = timingOf(firstFrames);
        result.rows.front().firstMilliseconds = result.rows.front().steady.median;
        return result;
    }

  private:
    void say(const std::string& what) const {
        if (options_.progress) options_.progress(scene_.name + ": " + what);
    }

    static std::string inWords(const Subject& subject) {
        return fmt::format("{} at {} {}, map {}", subject.variant, subject.sampleCount(),
                           subject.bruteForce ? "renders" : "spp", subject.request.mapSize.text());
    }

    /// At the samples that the request or its own setting says where no number is given.
    Subject subjectOf(const std::string& variant, std::optional<int> sampleCount, const MapSize& mapSize) {
        const TechniqueVariant series = TechniqueVariant::onItsSamples(variant);
        Subject subject{variant, series.make(options_.settings, renderer_.programs()), scene_.request};
        subject.request = subject.technique->asked(series.on(scene_.request));
        subject.bruteForce = isBruteForce(*subject.technique);
        subject.request.mapSize = mapSize;
        if (sampleCount && subject.bruteForce) setFromText(*subject.technique, "renders", std::to_string(*sampleCount));
        // One render of brute force would else be drawn with all samples of a frame, as it is no repeated one.
        if (sampleCount) subject.request.samplesPerPixel = subject.bruteForce ? 1 : *sampleCount;
        return subject;
    }

    std::vector<int> sampleCountsFor(const std::string& variant) {
        std::vector<int> counts(isBruteForce(*subjectOf(variant, std::nullopt, scene_.request.mapSize).technique)
                                    ? mostRenders
                                    : maximumSamplesPerPixel);
        std::iota(counts.begin(), counts.end(), 1);
        return counts;
    }

    /// Steady frames of the first technique and of each of these, in turn.
    std::vector<PairOfTimes> timeInTurn(std::vector<Subject>& others, int rounds) {
        std::vector<Subject*> subjects{&first_};
        for (Subject& other : others) subjects.push_back(&other);
        for (Subject* subject : subjects)
            if (!subject->warm) {
                clock_.warmUp(*subject->technique, subject->request, options_.steadyFrames);
                subject->warm = true;
            }
        std::vector<std::vector<double>> frames(subjects.size());
        for (int round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < subjects.size(); ++i)
                for (const ClockedFrame& frame :
                     clock_.time(*subjects[i]->technique, subjects[i]->request, options_.steadyFrames))
                    if (frame.state == FrameState::Steady) frames[i].push_back(gl::totalOf(frame.readings));
        std::vector<PairOfTimes> times;
        for (std::size_t i = 1; i < subjects.size(); ++i) times.push_back({frames[i], frames.front()});
        return times;
    }

    Verification compare(Subject& subject) {
        VerificationOptions how;
        how.checkPrimaries = false;
        how.reference = visibility_;
        how.footprint.samples = 0;
        drawWarmUp(renderer_, planner_, *subject.technique, subject.request, View::Final);
        const Verification verification =
            verifyFrame(renderer_, planner_.plan(subject.request), *subject.technique, how);
        renderer_.timer().finishFrame();
        return verification;
    }

    /// The requested frame as `shot` draws it.
    void draw(Subject& subject) {
        drawWarmUp(renderer_, planner_, *subject.technique, subject.request, View::Final);
        renderer_.draw(planner_.plan(subject.request), *subject.technique, View::Final);
        renderer_.timer().finishFrame();
    }

    /// A row with all but times.
    EqualRow judged(Subject& subject) {
        const Verification verification = compare(subject);
        EqualRow row;
        row.technique = subject.variant;
        row.title = subject.technique->description().shortTitle;
        row.sampleCount = subject.sampleCount();
        row.bruteForce = subject.bruteForce;
        row.mapSize = subject.request.mapSize;
        row.shadowError = verification.shadowError->error;
        if (verification.isBinary()) row.wrongPpm = verification.ppm();
        draw(subject);
        const GpuMemory memory = renderer_.memory();
        row.bytes = memory.total();
        row.techniqueBytes = memory.technique;
        row.picture = renderer_.readPicture();
        return row;
    }

    Candidate levelInTime(const std::string& variant, const MapSize& mapSize) {
        std::map<int, PairOfTimes> newest;  // by number of samples
        const auto measure = [&](const std::vector<int>& sampleCounts, bool closely) {
            std::vector<Subject> subjects;
            for (const int sampleCount : sampleCounts) subjects.push_back(subjectOf(variant, sampleCount, mapSize));
            say(inWords(subjects.back()) + (closely ? ", and one less" : ""));
            const std::vector<PairOfTimes> times = timeInTurn(subjects, closely ? options_.rounds : 1);
            std::vector<double> ratios;
            for (std::size_t i = 0; i < times.size(); ++i) {
                newest[sampleCounts[i]] = times[i];
                ratios.push_back(timingOf(times[i].own).median / timingOf(times[i].first).median);
            }
            return ratios;
        };
        const EqualFind find = findEqualTime(sampleCountsFor(variant), measure);
        Subject chosen = subjectOf(variant, find.chosen.sampleCount, mapSize);
        return candidateOf(chosen, find, newest.at(find.chosen.sampleCount));
    }

    Candidate levelInError(const std::string& variant, const MapSize& mapSize, double firstError) {
        const auto measure = [&](const std::vector<int>& sampleCounts, bool) {
            std::vector<double> ratios;
            for (const int sampleCount : sampleCounts) {
                Subject subject = subjectOf(variant, sampleCount, mapSize);
                say(inWords(subject));
                ratios.push_back(ratioOf(compare(subject).shadowError->error.rms, firstError));
            }
            return ratios;
        };
        const EqualFind find = findEqualError(sampleCountsFor(variant), measure);
        std::vector<Subject> chosen;
        chosen.push_back(subjectOf(variant, find.chosen.sampleCount, mapSize));
        say(inWords(chosen.front()));
        const PairOfTimes times = timeInTurn(chosen, options_.rounds).front();
        return candidateOf(chosen.front(), find, times);
    }

    Candidate candidateOf(Subject& subject, const EqualFind& find, const PairOfTimes& times) {
        Candidate candidate{judged(subject), times.first};
        candidate.row.find = find;
        candidate.row.steady = timingOf(times.own);
        candidate.row.firstMilliseconds = timingOf(times.first).median;
        return candidate;
    }

    Candidate bestOf(const std::string& variant, double firstError) {
        const bool byTime = options_.level == EqualLevel::Time;
        std::optional<Candidate> best;
        for (const MapSize& mapSize : options_.mapSizes) {
            Candidate candidate = byTime ? levelInTime(variant, mapSize) : levelInError(variant, mapSize, firstError);
            if (!best || isBetter(candidate.row, best->row, byTime)) best = std::move(candidate);
        }
        return std::move(*best);
    }

    static bool isBetter(const EqualRow& row, const EqualRow& than, bool byTime) {
        const EqualFind &find = *row.find, &other = *than.find;
        if (find.found != other.found) return find.found;
        if (!find.found) return std::abs(std::log(find.chosen.ratio)) < std::abs(std::log(other.chosen.ratio));
        return byTime ? row.shadowError.rms < than.shadowError.rms : row.steady.median < than.steady.median;
    }

    FrameRenderer& renderer_;
    const EqualOptions& options_;
    const SweepScene& scene_;
    ReferenceCache& cache_;
    FramePlanner planner_;
    FrameClock clock_;
    std::shared_ptr<const ReferenceVisibility> visibility_;
    Subject first_;
};

}  // namespace

EqualScene measureEqual(FrameRenderer& renderer, const EqualOptions& options, const SweepScene& scene,
                        ReferenceCache& cache) {
    return SceneMeasurement(renderer, options, scene, cache).run();
}

}  // namespace timeshade
