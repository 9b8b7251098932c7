// What a triangle of a prism's surface is.
#define PART_OPEN 0u   // the moving triangle at u = 0
#define PART_CLOSE 1u  // and at u = 1
#define PART_SIDE 2u   // one of the three sides, 2 to 4: what the edge from a corner to the next sweeps
