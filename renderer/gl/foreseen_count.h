#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace timeshade::gl {

/// Makes room for at least so many, and says for how many there is room now.
using MakeRoom = std::function<std::size_t(std::size_t)>;

/// How many there will be, from how many there were.
class ForeseenCount {
  public:
    /// What was counted in a frame.
    void note(std::size_t found);
    bool known() const { return lately_.has_value(); }
    /// Nothing before is of any use: the lists are others.
    void forget() { lately_.reset(); }
    /// Room for a few more than lately, of a buffer that is made anew for half as many again. known() is required
    /// (checked).
    std::size_t makeRoom(const MakeRoom& make);

  private:
    std::optional<std::size_t> lately_;  ///< the most; an eighth of it is forgotten with each frame
    std::size_t room_ = 0;
};

}  // namespace timeshade::gl
