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
        const std::size_t blocks = (cells + LIST_SCAN_BLOCK - 1) / LIST_SCAN_BLOCK;
        cursors_.emplace("list cursors", cells * sizeof(GLuint));
        offsets_.emplace("list offsets", (cells + 1) * sizeof(GLuint));
        blocks_.emplace("list block sums", blocks * sizeof(GLuint));
        offsetsView_ = gl::Texture::ofBuffer("list offsets", GL_R32UI, *offsets_);
        cells_ = cells;
    }
    glClearNamedBufferData(cursors_->name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    bindCursors();
}

std::size_t CellLists::scan(std::size_t multiple) {
    const auto blocks = static_cast<GLuint>((cells_ + LIST_SCAN_BLOCK - 1) / LIST_SCAN_BLOCK);
    bindCursors();
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, LIST_OFFSETS_BINDING, offsets_->name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, LIST_BLOCKS_BINDING, blocks_->name());
    for (int step = 0; step < 3; ++step) {
        const gl::Program& program = programs_.get({.label = fmt::format("list scan {}", step),
                                                    .defines = {{"SCAN_STEP", fmt::format("{}", step)}},
                                                    .compute = "passes/list_scan.comp"});
        program.use(gl::Inputs()
                        .set("cells", static_cast<std::uint32_t>(cells_))
                        .set("blocks", blocks)
                        .set("multiple", static_cast<std::uint32_t>(multiple)));
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        gl::dispatch(step == 1 ? 1 : blocks);
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    const auto total = gl::readElement<GLuint>(*offsets_, cells_);
    if (total == std::numeric_limits<GLuint>::max())
        throw LimitError(
            fmt::format("lists of {} cells would hold {} entries or more; expected fewer: lower --map", cells_, total));
    return total;
}

void CellLists::bindCursors() const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, LIST_CURSORS_BINDING, cursors_->name());
}

void CellLists::finishFill() {
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

std::size_t CellLists::bytes() const { return cursors_ ? cursors_->bytes() + offsets_->bytes() + blocks_->bytes() : 0; }

}  // namespace timeshade
