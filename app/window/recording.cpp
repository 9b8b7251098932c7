#include "window/recording.h"

#include <algorithm>
#include <exception>
#include <filesystem>

#include <fmt/format.h>

#include "record/video_file.h"
#include "window/free_name.h"
#include "window/session.h"

namespace timeshade {

namespace {

/// The upper left part of a picture.
DisplayImage cropped(const DisplayImage& picture, int width, int height) {
    DisplayImage result{width, height, {}};
    result.rgb.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    for (int y = 0; y < height; ++y)
        std::copy_n(picture.rgb.begin() + static_cast<std::ptrdiff_t>(y) * picture.width * 3, width * 3,
                    result.rgb.begin() + static_cast<std::ptrdiff_t>(y) * width * 3);
    return result;
}

bool whole(const Session& session) {
    if (session.comparison.on()) return session.comparison.settled(session);
    return session.driver.settled() && session.driver.state() == FrameDriver::State::Complete &&
           !session.driver.preview();
}

}  // namespace

void Recording::start(Session& session) {
    const std::filesystem::path name = std::filesystem::path(session.scene.name()).stem();
    const std::string file = fmt::format("timeshade-{}-{}.mp4", name.string(), session.technique.name());
    path_ = freeName(std::filesystem::absolute(file).lexically_normal()).string();
    VideoFormat format;
    format.width = width_ = session.moment.request.width & ~1;
    format.height = height_ = session.moment.request.height & ~1;
    format.framesPerSecond = session.moment.request.shutter.framesPerSecond;
    frames_ = 0;
    session.moment.playback.play(false);
    try {
        sink_ = std::make_unique<VideoFile>(path_, format);
        session.driver.warmUp();
        session.comparison.warmUp();
    } catch (const std::exception& error) {
        fail(session, error.what());
    }
}

void Recording::stop(Session& session) {
    if (!on()) return;
    const std::unique_ptr<FrameSink> sink = std::move(sink_);
    if (frames_ == 0) return session.notify("Nothing was recorded: no frame was whole yet.", true);
    try {
        sink->finish();
        lastPath_ = path_;
        session.notify(fmt::format("Recorded {} frames: {}", frames_, path_));
    } catch (const std::exception& error) {
        fail(session, error.what());
    }
}

bool Recording::update(Session& session) {
    if (!on()) return false;
    if (session.driver.state() == FrameDriver::State::Failed) {
        stop(session);
        return true;
    }
    if (!whole(session)) return true;
    try {
        const DisplayImage picture =
            session.comparison.on() ? session.comparison.composedPicture(session) : session.renderer.readPicture();
        if ((picture.width & ~1) != width_ || (picture.height & ~1) != height_) {
            stop(session);
            session.notify(fmt::format("The picture's size has changed: {} frames were recorded.", frames_), true);
            return true;
        }
        sink_->add(cropped(picture, width_, height_));
        ++frames_;
        session.moment.playback.step(1);
    } catch (const std::exception& error) {
        fail(session, error.what());
    }
    return true;
}

void Recording::fail(Session& session, const std::string& why) {
    sink_.reset();
    session.notify(why, true);
}

}  // namespace timeshade
