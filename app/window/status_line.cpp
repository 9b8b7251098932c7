#include "window/status_line.h"

#include <fmt/format.h>

#include "window/milliseconds.h"
#include "window/session.h"

namespace timeshade {

std::string statusOf(const Session& session) {
    if (session.driver.state() == FrameDriver::State::Failed) return "This frame can't be rendered";
    const ShownPicture& shown = session.driver.shown();
    if (shown.number == 0) return "Rendering first frame...";
    const int samples = shown.instants > 1 ? shown.instants : shown.drawn.samplesPerPixel;
    const std::string cost = shown.milliseconds > 0.0 ? ", " + inMilliseconds(shown.milliseconds) : "";
    return fmt::format("{}{} x {}, {} {}, map {}{}", shown.preview ? "Preview " : "", shown.drawn.width,
                       shown.drawn.height, samples, shown.instants > 1 ? "renders" : "spp", shown.drawn.mapSize.text(),
                       cost);
}

}  // namespace timeshade
