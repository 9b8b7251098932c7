#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace timeshade {

/// Runs `body` once per item on the GPU: GLSL that reads its item as floats in_(j) or vectors in2(j), in3(j) and writes
/// words with put(j, uint) and put(j, float), j < outputsPerItem. `header` is the shared header under test, put in
/// front of it. Returns the words of all items. Needs the shared context.
std::vector<std::uint32_t> runOnGpu(const std::string& header, const std::string& body, const std::vector<float>& input,
                                    unsigned inputsPerItem, unsigned outputsPerItem);

/// Distance in units in the last place, counted over the line of all floats; a NaN is far from everything but a NaN.
std::uint64_t ulpsApart(float a, float b);

}  // namespace timeshade
