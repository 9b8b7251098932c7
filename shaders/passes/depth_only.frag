// Nothing but the depth that the rasteriser writes.
void main() {}
