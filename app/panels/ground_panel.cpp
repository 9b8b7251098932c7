#include "panels/panels.h"
#include "panels/theme.h"
#include "scene/grounded_scene.h"
#include "scene_catalogue.h"

namespace timeshade {

void drawGroundPanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.ground", "Ground", false)) return;
    const Scene& scene = session.scene.current();
    if (dynamic_cast<const GroundedScene*>(&scene) == nullptr) {
        widgets.paragraph("This scene is computed and has a ground of its own.", theme::quiet);
        return;
    }
    GroundSettings wanted = session.options.ground;
    const auto choice = widgets.combo(
        "ground", "Ground", {"Automatic", "On", "Off"}, static_cast<std::size_t>(wanted.choice),
        "A still square below the file's things, on which their shadow falls. Automatic adds one where no surface of "
        "the file lies below them.",
        {"auto", "on", "off"});
    if (choice) wanted.choice = static_cast<GroundChoice>(*choice);
    if (const std::optional<GroundSquare>& square = scene.ground()) {
        const double size = std::max(scene.bounds().diagonal(), 1e-9), low = scene.bounds().low.y;
        Widgets::Number height;
        height.minimum = low - size;
        height.maximum = low + size;
        height.least = -1e9;
        height.most = 1e9;
        height.format = "%.4g";
        height.help = "World units.";
        double value = square->centre.y;
        if (widgets.slider("ground.height", "Height", value, height)) wanted.height = value;
        Widgets::Number side;
        side.minimum = 0.5 * size;
        side.maximum = 50.0 * size;
        side.least = 1e-9;
        side.most = 1e9;
        side.logarithmic = true;
        side.format = "%.4g";
        side.help = "Side of the square, in world units.";
        value = square->side;
        if (widgets.slider("ground.size", "Size", value, side)) wanted.size = value;
    } else {
        widgets.paragraph("No ground is added.", theme::quiet);
    }
    if (wanted != GroundSettings{} && widgets.button("ground.reset", "Reset ground")) wanted = {};
    if (wanted != session.options.ground) session.requests.ground = wanted;
}

}  // namespace timeshade
