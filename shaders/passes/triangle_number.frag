// The number of the triangle that is drawn, beside the depth that the rasteriser writes.
layout(location = 0) out uint outputTriangle;

void main() { outputTriangle = uint(gl_PrimitiveID); }
