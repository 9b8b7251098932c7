// What a technique's lists look like from the camera: the mean over a pixel's samples of what is found in the texel of
// each. The technique's file includes its lists first, which say
//     ListSummary summaryOf(ivec2 texel)
//
// VIEW_TIME: when the first interval begins, in u. Else: how many there are. Negative where no sample is inside the
// map.
layout(location = 0) out float outputValue;

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
