#include "passes/candidate_grid.h"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include "core/error.h"
#include "gl/dispatch.h"
#include "gl/uploads.h"
#include "shared/candidate_bounds.shared.h"
#include "shared/frame_blocks.shared.h"

namespace timeshade {

namespace {

/// Cells that one invocation visits alone; triangles with more share a work group.
constexpr GLuint maxWalk = 256;
constexpr std::size_t groupSize = 64;
/// Groups that work on the queue of such triangles, whatever its length.
constexpr std::size_t largeGroups = 512;

std::size_t deviceLimit() {
    GLint64 block = 0, texels = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block);
    glGetInteger64v(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    return static_cast<std::size_t>(std::min(block / 8, 2 * texels)) / CANDIDATES_TOGETHER * CANDIDATES_TOGETHER;
}

/// One place a cell and one more, in one storage block.
std::size_t maxCells() {
    GLint64 block = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block);
    return static_cast<std::size_t>(block / 4 - 1);
}

}  // namespace

CandidateGrid::CandidateGrid(gl::ProgramCache& programs)
    : programs_(programs),
      lists_(programs),
      casters_("shadow casters", GL_R32UI),
      candidates_("shadow candidates", GL_RGBA32UI) {}

void CandidateGrid::build(const FramePlan& plan, const std::vector<std::uint32_t>& casters,
                          const CandidateGridSize& wanted, gl::LateCounts& counts, std::size_t maxEntries) {
    maxEntries = std::min(maxEntries, deviceLimit());
    casters_.reserve(std::max<std::size_t>(casters.size(), 1), "draw fewer triangles");
    gl::upload(casters_.buffer().name(), std::span<const std::uint32_t>(casters));
    buckets_ = wanted.buckets;
    castersCount_ = casters.size();
    coarsened_ = false;
    constexpr std::size_t together = CANDIDATES_TOGETHER;
    // No more than the limit, even where the last grid tried is the one that is taken.
    const auto makeRoom = [&](std::size_t entries) {
        if (entries <= maxEntries || side_ <= 1)
            candidates_.reserve(2 * std::max<std::size_t>((entries + together - 1) / together, 1),
                                "lower the number of buckets, or draw fewer triangles");
        return std::min(candidates_.capacity() / 2 * together, maxEntries);
    };
    for (side_ = wanted.side;; side_ /= 2) {
        const auto cells =
            static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) * static_cast<std::size_t>(buckets_);
        if (cells > maxCells() && side_ > 1) {
            coarsened_ = true;
            continue;
        }
        lists_.beginCount(cells);
        insert(plan, casters.size(), false);
        if (lists_.scan(counts, makeRoom) <= maxEntries || side_ <= 1) break;
        coarsened_ = true;
    }
    lists_.bindCursors();
    candidates_.bindForWriting(TECHNIQUE_STORAGE_BINDING);
    insert(plan, casters.size(), true);
    CellLists::finishFill();
}

void CandidateGrid::insert(const FramePlan& plan, std::size_t casters, bool fill) {
    if (casters == 0) return;
    const std::size_t items = casters * static_cast<std::size_t>(buckets_);
    const std::size_t queueBytes = (items + 1) * sizeof(GLuint);
    if (items > maxCells())
        throw LimitError(
            fmt::format("{} casters in {} buckets need a block of {} bytes; this device's "
                        "GL_MAX_SHADER_STORAGE_BLOCK_SIZE is less: lower the number of buckets",
                        casters, buckets_, queueBytes));
    if (!queue_ || queue_->bytes() < queueBytes) queue_.emplace("casters of many cells", queueBytes);
    if (!fill) {
        const std::array<GLuint, 1> nothing{0};
        queue_->upload(std::span<const GLuint>(nothing));
    }
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, TECHNIQUE_STORAGE_BINDING + 1, queue_->name());
    casters_.bindForReading(LARGE_TRIANGLES_UNIT);

    gl::ShaderDefines defines;
    if (plan.light.projection == Projection::Orthographic) defines.emplace_back("LIGHT_ORTHOGRAPHIC", "1");
    if (fill) defines.emplace_back("FILL", "1");
    for (const bool large : {false, true}) {
        const gl::Program& program =
            programs_.get({.label = large ? "large casters" : "small casters",
                           .defines = defines,
                           .compute = large ? "passes/large_casters.comp" : "passes/small_casters.comp"});
        program.use(gl::Inputs()
                        .set("gridSide", static_cast<std::uint32_t>(side_))
                        .set("buckets", static_cast<std::uint32_t>(buckets_)));
        if (large) {
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
            gl::dispatch(largeGroups);
        } else {
            program.set("items", static_cast<std::uint32_t>(items));
            program.set("maxWalk", maxWalk);
            gl::dispatch(gl::groupsFor(items, groupSize));
        }
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

double CandidateGrid::entryBytes() const {
    return 8.0 * static_cast<double>(entries()) + 4.0 * static_cast<double>(castersCount_) * (1.0 + buckets_);
}

double CandidateGrid::cellBytes() const { return 8.0 * side_ * side_ * buckets_; }

std::size_t CandidateGrid::bytes() const {
    return lists_.bytes() + casters_.bytes() + candidates_.bytes() + (queue_ ? queue_->bytes() : 0);
}

}  // namespace timeshade
