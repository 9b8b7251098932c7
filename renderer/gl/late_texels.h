#pragma once

#include <cstddef>
#include <vector>

#include "gl/buffer.h"
#include "gl/fence.h"
#include "gl/texture.h"

namespace timeshade::gl {

/// The texels of a texture, as they were when the device was asked for them: it copies them, goes on with whatever it
/// is told next, and who takes them later need not wait.
class LateTexels : public Object<DeleteBuffer> {
  public:
    /// All texels of the first level, layer by layer, rows upwards, in that format. Throws LimitError where there is no
    /// memory for them.
    LateTexels(const Texture& texture, GLenum format, GLenum type);

    /// What was copied; waits where the device has not done it yet. T is what `type` said.
    template <typename T>
    std::vector<T> take() {
        std::vector<T> values(bytes_ / sizeof(T));
        copyTo(values.data());
        return values;
    }

  private:
    void copyTo(void* values);

    std::size_t bytes_ = 0;
    Fence copied_;
};

}  // namespace timeshade::gl
