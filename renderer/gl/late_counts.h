#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "gl/buffer.h"
#include "gl/fence.h"
#include "gl/foreseen_count.h"

namespace timeshade::gl {

/// Counts that the device makes in a frame, of what the processor makes room for. Read at once, each is a wait. Read
/// later, none is: room is made for what frames before had, and more, and whether it sufficed is known once the device
/// is done with the frame. Where it did not, that frame is wrong and must be drawn again; its counts are then read at
/// once.
class LateCounts {
  public:
    enum class Reading { AtOnce, Later };
    enum class State {
        Pending,   ///< not known yet
        Sufficed,  ///< the frame is right
        TooMany,   ///< draw it again
    };

    LateCounts() = default;
    ~LateCounts();
    LateCounts(const LateCounts&) = delete;
    LateCounts& operator=(const LateCounts&) = delete;

    /// A frame begins. Whatever of the one before is not known yet never will be.
    void begin(Reading reading);
    /// May the next count be read later?
    bool later() const { return later_ && expected_.size() < slots; }
    /// The element at that place should be at most `room`. Only where later() (checked). `foreseen` is told.
    void expect(const Buffer& counts, std::size_t place, std::size_t room, std::shared_ptr<ForeseenCount> foreseen);
    /// The device has been told all of the frame.
    void end();
    /// Does not wait. Until end() it is Pending where anything is expected.
    State state();
    /// As state(), waiting where it is Pending. Only after end() (checked).
    State settle();

  private:
    static constexpr std::size_t slots = 256;
    struct Expected {
        std::size_t room;
        std::shared_ptr<ForeseenCount> foreseen;
    };
    void makeMemory();
    void readAll();

    bool later_ = false, tooMany_ = false;
    std::vector<Expected> expected_;
    std::optional<Fence> end_;
    GLuint buffer_ = 0;
    const GLuint* mapped_ = nullptr;  ///< its memory, for as long as it lives
};

}  // namespace timeshade::gl
