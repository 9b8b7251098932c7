#include "panels/technique_pages.h"

#include <map>

namespace timeshade {

TechniquePage pageOf(const std::string& technique) {
    static const std::map<std::string, TechniquePage> pages{
        {"static",
         {"All motion: whatever moves throws the sharp shadow of one instant, the middle of the shutter.",
          "octopus: the arms are blurred, their shadows are not.", "Shadows of arms, left static, right as they are."}},
        {"tsm",
         {"Noise, which more samples end. A receiver that approaches the light within a stratum shadows itself: map "
          "and camera sample look at "
          "different times.",
          "pillars: everything lit is speckled; switch dynamic bias on and the speckles go.",
          "pillars, left tsm, right as it is: speckles, and noise along the edges."}},
        {"temporal",
         {"Space, not time: a texel answers for its middle, so that edges follow the map's grid.",
          "pillars, camera between, map 256: steps along the edges, but no noise; its view of list lengths shows what "
          "it pays for.",
          "pillars, left temporal with a map of 256, right as it is."}},
        {"ranges",
         {"The map's resolution, though less than an ordinary map: ranges are carried on to the receiver's own place. "
          "The sides of turning triangles "
          "are bilinear, and that shape is followed only nearly.",
          "pillars beside temporal, same map: finer edges.",
          "pillars, left ranges with a map of 256, right as it is."}},
        {"history",
         {"Motion: where a shadow may have changed, the past is dropped and the pixel begins anew, so that fast "
          "casters have rough shadows.",
          "chess: let it play, then stop; edges sharpen while nothing moves.",
          "chess while the queen slides, left history with a map of 256, right as it is."}},
        {"exact",
         {"Nothing beyond the rounding of floats. Its price is in crowds: where many moving triangles lie over one "
          "cell of the light's view, each sample "
          "tests them all.",
          "cubes with a count of 2,000: the view of candidates shows where the time goes.",
          "cubes, left the picture, right how many triangles each sample tests."}},
        {"accumulation",
         {"Nothing in time beyond half a step between two renders, but a fast thing becomes as many copies as there "
          "are renders; the map's "
          "resolution; its price, since everything is drawn again for each.",
          "octopus with 8 renders and with 256.", "Tips of arms, left 6 renders, right as they are."}},
    };
    const auto found = pages.find(technique);
    return found == pages.end() ? TechniquePage{} : found->second;
}

}  // namespace timeshade
