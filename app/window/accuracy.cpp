#include "window/accuracy.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "frame_setup.h"
#include "techniques/registry.h"
#include "window/session.h"

namespace timeshade {

namespace {

std::vector<double> valuesOf(Technique& technique) {
    std::vector<double> values;
    for (const Setting& setting : settingsOf(technique)) values.push_back(setting.get());
    return values;
}

/// Where brute force has its number of renders among its settings; nothing for techniques that draw a frame once.
/// It is known by its settings: with one render it says that it draws once, as all others do.
std::optional<std::size_t> rendersPlace(const std::string& technique) {
    gl::ProgramCache none;  // settings are declared without OpenGL
    const std::unique_ptr<Technique> example = makeTechnique(technique, none);
    const std::vector<Setting> settings = settingsOf(*example);
    const auto found =
        std::find_if(settings.begin(), settings.end(), [](const Setting& setting) { return setting.key == "renders"; });
    if (found == settings.end()) return std::nullopt;
    return static_cast<std::size_t>(found - settings.begin());
}

/// What the session would set another technique to if it were chosen.
ProbeSubject otherSubject(Session& session, const std::string& technique) {
    if (const std::vector<double>* left = session.technique.settingsLeft(technique))
        return {technique, *left, session.moment.request.samplesPerPixel, session.moment.request.mapSize};
    TechniqueOptions chosen = session.options;
    chosen.technique = technique;
    return {technique, valuesOf(*techniqueFor(chosen, session.renderer.programs())),
            session.moment.request.samplesPerPixel, session.moment.request.mapSize};
}

std::vector<int> sampleCountsFor(const std::string& technique) {
    std::vector<int> sampleCounts;
    if (rendersPlace(technique))
        for (int renders = 1; renders <= 4096; renders *= 2) sampleCounts.push_back(renders);
    else
        for (int samples = 1; samples <= maximumSamplesPerPixel; ++samples) sampleCounts.push_back(samples);
    return sampleCounts;
}

void setSampleCount(ProbeSubject& subject, int sampleCount) {
    if (const auto place = rendersPlace(subject.technique))
        subject.settings[*place] = sampleCount;
    else
        subject.samplesPerPixel = sampleCount;
}

std::string amount(Accuracy::Level level, double value) {
    return level == Accuracy::Level::Time ? fmt::format("{:.3g} ms", value) : fmt::format("shadow error {:.3g}", value);
}

}  // namespace

ProbeSubject subjectOf(const Session& session) {
    return {session.technique.name(), valuesOf(session.technique.current()), session.moment.request.samplesPerPixel,
            session.moment.request.mapSize};
}

std::string sampleCountInWords(const ProbeSubject& subject) {
    const std::string& title = techniqueDescription(subject.technique).shortTitle;
    if (const auto place = rendersPlace(subject.technique))
        return fmt::format("{} at {:g} renders", title, subject.settings[*place]);
    return fmt::format("{} at {} spp", title, subject.samplesPerPixel);
}

std::string sampleCountLabel(const ProbeSubject& subject) {
    if (const auto place = rendersPlace(subject.technique)) return fmt::format("{:g}x", subject.settings[*place]);
    return std::to_string(subject.samplesPerPixel);
}

const ProbePoint* Accuracy::find(const ProbeSubject& subject) const {
    const auto found =
        std::find_if(trail_.begin(), trail_.end(), [&](const ProbePoint& point) { return point.subject == subject; });
    return found == trail_.end() ? nullptr : &*found;
}

const ProbePoint* Accuracy::current() const { return find(now_); }

void Accuracy::clear() {
    trail_.clear();
    said_.clear();
    match_.reset();
    ++revision_;
}

void Accuracy::match(Session& session, const std::string& technique, Level level) {
    const ProbePoint* of = current();
    if (of == nullptr) return;
    const bool time = level == Level::Time;
    said_.clear();
    match_ = Match{*of, otherSubject(session, technique), level,
                   SampleCountSearch(sampleCountsFor(technique), time ? of->milliseconds : of->shadowError,
                                     time ? SampleCountSearch::Value::Rises : SampleCountSearch::Value::Falls)};
}

std::string Accuracy::trying() const { return match_ ? sampleCountInWords(match_->other) : ""; }

std::optional<ProbeSubject> Accuracy::advanceMatch(Session& session) {
    while (const std::optional<int> sampleCount = match_->search.next()) {
        setSampleCount(match_->other, *sampleCount);
        const ProbePoint* known = find(match_->other);
        if (known == nullptr) return match_->other;
        match_->search.measured(match_->level == Level::Time ? known->milliseconds : known->shadowError);
    }
    finishMatch(session);
    return std::nullopt;
}

namespace {

/// As side B, on its own samples where they are others than those of A.
void showBeside(Session& session, const ProbeSubject& found) {
    const std::unique_ptr<Technique> technique = techniqueOf(found, session.renderer.programs());
    const bool own = found.samplesPerPixel != session.moment.request.samplesPerPixel;
    session.requests.comparison =
        wholeVariantOf(*technique) + ownSamplesText(own ? std::optional(found.samplesPerPixel) : std::nullopt);
}

}  // namespace

void Accuracy::finishMatch(Session& session) {
    Match match = *std::exchange(match_, std::nullopt);
    const SampleCountSearch& search = match.search;
    const bool time = match.level == Level::Time;
    setSampleCount(match.other, search.sampleCount());
    const std::string other =
        fmt::format("{} ({})", sampleCountInWords(match.other), amount(match.level, search.value()));
    const std::string current = fmt::format("{} ({})", sampleCountInWords(match.of.subject),
                                            amount(match.level, time ? match.of.milliseconds : match.of.shadowError));
    if (search.outcome() == SampleCountSearch::Outcome::Found) {
        said_ = fmt::format("{} matches {}.", other, current);
        showBeside(session, match.other);
        session.notify(said_);
        return;
    }
    said_ = fmt::format("Out of range: {} comes nearest to {}.", other, current);
    session.notify(said_, true);
}

bool Accuracy::update(Session& session) {
    const State before = state_;
    const int revisionBefore = revision_;
    const bool settled = session.driver.settled() && session.driver.hasPlan() && !session.driver.preview() &&
                         !session.driver.measuring();
    if (!std::exchange(wanted_, false) || session.moment.playback.playing() || !settled) {
        state_ = State::Waiting;
        return before != State::Waiting;
    }
    if (probe_.aim(session.scene.planner(), session.scene.number(), session.askedRequest())) clear();
    ProbeSubject now = subjectOf(session);
    if (now != now_) {
        now_ = std::move(now);
        match_.reset();  // it was looking for another point's equal
        ++revision_;
    }
    std::optional<ProbeSubject> next = match_ ? advanceMatch(session) : std::nullopt;
    if (!next && find(now_) == nullptr) next = now_;
    state_ = State::Idle;
    if (next) {
        probe_.measure(*next);
        const bool reference = !probe_.hasReferences();
        const std::optional<ProbePoint> point = probe_.step();
        state_ = reference ? State::Reference : State::Measuring;
        if (point) {
            trail_.push_back(*point);
            ++revision_;
        }
        if (!probe_.failure().empty()) {
            failure_ = probe_.failure();
            state_ = State::Failed;
            if (match_) session.notify(failure_, true);
            match_.reset();
        }
    }
    return working() || state_ != before || revision_ != revisionBefore;
}

}  // namespace timeshade
