#pragma once

#include "reproduce/paper_list.h"

namespace timeshade {

/// Throws Error where a figure is not whole: a file whose step is not there, a value that is named and not declared, a
/// rule of no known kind or with too few values, one that is redrawn without steps, one that can't be without a reason.
void requireWhole(const PaperFigure& figure);

}  // namespace timeshade
