#include "window/diagnostic_picture.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "core/pause.h"
#include "frame/warm_up.h"
#include "gl/errors.h"
#include "window/display_texture.h"
#include "window/session.h"

namespace timeshade {

namespace {
constexpr auto budget = std::chrono::milliseconds(30);
constexpr int longestSide = AccuracyProbe::longestSide;
}  // namespace

bool DiagnosticPicture::update(Session& session, int pictureWidth) {
    const bool settled = session.driver.settled() && session.driver.hasPlan() && !session.driver.preview();
    const bool wanted = session.view.diagnostic != Diagnostic::None && !session.moment.playback.playing() && settled;
    if (!wanted) {
        const bool shown = complete();
        texture_.reset();
        key_.clear();
        failed_ = false;
        caption_ = session.view.diagnostic == Diagnostic::None ? "" : "waiting for the picture to be still";
        return shown;
    }
    const FrameRequest small = smallCopyOf(session.askedRequest(), longestSide);
    std::vector<double> key = smallCopyKey(small, session.scene.number());
    // One size larger than the place, which then shrinks it: letters and squares stay crisp.
    enlarged_ = std::clamp((pictureWidth + small.width - 1) / small.width, 1, 16);
    key.insert(key.end(), {double(session.view.diagnostic), double(enlarged_)});
    ProbeSubject subject = subjectOf(session);
    if (key == key_ && subject == subject_ && (complete() || failed_)) return false;
    try {
        if (key != key_ || subject != subject_) begin(session, std::move(key), subject);
        step();
    } catch (const WorkCancelled&) {
        key_.clear();  // begins anew
        throw;
    } catch (const std::exception& error) {
        failed_ = true;
        caption_ = error.what();
        technique_.reset();
        gl::takeErrors();  // not to be taken for the next picture's
    }
    return true;
}

void DiagnosticPicture::begin(Session& session, std::vector<double> key, const ProbeSubject& subject) {
    key_ = std::move(key);
    subject_ = subject;
    ofError_ = session.view.diagnostic == Diagnostic::Error;
    failed_ = false;
    drawing_ = false;
    texture_.reset();
    verification_.reset();
    reference_.reset();
    if (!renderer_) renderer_.emplace();
    technique_ = techniqueOf(subject, renderer_->programs());
    const FrameRequest small = smallCopyOf(session.askedRequest(), longestSide);
    drawWarmUp(*renderer_, session.scene.planner(), *technique_, small, View::Visibility);
    plan_ = session.scene.planner().plan(small);
    if (ofError_) {
        FrameRequest many = small;
        many.samplesPerPixel = maximumSamplesPerPixel;
        ReferenceOptions options;
        options.samplesPerPixel = AccuracyProbe::referenceSamples;
        reference_ = std::make_unique<ReferenceBuilder>(session.scene.planner().plan(many), options, cache_);
        return;
    }
    disagreement_ = std::make_unique<DisagreementView>(small.width, small.height);
    VerificationOptions options;
    options.checkPrimaries = false;
    options.footprint.samples = 0;
    options.visit = [view = disagreement_.get()](const VerifiedSample& sample) { view->add(sample); };
    verification_ = std::make_unique<FrameVerification>(*renderer_, *plan_, *technique_, options);
}

void DiagnosticPicture::step() {
    if (ofError_)
        compareWithReference();
    else
        verify();
}

void DiagnosticPicture::compareWithReference() {
    if (!reference_->complete()) {
        reference_->step(*renderer_);
        caption_ = fmt::format("making the reference: {} of {}", reference_->batchesDone(), reference_->batches());
    } else if (drawFinal()) {
        finish(errorView(renderer_->readRadiance(), reference_->image(), 1.0, enlarged_),
               fmt::format("|difference| at {} × {}, against {} samples a pixel", plan_->request.width,
                           plan_->request.height, reference_->samplesPerPixel()));
    }
}

void DiagnosticPicture::verify() {
    if (verification_->rendersDone() < verification_->renders()) {
        const auto begin = std::chrono::steady_clock::now();
        while (!verification_->step() && std::chrono::steady_clock::now() - begin < budget) {
        }
        caption_ =
            fmt::format("asking the ray tracer: {} of {}", verification_->rendersDone(), verification_->renders());
    } else if (drawFinal()) {
        const Verification result = verification_->result();
        finish(disagreement_->draw(renderer_->readPicture(), enlarged_),
               fmt::format("at {} × {}: {:.3g} % of the samples disagree", plan_->request.width, plan_->request.height,
                           1e-4 * result.ppm()));
    }
}

bool DiagnosticPicture::drawFinal() {
    if (!drawing_) renderer_->begin(*plan_, *technique_, View::Final);
    drawing_ = true;
    const auto begin = std::chrono::steady_clock::now();
    while (!renderer_->step() && std::chrono::steady_clock::now() - begin < budget) {
    }
    renderer_->timer().dropAll();  // its time is of no interest
    return renderer_->complete();
}

void DiagnosticPicture::finish(DisplayImage image, std::string caption) {
    image_ = std::move(image);
    caption_ = std::move(caption);
    upload(texture_, image_);
    texture_->setFilters(GL_LINEAR, GL_LINEAR);
    // All that is large: it is not needed until something changes, and then made anew.
    verification_.reset();
    disagreement_.reset();
    technique_.reset();
}

}  // namespace timeshade
