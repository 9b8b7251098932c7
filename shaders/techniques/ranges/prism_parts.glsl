// What a triangle of a prism's surface is.
#define PART_SIDE 0u
#define PART_OPEN 1u   // the moving triangle at u = 0
#define PART_CLOSE 2u  // and at u = 1
