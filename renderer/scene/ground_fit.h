#pragma once

#include "scene/ground.h"
#include "scene/scene.h"

namespace timeshade {

/// Whether the scene has no surface that could receive its things' shadows: of the area below what moves (or all, where
/// nothing or everything moves) and where its light throws that area's shadow, surfaces that face up and lie below
/// cover less than half.
bool lacksGround(const Scene& scene);

/// A square below the scene: a hair below the lowest point over the clip, by groundGap of the bounds' diagonal, so that
/// no surface lies in it; below the middle of the bounds; so large that the shadow of all of them that the scene's
/// light throws at any time of the clip lies on it, with a margin, but of a low light only the beginning.
GroundSquare fittedGround(const Scene& scene);

/// The bounds and the shadow that the scene's light throws of them on their lowest height, of a long one the beginning:
/// what a camera is fitted to that is to see both.
Bounds boundsWithShadow(const Scene& scene);

inline constexpr double groundGap = 1e-4;

}  // namespace timeshade
