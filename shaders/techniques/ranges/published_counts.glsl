// Counters of both sub-passes of the published form.
layout(std430, binding = LINKED_COUNTS_BINDING) buffer LinkedCounts {
    uint fragmentCount;
    uint rangeCount;
    uint unpairedLists;  // texels with a triangle that left an odd number of fragments there
    uint longestList;    // fragments
};
