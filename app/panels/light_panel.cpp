#include <cmath>

#include "frame_setup.h"
#include "light_text.h"
#include "panels/panels.h"
#include "panels/theme.h"

namespace timeshade {

namespace {

void drawLightList(Session& session, Widgets& widgets) {
    std::vector<std::string> names = session.scene.current().lights();
    if (names.empty()) return;
    names.push_back("Fitted to the scene");
    const std::size_t current = session.scene.current().chosenLight();
    const auto chosen = widgets.combo("light", "Light", names, current, "Which of the file's lights there is.");
    if (!chosen || *chosen == current) return;
    SceneChoice choice = choiceOf(session.options);
    choice.light = *chosen + 1 == names.size() ? "fitted" : names[*chosen];
    session.requests.choice = choice;
}

/// As in the scene where it is not changed; what is set back to that is unchanged again.
void drawDirection(LightChange& light, const LightDirection& own, Widgets& widgets) {
    LightDirection direction = light.direction.value_or(own);
    Widgets::Number azimuth;
    azimuth.minimum = -180.0;
    azimuth.maximum = 180.0;
    azimuth.least = -360.0;
    azimuth.most = 360.0;
    azimuth.format = "%.1f°";
    azimuth.defaultValue = own.azimuth;
    azimuth.help =
        "Where the light comes from, about the vertical: 0 along +z, 90 along +x. A light that is placed "
        "stands still but for the motion below.";
    bool changed = widgets.slider("light.azimuth", "Azimuth", direction.azimuth, azimuth);
    Widgets::Number elevation = azimuth;
    elevation.minimum = -90.0;
    elevation.maximum = 90.0;
    elevation.least = elevation.most = std::nullopt;
    elevation.defaultValue = own.elevation;
    elevation.help = "How high the light stands above the horizon, seen from the scene's centre.";
    changed = widgets.slider("light.elevation", "Elevation", direction.elevation, elevation) || changed;
    if (!changed) return;
    light.direction = direction;
    if (direction == own) light.direction.reset();
}

void drawOptional(const std::string& id, const std::string& label, std::optional<double>& value, double own,
                  Widgets::Number number, Widgets& widgets) {
    double shown = value.value_or(own);
    number.defaultValue = own;
    if (!widgets.slider(id, label, shown, number)) return;
    value = shown;
    if (shown == own) value.reset();
}

void drawSpot(LightChange& light, const LightPose& own, const Bounds& bounds, Widgets& widgets) {
    const double size = std::max(bounds.diagonal(), 1e-9);
    Widgets::Number distance;
    distance.minimum = 0.05 * size;
    distance.maximum = 10.0 * size;
    distance.least = 1e-9;
    distance.most = 1e9;
    distance.logarithmic = true;
    distance.format = "%.4g";
    distance.help = "Of the light from the scene's centre, in world units. Near lights move the shadow's edge more.";
    drawOptional("light.distance", "Distance", light.distance, glm::length(own.position - bounds.centre()), distance,
                 widgets);
    Widgets::Number cone;
    cone.minimum = 1.0;
    cone.maximum = LightChange::mostCone;
    cone.least = LightChange::leastCone;
    cone.format = "%.1f°";
    cone.help = "From the light's axis to the edge of what it lights. Narrow cones use the shadow map better.";
    drawOptional("light.cone", "Cone", light.cone, glm::degrees(own.outerConeAngle), cone, widgets);
    Widgets::Number move;
    move.minimum = -0.25 * size;
    move.maximum = 0.25 * size;
    move.least = -1e9;
    move.most = 1e9;
    move.format = "%.3g / frame";
    move.defaultValue = 0.0;
    move.help = "World units a frame along this axis. The light is where it is set at the scene's own frame.";
    widgets.slider("light.move.x", "Moves along x", light.move.x, move);
    widgets.slider("light.move.y", "Moves along y", light.move.y, move);
    widgets.slider("light.move.z", "Moves along z", light.move.z, move);
}

void drawTurn(LightChange& light, Widgets& widgets) {
    Widgets::Number turn;
    turn.minimum = -45.0;
    turn.maximum = 45.0;
    turn.least = -360.0;
    turn.most = 360.0;
    turn.format = "%.1f° / frame";
    turn.defaultValue = 0.0;
    turn.help = "How far the light's direction turns about the vertical in a frame. A shutter takes 90 degrees.";
    widgets.slider("light.turn", "Turns", light.turn, turn);
    turn.help = "How far the light's direction rises in a frame.";
    widgets.slider("light.rise", "Rises", light.rise, turn);
}

void drawLook(DisplayLook& look, Widgets& widgets) {
    Widgets::Number exposure;
    exposure.minimum = -4.0;
    exposure.maximum = 4.0;
    exposure.least = DisplayLook::leastExposure;
    exposure.most = DisplayLook::mostExposure;
    exposure.format = "%+.2f stops";
    exposure.defaultValue = 0.0;
    exposure.help = "Above the exposure that is fitted to the scene. Of what is shown; EXR files hold radiance.";
    widgets.slider("exposure", "Exposure", look.exposure, exposure);
    const auto toneMap =
        widgets.combo("tone-map", "Tone map", {"Filmic", "Reinhard", "Linear"}, static_cast<std::size_t>(look.toneMap),
                      "How radiance becomes what a screen shows.", {"filmic", "reinhard", "linear"});
    if (toneMap) look.toneMap = static_cast<ToneMap>(*toneMap);
}

}  // namespace

void drawLightPanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.light", "Light", false)) return;
    const Scene& scene = session.scene.current();
    const LightPose own = lightAtOwnFrame(scene);
    LightChange& light = session.moment.request.light;
    drawLightList(session, widgets);
    drawDirection(light, directionOf(own, scene.bounds().centre()), widgets);
    Widgets::Number intensity;
    intensity.maximum = 4.0;
    intensity.most = 1e6;
    intensity.format = "%.3gx";
    intensity.defaultValue = 1.0;
    intensity.help = "Times the scene's own.";
    widgets.slider("light.intensity", "Intensity", light.intensity, intensity);
    if (own.kind == LightKind::Spot) drawSpot(light, own, scene.bounds(), widgets);
    drawTurn(light, widgets);
    drawLook(session.moment.request.look, widgets);
    if ((light != LightChange{} || session.moment.request.look != DisplayLook{}) &&
        widgets.button("light.reset", "Reset light and exposure")) {
        light = {};
        session.moment.request.look = {};
    }
    widgets.paragraph("In the picture: Ctrl-drag moves the light around the scene.", theme::quiet);
}

}  // namespace timeshade
