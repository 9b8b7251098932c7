#pragma once

namespace timeshade {

/// What a technique states about itself, with its settings as they are: where and when it looks for casters. The named
/// cases derive from it how far the technique may be off, and what it must answer where it can't be right. Not a word
/// more than what was left as it is here: a technique is held to the exact answer.
struct SamplingTraits {
    /// The instants at which casters are looked at, for a receiver seen at time u.
    enum class Times {
        OfReceiver,       ///< at u itself
        OneInstant,       ///< casters and receiver at the middle of the shutter
        EvenInstants,     ///< everything at one of `instants` evenly spaced instants
        RandomInStratum,  ///< at a random time of u's stratum, drawn per map texel
    };
    Times times = Times::OfReceiver;
    int instants = 0;
    /// Casters are looked at along the line from the light through the middle of the receiver's map texel.
    bool texelCentres = false;
    /// The map is fitted to what the camera sees: its texels are finer than the light's map by an amount that only the
    /// frame knows.
    bool mapFollowsCamera = false;
    /// A triangle is taken to be over a texel from the first time that it is to the last.
    bool firstAndLast = false;
    /// The depth of a caster seen at another time is moved along its velocity to the receiver's.
    bool movesDepth = false;
    /// Times and depths at the texel's centre are extended to the receiver's own position. More accurate, but the
    /// result then depends on how a surface is divided into triangles, as each is extended on its own.
    bool extendsToReceiver = false;
    double biasTexels = 0.0;   ///< how much nearer to the light a caster must be, in texels at the receiver's depth
    double statedError = 0.0;  ///< of the lit share, beyond all that: what the technique's own bound allows
};

}  // namespace timeshade
