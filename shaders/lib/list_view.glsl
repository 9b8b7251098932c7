// What a technique's lists look like: from the camera, the mean over a pixel's samples of what is found in the texel of
// each; from the light, the map itself. The technique's file includes its lists first, which say
//     ListSummary summaryOf(ivec2 texel)
//
// VIEW_TIME: when the first interval begins, in u. Else: how many there are. Negative where no sample is inside the
// map. SEEN_BY_LIGHT: the map, as a square in the middle of the picture, each pixel the texel that holds its centre;
// negative beside it.
layout(location = 0) out float outputValue;

#ifdef SEEN_BY_LIGHT
void main() {
    vec2 size = vec2(frame.imageSize);
    float side = min(size.x, size.y);
    vec2 position = (gl_FragCoord.xy - 0.5 * (size - side)) / side;
    ivec2 texel = ivec2(floor(position * lightView.size));
    outputValue = insideMap(texel) ? float(summaryOf(texel).entries) : -1.0;
}
#else
void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    float sum = 0.0, count = 0.0;
    for (uint stratum = 0u; stratum < frame.strata; ++stratum) {
        uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
        if (id == NO_TRIANGLE) continue;
        Receiver r = receiverOf(fetchTriangle(id), id, pixel, stratum);
        ivec2 texel;
        if (!texelOf(mapPointOf(r, r.time), texel)) continue;
        ListSummary list = summaryOf(texel);
#ifdef VIEW_TIME
        if (list.entries == 0) continue;
        sum += list.firstTime;
#else
        sum += float(list.entries);
#endif
        count += 1.0;
    }
    outputValue = count > 0.0 ? sum / count : -1.0;
}
#endif
