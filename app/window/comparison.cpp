#include "window/comparison.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "compare/compared_techniques.h"
#include "compare/composed_picture.h"
#include "options_text.h"
#include "report.h"
#include "window/display_texture.h"
#include "window/milliseconds.h"
#include "window/session.h"

namespace timeshade {

namespace {

constexpr int numbersApart = 1000000;  // scenes and techniques are counted in one number

ProbeSubject subjectOfTechnique(Technique& technique, const FrameRequest& request) {
    ProbeSubject subject{technique.description().name, {}, request.samplesPerPixel, request.mapSize};
    for (const Setting& setting : settingsOf(technique)) subject.settings.push_back(setting.get());
    return subject;
}

}  // namespace

std::string variantOf(Technique& technique) {
    std::string variant = technique.description().name;
    for (const Setting& setting : settingsOf(technique))
        if (isChanged(setting)) variant += ":" + setting.key + "=" + textOf(setting);
    return variant;
}

void Comparison::choose(std::unique_ptr<Technique> technique) {
    technique_ = std::move(technique);
    ++number_;
    difference_.reset();
    points_.clear();
    if (technique_) return;
    driver_.reset();
    renderer_.reset();  // it holds buffers of the picture's size
}

void Comparison::swap(Session& session) {
    if (!on()) return;
    technique_ = session.technique.replace(std::move(technique_));
    ++number_;
}

bool Comparison::update(Session& session, const FrameDriver::Wanted& first) {
    if (!on()) return false;
    if (!renderer_) {
        renderer_.emplace();
        driver_.emplace(*renderer_);
    }
    bool changed = driver_->update(wantedOfSecond(first), session.now);
    changed = updateDifference(session) || changed;
    return updateErrors(session) || changed;
}

FrameDriver::Wanted Comparison::wantedOfSecond(const FrameDriver::Wanted& first) const {
    FrameDriver::Wanted wanted = first;
    wanted.technique = technique_.get();
    wanted.techniqueView.clear();
    wanted.scene += numbersApart * number_;
    return wanted;
}

bool Comparison::follows(const FrameDriver::Wanted& first) const {
    return !on() || (driver_ && driver_->follows(wantedOfSecond(first)));
}

bool Comparison::settled(const Session& session) const {
    const auto whole = [](const FrameDriver& driver) {
        return driver.settled() && driver.state() == FrameDriver::State::Complete && !driver.preview();
    };
    return on() && driver_ && whole(session.driver) && whole(*driver_);
}

std::optional<double> Comparison::sleep(double now) const {
    if (!on()) return std::nullopt;
    return driver_ ? driver_->sleep(now) : 0.0;
}

bool Comparison::updateDifference(Session& session) {
    const bool wanted = mode == CompareMode::Difference && !flip && settled(session);
    if (!wanted) return std::exchange(difference_, std::nullopt).has_value();
    if (difference_ && differenceOf_[0] == session.driver.begun() && differenceOf_[1] == driver_->begun()) return false;
    upload(difference_,
           composed(session.renderer.readPicture(), renderer_->readPicture(), CompareMode::Difference, seam));
    differenceOf_[0] = session.driver.begun();
    differenceOf_[1] = driver_->begun();
    return true;
}

bool Comparison::updateErrors(Session& session) {
    // What is measured is the whole shutter.
    if (!settled(session) || session.moment.playback.playing() || session.moment.instant || session.recording.on())
        return false;
    if (probe_.aim(session.scene.planner(), session.scene.number(), session.askedRequest())) points_.clear();
    pointsOf_ = session.driver.shown().moment;
    for (Technique* technique : {&session.technique.current(), technique_.get()}) {
        const ProbeSubject subject = subjectOfTechnique(*technique, session.moment.request);
        if (std::any_of(points_.begin(), points_.end(),
                        [&](const ProbePoint& point) { return point.subject == subject; }))
            continue;
        probe_.measure(subject);
        if (!probe_.failure().empty()) continue;
        if (const std::optional<ProbePoint> point = probe_.step()) points_.push_back(*point);
        return true;
    }
    return false;
}

std::string Comparison::label(const Session& session, bool ofSecond) const {
    const ShownPicture& shown = ofSecond ? driver_->shown() : session.driver.shown();
    std::string text = fmt::format("{}, map {}", shown.label, shown.drawn.mapSize.text());
    if (shown.instant) text += fmt::format(", u = {:.3g}", *shown.instant);
    if (shown.preview) text += ", preview";
    if (!shown.complete()) text += fmt::format(", {} done", shown.rendersDone);
    // What was measured is the whole picture, of that moment.
    const ProbeSubject subject{shown.technique, shown.settings, shown.drawn.samplesPerPixel, shown.drawn.mapSize};
    if (!shown.preview && shown.complete() && !shown.instant && shown.moment == pointsOf_)
        for (const ProbePoint& point : points_)
            if (point.subject == subject) text += ", " + errorInWords(point);
    if (shown.milliseconds > 0.0) text += ", " + inMilliseconds(shown.milliseconds);
    return text;
}

std::vector<std::string> Comparison::variants(Session& session) const {
    return {variantOf(session.technique.current()), variantOf(*technique_)};
}

DisplayImage Comparison::composedPicture(Session& session) {
    CompareOptions options = session.options;
    options.compareMode = mode;
    const int samples = session.moment.request.samplesPerPixel;
    return composedFor(options, seam,
                       {sampleCountLabel(session.technique.current(), samples), sampleCountLabel(*technique_, samples)},
                       {session.renderer.readPicture(), renderer_->readPicture()}, PictureText());
}

LinearImage Comparison::composedRadiance(Session& session) {
    return composed(session.renderer.readRadiance(), renderer_->readRadiance(), mode, seam);
}

std::string Comparison::manifests(Session& session) {
    nlohmann::ordered_json json;
    const auto add = [&](const FrameRenderer& renderer, Technique& technique, const FrameTimes& times) {
        json["compare"].push_back(nlohmann::ordered_json::parse(manifest(
            renderer, technique, session.scene.name(), session.scene.current(), session.backEnd, times.medians())));
    };
    add(session.renderer, session.technique.current(), session.driver.times());
    add(*renderer_, *technique_, driver_->times());
    return json.dump(2) + "\n";
}

}  // namespace timeshade
