#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "gl/buffer.h"
#include "gl/late_counts.h"
#include "gl/program_cache.h"
#include "gl/texture.h"

namespace timeshade {

/// Lists of exactly the size that is needed, one per cell of a grid and all in one array: count, scan, fill (the
/// S-buffer of Vasilakis and Fudos 2012). It holds the cells' places only; the arrays of entries are the caller's
/// (gl::GrowingBuffer), as many as an entry has fields. In this order:
///   beginCount(cells)   shaders call listSlot(cell) of lib/cell_lists.glsl once per entry; it returns the entry's rank
///   in its list n = scan()          entries in all: make room for so many (bindCursors())     the same shaders call
///   listSlot(cell) once per entry again; it returns the entry's place
/// Cell c then holds the entries offsets[c] .. offsets[c + 1] - 1. Their order within a cell is whatever the device
/// made it: no result may depend on it.
class CellLists {
  public:
    explicit CellLists(gl::ProgramCache& programs) : programs_(programs) {}

    /// Zeroes the counters of `cells` lists (at least one) and binds them. Throws LimitError where a storage block does
    /// not hold so many.
    void beginCount(std::size_t cells);
    /// Turns counts into places, and has room made for all entries. How many that are is returned; where counts are
    /// read later only how many there may be at most, and if there are more, all lists are empty. Else it waits for the
    /// device. With a `multiple` above 1 each list gets room for a multiple of so many entries; after filling, the
    /// cursors say where its entries end. Throws LimitError where there are 2^32 - 1 entries or more. The counters are
    /// bound as cursors, ready to fill.
    std::size_t scan(gl::LateCounts& counts, const gl::MakeRoom& makeRoom, std::size_t multiple = 1);
    /// After scan(): has room made for the length of the longest list, in the same two ways.
    std::size_t longest(gl::LateCounts& counts, const gl::MakeRoom& makeRoom);
    /// How many entries there are. Waits for the device.
    std::size_t total() const;
    /// Binds the cursors again, for callers that bound something else in between.
    void bindCursors() const;
    /// Makes what was filled visible to texture fetches and buffer reads.
    static void finishFill();

    /// cells + 1 places as a buffer texture (R32UI), and the buffer itself. Valid after scan().
    const gl::Texture& offsets() const { return *offsetsView_; }
    const gl::Buffer& offsetsBuffer() const { return *offsets_; }
    std::size_t cells() const { return cells_; }
    /// Memory held: cursors and places, 8 bytes a cell, and the blocks' sums.
    std::size_t bytes() const;

  private:
    std::size_t blocks() const;
    void runScan(std::size_t multiple, std::size_t room);

    gl::ProgramCache& programs_;
    std::size_t cells_ = 0;
    std::shared_ptr<gl::ForeseenCount> total_ = std::make_shared<gl::ForeseenCount>(),
                                       longest_ = std::make_shared<gl::ForeseenCount>();
    std::optional<gl::Buffer> cursors_, offsets_, blocks_;  ///< of blocks the sums, all of them, and the longest list
    std::optional<gl::Texture> offsetsView_;
};

}  // namespace timeshade
