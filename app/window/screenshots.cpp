#include "window/screenshots.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "image/image_file.h"
#include "measure/view_scale.h"
#include "report.h"
#include "window/free_name.h"
#include "window/session.h"

namespace timeshade {

namespace {

DisplayImage pictureOf(Session& session) {
    if (session.comparison.on()) return session.comparison.composedPicture(session);
    if (session.diagnosticPicture.complete()) return session.diagnosticPicture.image();
    const DisplayImage picture = session.renderer.readPicture();
    return session.renderer.techniqueView() ? withScale(picture, *session.renderer.techniqueView()) : picture;
}

std::string manifestOf(Session& session) {
    if (session.comparison.on()) return session.comparison.manifests(session);
    return manifest(session.renderer, session.technique.current(), session.scene.name(), session.scene.current(),
                    session.backEnd, session.driver.times().medians());
}

/// It will become better by itself.
bool unfinished(const Session& session) {
    using State = FrameDriver::State;
    const State state = session.driver.state();
    if (state == State::Drawing) return true;
    if (state == State::Failed || state == State::Nothing) return false;
    if (state == State::Cancelled && !session.driver.preview()) return false;  // some renders
    return session.driver.preview() || (session.comparison.on() && !session.comparison.settled(session));
}

}  // namespace

bool Screenshots::update(Session& session) {
    if (!session.requests.screenshot) return false;
    if (session.driver.state() == FrameDriver::State::Cancelled && session.driver.preview()) session.driver.resume();
    if (unfinished(session)) return false;
    session.requests.screenshot = false;
    if (session.driver.picture() == nullptr) {
        session.notify("There is no picture to save.", true);
        return true;
    }
    try {
        save(session, std::exchange(session.requests.exr, false));
    } catch (const std::exception& error) {
        session.notify(error.what(), true);
    }
    return true;
}

void Screenshots::save(Session& session, bool exr) {
    std::filesystem::path path = std::filesystem::absolute(screenshotName(session)).lexically_normal();
    if (exr) {
        path = freeName(path.replace_extension(".exr"));
        const bool comparing = session.comparison.on();
        writeExr(path, comparing ? session.comparison.composedRadiance(session) : session.renderer.readRadiance());
    } else {
        path = freeName(path);
        writePng(path, pictureOf(session), manifestOf(session));
    }
    lastPath_ = path.string();
    ++count_;
    session.notify("Saved " + lastPath_);
}

std::string screenshotName(const Session& session) {
    std::string name = std::filesystem::path(session.scene.name()).stem().string();
    for (char& c : name)
        if (c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20) c = '_';
    const double frame = session.moment.playback.frame();
    const std::string number =
        frame == std::floor(frame) && frame >= 0.0 ? fmt::format("{:04.0f}", frame) : fmt::format("{:g}", frame);
    return fmt::format("timeshade-{}-{}-{}.png", name, session.technique.name(), number);
}

}  // namespace timeshade
