#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

// A visibility function (Lokovic and Veach 2000): how much of the light passes what is nearer than a depth. It is 1
// before its first jump, constant between jumps and falls at each. It is stored as nodes (depth, visibility), linear
// from one to the next, constant before the first and behind the last; two nodes of one depth are a jump.
//
// Compression is theirs: from a node, the slopes are kept with which one segment stays within the error of the function
// at all jumps so far, on both sides of each; when none is left, the segment ends at the last of them. Linear between
// jumps where the function is constant, what is within the error at both ends is so everywhere. It departs from the
// paper in three ways. A fall that no slope can pass is stored as the jump that it is. Of the slopes that are left the
// one is taken that ends nearest to the function, not the middle one, which gives up accuracy where none has to be
// given. And before the first jump and behind the last the function is stored exactly: that is what receivers behind
// all casters see.

SHARED_BEGIN

/// What is known of a function whose jumps have been added so far.
struct VisibilityWedge {
    vec2 node;      // the last: depth, visibility
    vec2 jump;      // the last: depth, visibility behind it
    float least;    // slopes from the node that stay within the error of the function up to there
    float most;     // at most 0
    float end;      // visibility behind all jumps
    uint nodes;     // so far
    uint newNodes;  // those of them that the last jump has added, at most three
    vec2 new0;      // in order of depth
    vec2 new1;
    vec2 new2;
};

/// Of no jump yet. `end`: visibility behind all jumps to come, as the last of them says it.
SHARED_FUNCTION VisibilityWedge emptyVisibility(float end) {
    VisibilityWedge w;
    w.node = w.jump = vec2(SHARED_FLOAT(0.0), SHARED_FLOAT(1.0));
    w.least = w.most = SHARED_FLOAT(0.0);
    w.end = end;
    w.nodes = w.newNodes = 0u;
    w.new0 = w.new1 = w.new2 = vec2(SHARED_FLOAT(0.0));
    return w;
}

/// With one more node, from which every falling slope is possible.
SHARED_FUNCTION VisibilityWedge withNode(VisibilityWedge w, vec2 node) {
    if (w.newNodes == 0u) w.new0 = node;
    if (w.newNodes == 1u) w.new1 = node;
    if (w.newNodes == 2u) w.new2 = node;
    ++w.newNodes;
    ++w.nodes;
    w.node = node;
    w.least = SHARED_FLOAT(-3e38);
    w.most = SHARED_FLOAT(0.0);
    return w;
}

/// Only those slopes that come within `error` of `visibility` at a depth behind the node's, and not below the
/// function's end. None: most < least.
SHARED_FUNCTION VisibilityWedge narrowed(VisibilityWedge w, float depth, float visibility, float error) {
    float length = depth - w.node.x;
    w.least = max(w.least, (max(visibility - error, w.end) - w.node.y) / length);
    w.most = min(w.most, (visibility + error - w.node.y) / length);
    return w;
}

/// Where the segment from the node ends at that depth: as near to `visibility` as its slopes allow. They are not none,
/// and have been narrowed to within the error of `visibility` there.
SHARED_FUNCTION vec2 segmentEnd(VisibilityWedge w, float depth, float visibility, float error) {
    float length = depth - w.node.x, slope = clamp((visibility - w.node.y) / length, w.least, w.most);
    return vec2(depth,
                clamp(w.node.y + slope * length, max(visibility - error, w.end), min(visibility + error, w.node.y)));
}

/// Adds a jump down to `visibility` (>= end) at a depth behind all before, and after the last of them all ends the
/// nodes. The stored function is then within `error` (>= 0) of the function at every depth, but for a rounding of 1e-6;
/// it never rises, from 1 to the end. There are at most two nodes a jump; with an error of 0 just those.
SHARED_FUNCTION VisibilityWedge withJump(VisibilityWedge w, float depth, float visibility, float error, bool isLast) {
    w.newNodes = 0u;
    float allowed = isLast ? SHARED_FLOAT(0.0) : error;
    if (w.nodes == 0u) {
        w = withNode(w, vec2(depth, SHARED_FLOAT(1.0)));
        if (SHARED_FLOAT(1.0) - visibility > allowed) w = withNode(w, vec2(depth, visibility));
    } else {
        VisibilityWedge before = narrowed(w, depth, w.jump.y, error);
        if (before.most < before.least) {
            w = withNode(w, segmentEnd(w, w.jump.x, w.jump.y, error));
            before = narrowed(w, depth, w.jump.y, error);
        }
        VisibilityWedge behind = narrowed(before, depth, visibility, allowed);
        if (behind.most < behind.least) {
            w = withNode(w, segmentEnd(before, depth, w.jump.y, error));
            w = withNode(w, vec2(depth, visibility));
        } else if (isLast) {
            w = withNode(w, vec2(depth, visibility));
        } else {
            w.least = behind.least;
            w.most = behind.most;
        }
    }
    w.jump = vec2(depth, visibility);
    return w;
}

/// What the stored function is at a depth between two neighbouring nodes, a.x < depth <= b.x.
SHARED_FUNCTION float visibilityBetween(vec2 a, vec2 b, float depth) {
    return a.y + (b.y - a.y) * ((depth - a.x) / (b.x - a.x));
}

SHARED_END
