#include "window/comparison.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "compare/compared_shot.h"
#include "compare/compared_techniques.h"
#include "compare/composed_picture.h"
#include "core/error.h"
#include "measure/reference_technique.h"
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

std::string ownSamplesText(const std::optional<int>& samples) {
    return samples ? fmt::format(":spp={}", *samples) : "";
}

std::string wholeVariantOf(Technique& technique) {
    std::string variant = technique.description().name;
    for (const Setting& setting : settingsOf(technique)) variant += ":" + setting.key + "=" + textOf(setting);
    return variant;
}

std::string variantOf(Technique& technique) {
    std::string variant = technique.description().name;
    for (const Setting& setting : settingsOf(technique))
        if (isChanged(setting)) variant += ":" + setting.key + "=" + textOf(setting);
    return variant;
}

Comparison::Partner Comparison::partnerOf(const std::string& text, const SettingTexts& settings,
                                          gl::ProgramCache& programs) {
    Partner partner;
    if (text.empty()) return partner;
    const ComparedSide side = ComparedSide::of(text);
    partner.kind = side.kind;
    partner.samplesPerPixel = side.samplesPerPixel;
    switch (side.kind) {
    case ComparedSide::Kind::Technique: partner.technique = side.variant.make(settings, programs); break;
    case ComparedSide::Kind::Truth: partner.technique = std::make_unique<ReferenceTechnique>(); break;
    case ComparedSide::Kind::File:
        if (side.path.find(',') != std::string::npos)
            throw UsageError(
                fmt::format("{}: a picture's name has a comma, which --compare takes for the end of it; "
                            "expected a name without",
                            side.path));
        partner.file.emplace(side.path);
    }
    return partner;
}

void Comparison::choose(Partner partner) {
    partner_ = std::move(partner);
    ++number_;
    difference_.reset();
    points_.clear();
    truth_.clear();
    fileTexture_.reset();
    complaint_.clear();
    if (partner_.technique) return;
    driver_.reset();
    renderer_.reset();  // it holds buffers of the picture's size
}

void Comparison::swap(Session& session) {
    if (!on()) return;
    if (!isTechnique())
        return session.notify(isTruth() ? "The ground truth can't be side A: that is a technique"
                                        : "A file can't be side A: that is a technique",
                              true);
    partner_.technique = session.technique.replace(std::move(partner_.technique));
    if (partner_.samplesPerPixel) std::swap(*partner_.samplesPerPixel, session.moment.request.samplesPerPixel);
    ++number_;
}

bool Comparison::update(Session& session, const FrameDriver::Wanted& first) {
    if (!on()) return false;
    if (isFile()) return updateFile(first) | updateStill(session, first);
    if (!renderer_) {
        renderer_.emplace();
        driver_.emplace(*renderer_);
    }
    const bool changed = driver_->update(wantedOfSecond(first), session.now);
    return updateStill(session, first) || changed;
}

/// Puts the file's picture on the screen, where its size is that of the other.
bool Comparison::updateFile(const FrameDriver::Wanted& first) {
    const FrameRequest& request = first.request;
    std::string complaint;
    if (!partner_.file->hasSize(request.width, request.height))
        complaint = fmt::format("{} is {} x {}, this picture {} x {}", partner_.file->label(), partner_.file->width(),
                                partner_.file->height(), request.width, request.height);
    bool changed = std::exchange(complaint_, complaint) != complaint;
    if (!fileTexture_ || fileLook_ != request.look) {
        fileLook_ = request.look;
        upload(fileTexture_, partner_.file->shown(fileLook_));
        ++number_;
        changed = true;
    }
    return changed;
}

/// What is found out once both pictures are whole: a first ground truth, errors, and then all of the ground truth.
bool Comparison::updateStill(Session& session, const FrameDriver::Wanted& first) {
    bool changed = false;
    if (isTruth()) {
        const FrameDriver::Wanted second = wantedOfSecond(first);
        const bool may = bothWhole(session) && !first.moving;
        if (!may && truth_.samples() > 0 && !truth_.follows(second)) {
            truth_.clear();
            changed = true;
        }
        if (may && (truth_.samples() == 0 || !truth_.follows(second) || !updateErrors(session)))
            changed = truth_.update(second);
        else
            changed = changed || may;
    } else {
        changed = updateErrors(session);
    }
    return updateDifference(session) || changed;
}

FrameDriver::Wanted Comparison::wantedOfSecond(const FrameDriver::Wanted& first) const {
    FrameDriver::Wanted wanted = first;
    wanted.technique = partner_.technique.get();
    wanted.techniqueView.clear();
    if (partner_.samplesPerPixel) wanted.request.samplesPerPixel = *partner_.samplesPerPixel;
    wanted.scene += numbersApart * number_;
    return wanted;
}

bool Comparison::follows(const FrameDriver::Wanted& first) const {
    return !on() || isFile() || (driver_ && driver_->follows(wantedOfSecond(first)));
}

const gl::Texture* Comparison::picture() const {
    if (!on()) return nullptr;
    if (isFile()) return fileTexture_ && complaint_.empty() ? &*fileTexture_ : nullptr;
    if (truth_.picture() != nullptr) return truth_.picture();
    return driver_ ? driver_->picture() : nullptr;
}

bool Comparison::bothWhole(const Session& session) const {
    const auto whole = [](const FrameDriver& driver) {
        return driver.settled() && driver.state() == FrameDriver::State::Complete && !driver.preview();
    };
    return on() && whole(session.driver) && (isFile() || (driver_ && whole(*driver_)));
}

