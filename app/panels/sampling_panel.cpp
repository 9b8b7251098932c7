#include <algorithm>

#include <fmt/format.h>

#include "panels/panels.h"

namespace timeshade {

namespace {

void drawMapSize(Session& session, Widgets& widgets) {
    std::vector<MapSize> sizes;
    for (int size = 64; size <= maximumMapSide; size *= 2) sizes.emplace_back(size);
    MapSize& mapSize = session.moment.request.mapSize;
    if (std::find(sizes.begin(), sizes.end(), mapSize) == sizes.end()) sizes.push_back(mapSize);
    std::vector<std::string> names;
    for (const MapSize& size : sizes) names.push_back(fmt::format("{} × {}", size.width, size.height));
    const auto current = static_cast<std::size_t>(std::find(sizes.begin(), sizes.end(), mapSize) - sizes.begin());
    if (const auto chosen =
            widgets.combo("map", "Shadow map size", names, current,
                          "Texels of the shadow map. Finer shadows; memory and time grow with the square."))
        mapSize = sizes[*chosen];
}

void drawShutter(Session& session, Widgets& widgets) {
    const SceneDefaults& defaults = session.scene.current().defaults();
    Shutter shutter = session.moment.request.shutter;
    Widgets::Number length;
    length.maximum = shutter.length > 2.0 ? 16.0 : 2.0;
    length.most = 16.0;
    length.format = fmt::format("%.2f frames, {:.0f}°", 360.0 * shutter.length);
    length.defaultValue = defaults.shutterLength;
    length.help =
        "How long the shutter is open. 1 frame is 360 degrees; film uses half of that. Ctrl-click to type up to 16.";
    bool changed = widgets.slider("shutter", "Shutter", shutter.length, length);

    const auto position = widgets.combo(
        "shutter.position", "Shutter position", {"Start", "Centre", "End"}, static_cast<std::size_t>(shutter.position),
        "Where the frame's instant lies in the time that the shutter is open.", {"start", "centre", "end"});
    if (position) shutter.position = static_cast<ShutterPosition>(*position);

    const auto response = widgets.combo(
        "shutter.response", "Shutter response", {"Box", "Tent", "Gaussian"}, static_cast<std::size_t>(shutter.response),
        "How much each instant of the shutter counts: all alike; or less towards its ends, where streaks then fade.",
        {"box", "tent", "gaussian"});
    if (response) shutter.response = static_cast<ShutterResponse>(*response);
    if (shutter.response == ShutterResponse::Gaussian) {
        Widgets::Number width;
        width.minimum = Shutter::leastWidth;
        width.maximum = 1.0;
        width.most = Shutter::mostWidth;
        width.format = "%.3f of the shutter";
        width.defaultValue = Shutter{}.width;
        width.help =
            "Standard deviation of the Gaussian, which is cut at the shutter's ends. Ctrl-click to type up to 2.";
        changed = widgets.slider("shutter.width", "Gaussian width", shutter.width, width) || changed;
    }

    Widgets::Number rate;
    rate.minimum = 1.0;
    rate.maximum = 120.0;
    rate.least = 0.1;
    rate.most = 10000.0;
    rate.format = "%.4g fps";
    rate.logarithmic = true;
    rate.defaultValue = defaults.framesPerSecond;
    rate.help = "Frames per second. Fewer make each frame, and so the blur, longer.";
    changed = widgets.slider("fps", "Frame rate", shutter.framesPerSecond, rate) || changed;
    if (changed || position || response) session.moment.setShutter(shutter, session.scene.current().duration());
}

}  // namespace

void drawSamplingPanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.sampling", "Sampling and shutter", true)) return;
    widgets.checkbox("pixel_centres", "Pixel centres", session.moment.request.pixelCentres, false,
                     "Samples lie at the centres of pixels instead of one random place of the pixel each, at the same "
                     "times: edges as of a rasteriser, without antialiasing. A technique may ask for it by itself.");
    drawMapSize(session, widgets);
    drawShutter(session, widgets);
    Widgets::Number seed;
    seed.maximum = 100.0;
    seed.format = "%d";
    seed.help = "Of all random numbers. The same seed gives the same picture.";
    // ImGui's sliders stop the program where an end lies beyond half of the whole numbers.
    int value = static_cast<int>(std::min(session.moment.request.seed, 0x3fffffffu));
    if (value > 100) seed.maximum = value;
    if (widgets.slider("seed", "Seed", value, seed)) session.moment.request.seed = static_cast<std::uint32_t>(value);
}

}  // namespace timeshade
