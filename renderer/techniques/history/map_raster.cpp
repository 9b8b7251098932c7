#include "techniques/history/map_raster.h"

namespace timeshade {

namespace {

constexpr double rightAngle = 1.57079632679489662;

MapGrid gridOf(MapJitter jitter, std::uint32_t index, const glm::dvec2& texel) {
    MapGrid grid;
    if (jitter == MapJitter::ShiftAndTurn) grid.angle = rightAngle * radicalInverse(5, index + 1);
    if (jitter != MapJitter::None)
        grid.shift = (glm::dvec2(radicalInverse(2, index + 1), radicalInverse(3, index + 1)) - 0.5) * texel;
    return grid;
}

}  // namespace

double radicalInverse(std::uint32_t base, std::uint32_t index) {
    double value = 0.0, digit = 1.0;
    for (; index > 0; index /= base) {
        digit /= base;
        value += digit * (index % base);
    }
    return value;
}

FittedMap mapRaster(const FramePlan& plan, MapFit fit, MapJitter jitter, std::uint32_t index) {
    if (jitter == MapJitter::None && fit == MapFit::Light) return {};
    const MapGrid grid = gridOf(jitter, index, 1.0 / plan.request.mapSize.sides());
    if (fit == MapFit::Seen && (plan.motion.cameraMoves || plan.motion.lightMoves)) {
        FittedMap whole = fitMap(plan, MapFit::Light, grid);
        whole.shortfall = plan.motion.lightMoves
                              ? "the light moves within the shutter, so the map covers all that the light reaches"
                              : "the camera moves within the shutter, so the map covers all that the light reaches";
        return whole;
    }
    return fitMap(plan, fit, grid);
}

}  // namespace timeshade
