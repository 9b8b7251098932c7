// Percentage-closer filtering (Reeves et al. 1987): a technique's test is made in each of (2n + 1) x (2n + 1) texels
// around the receiver's, as if the receiver lay there at the same depth, and averaged. PCF_RADIUS: n, 0 for one test.
const int pcfTests = (2 * PCF_RADIUS + 1) * (2 * PCF_RADIUS + 1);

ivec2 pcfOffset(int test) {
    const int side = 2 * PCF_RADIUS + 1;
    return ivec2(test % side, test / side) - PCF_RADIUS;
}

// The receiver, moved by whole texels.
MapPoint movedByTexels(MapPoint m, ivec2 texels) {
    m.position += vec2(texels) / lightView.size;
    return m;
}

// A plane rises over the filter's width as well.
float pcfDepth(MapPoint m, float bias, float slopeBias) {
    return m.depth - depthBias(m, bias, slopeBias * float(2 * PCF_RADIUS + 1));
}
