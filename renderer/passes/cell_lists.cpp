#include "passes/cell_lists.h"

#include <limits>

#include <fmt/format.h>

#include "core/error.h"
#include "gl/dispatch.h"
#include "gl/read_back.h"
#include "shared/frame_blocks.shared.h"

namespace timeshade {

void CellLists::beginCount(std::size_t cells) {
    if (cells != cells_) {
        GLint64 largest = 0;
        glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
        if ((cells + 1) * sizeof(GLuint) > static_cast<std::size_t>(largest))
            throw LimitError(
                fmt::format("lists of {} cells need blocks of {} bytes; this device's GL_MAX_SHADER_STORAGE_BLOCK_SIZE "
                            "is {}: lower --map",
                            cells, (cells + 1) * sizeof(GLuint), largest));
        cells_ = cells;
        cursors_.emplace("list cursors", cells * sizeof(GLuint));
        offsets_.emplace("list offsets", (cells + 1) * sizeof(GLuint));
        blocks_.emplace("list block sums", (blocks() + 2) * sizeof(GLuint));
        offsetsView_ = gl::Texture::ofBuffer("list offsets", GL_R32UI, *offsets_);
        total_->forget();
        longest_->forget();
    }
    glClearNamedBufferData(cursors_->name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    bindCursors();
}

std::size_t CellLists::blocks() const { return (cells_ + LIST_SCAN_BLOCK - 1) / LIST_SCAN_BLOCK; }

std::size_t CellLists::scan(gl::LateCounts& counts, const gl::MakeRoom& makeRoom, std::size_t multiple) {
    if (counts.later() && total_->known()) {
        const std::size_t room = total_->makeRoom(makeRoom);
        runScan(multiple, room);
        counts.expect(*blocks_, blocks(), room, total_);
        return room;
    }
    constexpr std::size_t all = std::numeric_limits<GLuint>::max();
    runScan(multiple, all);
    const std::size_t entries = total();
    if (entries == all)
        throw LimitError(fmt::format("lists of {} cells would hold {} entries or more; expected fewer: lower --map",
                                     cells_, entries));
    total_->note(entries);
    makeRoom(entries);
    return entries;
}

std::size_t CellLists::longest(gl::LateCounts& counts, const gl::MakeRoom& makeRoom) {
    if (counts.later() && longest_->known()) {
        const std::size_t room = longest_->makeRoom(makeRoom);
        counts.expect(*blocks_, blocks() + 1, room, longest_);
        return room;
    }
    const auto length = gl::readElement<GLuint>(*blocks_, blocks() + 1);
    longest_->note(length);
    return makeRoom(length);
}

std::size_t CellLists::total() const { return gl::readElement<GLuint>(*offsets_, cells_); }

void CellLists::runScan(std::size_t multiple, std::size_t room) {
    const auto blockCount = static_cast<GLuint>(blocks());
    glClearNamedBufferSubData(blocks_->name(), GL_R32UI, static_cast<GLintptr>(blockCount * sizeof(GLuint)),
                              2 * sizeof(GLuint), GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    bindCursors();
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, LIST_OFFSETS_BINDING, offsets_->name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, LIST_BLOCKS_BINDING, blocks_->name());
    for (int step = 0; step < 3; ++step) {
        const gl::Program& program = programs_.get({.label = fmt::format("list scan {}", step),
                                                    .defines = {{"SCAN_STEP", fmt::format("{}", step)}},
                                                    .compute = "passes/list_scan.comp"});
        program.use(gl::Inputs()
                        .set("cells", static_cast<std::uint32_t>(cells_))
                        .set("blocks", blockCount)
                        .set("multiple", static_cast<std::uint32_t>(multiple))
                        .set("room", static_cast<std::uint32_t>(room)));
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        gl::dispatch(step == 1 ? 1 : blockCount);
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void CellLists::bindCursors() const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, LIST_CURSORS_BINDING, cursors_->name());
}

void CellLists::finishFill() {
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

std::size_t CellLists::bytes() const { return cursors_ ? cursors_->bytes() + offsets_->bytes() + blocks_->bytes() : 0; }

}  // namespace timeshade
