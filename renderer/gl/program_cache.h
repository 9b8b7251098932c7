#pragma once

#include <map>
#include <string>

#include "gl/program.h"

namespace timeshade::gl {

/// Programs by description, each built at its first use and kept as long as the cache.
class ProgramCache {
  public:
    const Program& get(const ProgramDescription& description);

  private:
    std::map<std::string, Program> programs_;
};

} // namespace timeshade::gl