bool Comparison::settled(const Session& session) const { return bothWhole(session) && (!isTruth() || truth_.rests()); }

std::optional<double> Comparison::sleep(double now) const {
    if (!on() || isFile()) return std::nullopt;
    return driver_ ? driver_->sleep(now) : 0.0;
}

const FilePicture& Comparison::fittingFile(const FrameRequest& request) const {
    partner_.file->requireSize(request.width, request.height);
    return *partner_.file;
}

DisplayImage Comparison::secondImage(const FrameRequest& request) {
    if (isFile()) return fittingFile(request).shown(request.look);
    return truth_.samples() > 0 ? truth_.image() : renderer_->readPicture();
}

LinearImage Comparison::secondRadiance(const FrameRequest& request) {
    if (isFile()) return fittingFile(request).radiance();
    return truth_.samples() > 0 ? truth_.radiance() : renderer_->readRadiance();
}

bool Comparison::updateDifference(Session& session) {
    const bool wanted = mode == CompareMode::Difference && !flip && bothWhole(session) && complaint_.empty();
    if (!wanted) return std::exchange(difference_, std::nullopt).has_value();
    const PictureDifference::Key key{session.driver.begun(), driver_ ? driver_->begun() : number_, truth_.samples(),
                                     gain};
    if (difference_ && difference_->key() == key) return false;
    difference_.emplace(key, session.renderer.readPicture(), secondImage(session.moment.request), gain);
    return true;
}

bool Comparison::updateErrors(Session& session) {
    // What is measured is the whole shutter.
    if (!bothWhole(session) || session.moment.playback.playing() || session.moment.instant || session.recording.on())
        return false;
    if (probe_.aim(session.scene.planner(), session.scene.number(), session.askedRequest())) points_.clear();
    pointsOf_ = session.driver.shown().moment;
    FrameRequest ofSecond = session.moment.request;
    if (partner_.samplesPerPixel) ofSecond.samplesPerPixel = *partner_.samplesPerPixel;
    std::vector<ProbeSubject> subjects{subjectOfTechnique(session.technique.current(), session.moment.request)};
    if (technique() != nullptr) subjects.push_back(subjectOfTechnique(*technique(), ofSecond));
    for (const ProbeSubject& subject : subjects) {
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
    if (ofSecond && isFile()) return complaint_.empty() ? partner_.file->label() : complaint_;
    if (ofSecond && truth_.samples() > 0) return truthLabel(truth_.samples());
    const ShownPicture& shown = ofSecond ? driver_->shown() : session.driver.shown();
    std::string text = shown.label;
    if (shown.technique != truthName) text += fmt::format(", map {}", shown.drawn.mapSize.text());
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

std::string Comparison::labelOfSecond(int samplesPerPixel) const {
    if (isFile()) return partner_.file->label();
    if (truth_.samples() > 0) return truthLabel(truth_.samples());
    return sampleCountLabel(*partner_.technique, partner_.samplesPerPixel.value_or(samplesPerPixel));
}

std::vector<std::string> Comparison::variants(Session& session) const {
    return {variantOf(session.technique.current()), second(variantOf)};
}

std::string Comparison::wholeVariant() const { return second(wholeVariantOf); }

std::string Comparison::second(std::string (*textOf)(Technique&)) const {
    if (isFile()) return std::filesystem::absolute(partner_.file->path()).lexically_normal().string();
    if (isTruth()) return truthName;
    return textOf(*partner_.technique) + ownSamplesText(partner_.samplesPerPixel);
}

std::size_t Comparison::bytes() const {
    std::size_t bytes = truth_.bytes() + (difference_ ? difference_->bytes() : 0);
    if (renderer_) bytes += renderer_->memory().total();
    if (partner_.file) bytes += partner_.file->bytes();
    if (fileTexture_) bytes += fileTexture_->bytes();
    return bytes;
}

DisplayImage Comparison::composedPicture(Session& session) {
    CompareOptions options = session.options;
    options.compareMode = mode;
    options.compareGain = gain;
    const int samples = session.moment.request.samplesPerPixel;
    return composedFor(options, seam, {sampleCountLabel(session.technique.current(), samples), labelOfSecond(samples)},
                       {session.renderer.readPicture(), secondImage(session.moment.request)}, PictureText());
}

LinearImage Comparison::composedRadiance(Session& session) {
    return composed(session.renderer.readRadiance(), secondRadiance(session.moment.request), mode, seam);
}

std::string Comparison::manifests(Session& session) {
    nlohmann::ordered_json json;
    const auto add = [&](const FrameRenderer& renderer, Technique& technique, const FrameTimes& times) {
        json["compare"].push_back(nlohmann::ordered_json::parse(manifest(
            renderer, technique, session.scene.name(), session.scene.current(), session.backEnd, times.medians())));
    };
    add(session.renderer, session.technique.current(), session.driver.times());
    if (isTechnique()) {
        add(*renderer_, *partner_.technique, driver_->times());
    } else {
        const std::string name = isFile() ? partner_.file->path() : truthName;
        const FrameRequest& request = session.moment.request;
        const int samples = isFile()               ? 0
                            : truth_.samples() > 0 ? truth_.samples()
                                                   : driver_->shown().drawn.samplesPerPixel;
        json["compare"].push_back(
            nlohmann::ordered_json::parse(manifestOfSide(name, samples, request.width, request.height)));
    }
    return json.dump(2) + "\n";
}

}  // namespace timeshade
