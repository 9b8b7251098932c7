// Count, scan, fill against a sort on the CPU: every entry is in its own cell's list once, at every awkward number of
// cells.
#include "passes/cell_lists.h"

#include <algorithm>
#include <numeric>
#include <span>

#include <gtest/gtest.h>

#include "core/error.h"
#include "gl/growing_buffer.h"
#include "shared/frame_blocks.shared.h"
#include "shared/hash.shared.h"
#include "support/gl_environment.h"

namespace timeshade {
namespace {

class InsertProgram : public gl::Object<gl::DeleteProgram> {
  public:
    InsertProgram() : Object(link()) {}

  private:
    static GLuint link() {
        const std::string text = gl::readShader("lib/cell_lists.glsl", {}).text + R"(
layout(local_size_x = 64) in;
layout(std430, binding = 4) readonly buffer Cells { uint cellOf[]; };
layout(std430, binding = 5) writeonly buffer Entries { uint entries[]; };
layout(location = 0) uniform uint count;
layout(location = 1) uniform uint filling;
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    uint slot = listSlot(cellOf[i]);
    if (filling != 0u) entries[slot] = i;
})";
        const char* source = text.c_str();
        return glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source);
    }
};

std::vector<GLuint> read(const gl::Buffer& buffer, std::size_t count) {
    std::vector<GLuint> words(count);
    glGetNamedBufferSubData(buffer.name(), 0, static_cast<GLsizeiptr>(count * sizeof(GLuint)), words.data());
    return words;
}

void insert(const InsertProgram& program, std::size_t count, bool filling) {
    glUseProgram(program.name());
    glUniform1ui(0, static_cast<GLuint>(count));
    glUniform1ui(1, filling ? 1 : 0);
    glDispatchCompute(static_cast<GLuint>((count + 63) / 64), 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void expectSorted(CellLists& lists, const InsertProgram& program, std::size_t cells,
                  const std::vector<GLuint>& cellOf) {
    const gl::Buffer input("cells of entries", std::span<const GLuint>(cellOf));
    gl::GrowingBuffer entries("entries", GL_R32UI);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, input.name());
    lists.beginCount(cells);
    entries.reserve(1, "no advice");
    entries.bindForWriting(5);
    insert(program, cellOf.size(), false);
    gl::LateCounts counts;
    const auto makeRoom = [&](std::size_t count) {
        entries.reserve(count, "lower --map");
        return entries.capacity();
    };
    ASSERT_EQ(lists.scan(counts, makeRoom), cellOf.size());
    entries.bindForWriting(5);
    insert(program, cellOf.size(), true);
    CellLists::finishFill();
    const std::vector<GLuint> offsets = read(lists.offsetsBuffer(), cells + 1);
    std::vector<GLuint> filled = read(entries.buffer(), cellOf.size());
    ASSERT_EQ(offsets.front(), 0u);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        ASSERT_LE(offsets[cell], offsets[cell + 1]);
        for (GLuint i = offsets[cell]; i < offsets[cell + 1]; ++i) ASSERT_EQ(cellOf[filled[i]], cell) << "place " << i;
    }
    std::sort(filled.begin(), filled.end());
    for (GLuint i = 0; i < filled.size(); ++i) ASSERT_EQ(filled[i], i) << "lost or doubled";
}

TEST(CellLists, HoldEveryEntryOnce) {
    CellLists lists(sharedRenderer().programs());
    const InsertProgram program;
    for (const std::size_t cells : {1u, 2u, 255u, 1023u, 1024u, 1025u, 4096u, 70001u, 300000u}) {
        for (const std::size_t entries : {1u, 63u, 5000u, 120000u}) {
            std::vector<GLuint> cellOf(entries);
            // Half of them crowd into a few cells.
            for (GLuint i = 0; i < entries; ++i)
                cellOf[i] = shared::hashWord(i ^ 0x1234u) %
                            static_cast<GLuint>(i % 2 == 0 ? cells : std::min<std::size_t>(cells, 7));
            SCOPED_TRACE(testing::Message() << cells << " cells, " << entries << " entries");
            expectSorted(lists, program, cells, cellOf);
        }
    }
}

TEST(CellLists, MayBeEmpty) {
    CellLists lists(sharedRenderer().programs());
    lists.beginCount(5000);
    gl::LateCounts counts;
    EXPECT_EQ(lists.scan(counts, [](std::size_t count) { return count; }), 0u);
    for (const GLuint offset : read(lists.offsetsBuffer(), 5001)) ASSERT_EQ(offset, 0u);
}

TEST(GrowingBuffer, GrowsAndNamesTheLimitThatItMeets) {
    gl::GrowingBuffer buffer("tuples", GL_RGBA32F);
    buffer.reserve(10, "lower --map");
    EXPECT_GE(buffer.bytes(), 160u);
    const std::size_t before = buffer.bytes();
    buffer.reserve(5, "lower --map");
    EXPECT_EQ(buffer.bytes(), before);
    GLint64 largest = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
    try {
        buffer.reserve(static_cast<std::size_t>(largest) / 16 + 1, "lower --map");
        FAIL() << "was granted";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("GL_MAX_SHADER_STORAGE_BLOCK_SIZE"), std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find("lower --map"), std::string::npos) << error.what();
    }
    EXPECT_EQ(buffer.bytes(), before) << "a refusal costs nothing";
}

TEST(GrowingBuffer, ShrinksWhenLessIsNeeded) {
    gl::GrowingBuffer buffer("entries", GL_R32UI);
    const std::size_t mebi = std::size_t{1} << 20;
    buffer.reserve(4 * mebi, "");
    const std::size_t large = buffer.bytes();
    for (int i = 0; i < 31; ++i) buffer.reserve(i == 7 ? mebi / 2 : 1, "");
    EXPECT_EQ(buffer.bytes(), large) << "not shrunk at once";
    buffer.reserve(2 * mebi, "");
    for (int i = 0; i < 31; ++i) buffer.reserve(i == 7 ? mebi / 2 : 1, "");
    EXPECT_EQ(buffer.bytes(), large) << "a large request begins the count anew";
    buffer.reserve(1, "");
    EXPECT_LT(buffer.bytes(), large / 7);
    EXPECT_GE(buffer.bytes(), mebi / 2 * sizeof(GLuint)) << "the largest of the latest requests fits";
    const std::size_t small = buffer.bytes();
    for (int i = 0; i < 100; ++i) buffer.reserve(mebi / 2, "");
    EXPECT_EQ(buffer.bytes(), small) << "what fits well is left alone";
}

}  // namespace
}  // namespace timeshade
