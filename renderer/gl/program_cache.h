#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "gl/program.h"

namespace timeshade::gl {

/// Programs by description, each built at its first use and kept until it is dropped. A software renderer holds about a
/// megabyte of machine code and more for each, times the kinds of textures that it has met.
class ProgramCache {
  public:
    /// Valid until the next call of keepNewest(): ask again for every use, and set all uniforms.
    const Program& get(const ProgramDescription& description);
    /// Drops all but the `count` programs that were asked for last.
    void keepNewest(std::size_t count);
    /// Builds all programs anew from their files. Where one can't be, the last good one stays; what the driver and the
    /// files say of these, a line each.
    std::vector<std::string> reload();
    std::size_t size() const { return programs_.size(); }
    /// How many programs have been compiled so far, those that were dropped and compiled again included. A frame
    /// that leaves it as it was has compiled nothing, so its times are those of drawing alone.
    std::uint64_t compiled() const { return compiled_; }

  private:
    struct Entry {
        Program program;
        ProgramDescription description;
        std::uint64_t lastUse;
    };
    std::map<std::string, Entry> programs_;
    std::uint64_t uses_ = 0, compiled_ = 0;
};

}  // namespace timeshade::gl
