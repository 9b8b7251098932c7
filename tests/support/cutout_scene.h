#pragma once

#include <cstdint>
#include <memory>

#include "scene/camera.h"
#include "scene/scene.h"

namespace timeshade {

/// A leaf that is cut out of a card by its alpha, over a ground; a second such card below it receives its shadow and
/// casts one of its own. The scene's time from 0 s to 1 s is one shutter, as in ProceduralScene.
struct CutoutSceneOptions {
    bool sun = false;        ///< instead of a spot
    bool lightMoves = true;  ///< the sun turns, the spot slides
    bool cardsMove = true;   ///< one slides, one turns
    bool cameraMoves = false;
    bool tilted = false;   ///< towards the light's grazing side
    bool cutsOut = true;   ///< false: the same cards, whole
    float cutoff = 0.5f;   ///< glTF's alphaCutoff
    float repeats = 1.0f;  ///< texture coordinates run from 0 to this, from -this where the image is mirrored
    Wrap wrap = Wrap::Clamp;
    bool nearest = false;
    bool closed = false;  ///< a box of such sides instead of the upper card
};

std::unique_ptr<Scene> makeCutoutScene(const CutoutSceneOptions& options);

/// From below the cards down to their shadows on the ground: it sees none of them.
CameraPose belowTheCards();

/// The leaf: alpha in every texel between 0 and 255, soft at its edges, with a hole.
Image leafImage(int side);

}  // namespace timeshade
