// Linked lists of tuples, six words each: begin, end, window depth at begin and at end, triangle, next. The window depth of
// a spot is near / distance; the usual depth is a linear function of it, and so is what lies between two of either.
uniform usamplerBuffer tupleHeads;
uniform usamplerBuffer linkedTuples;
#ifdef COVERAGE_MAP
uniform sampler2DArray coverageMap;
#endif

uint wordOf(uint tuple, int word) { return texelFetch(linkedTuples, int(tuple) * LINKED_TUPLE_WORDS + word).x; }

float windowDepth(float distance) {
#ifdef LIGHT_ORTHOGRAPHIC
    return 1.0 - distance / lightView.farDistance;
#else
    return lightView.nearDistance / distance;
#endif
}

// Is a triangle other than the receiver's own nearer to the light than `depth`, in this texel at this time?
bool nearerThan(float depth, ivec2 texel, uint own, float time) {
#ifdef COVERAGE_MAP
    float covered = texelFetch(coverageMap, ivec3(texel, 0), 0).x;
    if (covered == float(own)) return false;
    if (covered > -1.0) return true;
#endif
    float receiver = depth > 0.0 ? windowDepth(depth) : 1.0;
    uint tuple = texelFetch(tupleHeads, texel.y * int(frame.mapSize) + texel.x).x;
    while (tuple != NO_TUPLE) {
        float begin = uintBitsToFloat(wordOf(tuple, 0)), end = uintBitsToFloat(wordOf(tuple, 1));
        if (time >= begin && time <= end && wordOf(tuple, 4) != own) {
            float first = uintBitsToFloat(wordOf(tuple, 2)), last = uintBitsToFloat(wordOf(tuple, 3));
            // Reversed: greater is nearer.
            if (mix(first, last, end > begin ? (time - begin) / (end - begin) : 0.0) > receiver) return true;
        }
        tuple = wordOf(tuple, 5);
    }
    return false;
}

ListSummary summaryOf(ivec2 texel) {
    ListSummary list = ListSummary(0, 2.0);
    uint tuple = texelFetch(tupleHeads, texel.y * int(frame.mapSize) + texel.x).x;
    while (tuple != NO_TUPLE) {
        list.tuples++;
        list.firstTime = min(list.firstTime, uintBitsToFloat(wordOf(tuple, 0)));
        tuple = wordOf(tuple, 5);
    }
    return list;
}
