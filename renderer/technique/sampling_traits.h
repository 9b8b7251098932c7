#pragma once

namespace timeshade {

/// What a technique states about itself, with its settings as they are: where and when it looks for casters, and how
/// far it may be off. With its footprint, the named cases derive from it what the technique must compute, also where it
/// cannot be right. It is held to the exact value in all that is not stated here or in its Prediction.
struct SamplingTraits {
    /// The instants at which casters are looked at, for a receiver seen at time u.
    enum class Times {
        OfReceiver,  ///< at u itself
        OneInstant,  ///< casters and receiver at the centre of what is drawn at once: the shutter, or one of several
                     ///< renders
        RandomInStratum,  ///< at a random time of u's stratum, drawn per map texel
    };
    Times times = Times::OfReceiver;
    int strata = 0;  ///< of RandomInStratum: how many the shutter has; 0: as many as a pixel has camera samples
    /// Casters are looked at along the line from the light through the centre of the receiver's map texel.
    bool texelCentres = false;
    double biasTexels = 0.0;   ///< how much nearer to the light a caster must be, in texels at the receiver's depth
    double statedError = 0.0;  ///< of the lit share, beyond all that: what the technique's own bound allows
    /// Largest share of samples that may change where the same surface is cut into other triangles.
    double triangulationError = 0.0;
};

}  // namespace timeshade
