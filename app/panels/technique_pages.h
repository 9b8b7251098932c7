#pragma once

#include <string>

namespace timeshade {

/// What a technique gets wrong and what to look at, for people who see it for the first time.
struct TechniquePage {
    std::string wrong;
    std::string look;   ///< a scene and what can be seen in it
    std::string shown;  ///< what its picture, assets/pages/NAME.png, has on the left and on the right
};

/// The page of the technique of that name; empty texts where none has been written.
TechniquePage pageOf(const std::string& technique);

}  // namespace timeshade
