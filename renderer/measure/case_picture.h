#pragma once

#include <vector>

#include "image/image_file.h"
#include "measure/case_matrix.h"

namespace timeshade {

/// The matrix as a table: a row a case with its exact share, a column a technique, each cell the value, coloured by
/// its verdict; where a failure was predicted, the prediction stands behind it.
DisplayImage drawCaseMatrix(const std::vector<CaseResult>& results);

}  // namespace timeshade
