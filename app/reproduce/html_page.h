#pragma once

#include <string>

#include "reproduce/paper_result.h"

namespace timeshade {

/// The result as one page that needs nothing else: pictures, style and script are in it, and it asks no other machine
/// for anything. Where its pictures would be more than 11 MB, the last of them are links into the folder, and the page
/// says so. Throws Error where the page's style or script is missing.
std::string htmlPage(const PaperResult& result);

}  // namespace timeshade
