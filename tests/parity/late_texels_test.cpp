// Texels that are read later: those that were there when the device was asked, and no wait once it is done.
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "gl/late_texels.h"
#include "gl/read_back.h"
#include "support/gl_environment.h"

namespace timeshade {
namespace {

TEST(LateTexels, AreThoseOfWhenTheyWereAskedFor) {
    gl::Texture texture = gl::Texture::image2D("late", GL_RGBA8, 7, 5);
    std::vector<std::uint8_t> first(7 * 5 * 4), second(7 * 5 * 4, 9);
    for (std::size_t i = 0; i < first.size(); ++i) first[i] = static_cast<std::uint8_t>(i);
    glTextureSubImage2D(texture.name(), 0, 0, 0, 7, 5, GL_RGBA, GL_UNSIGNED_BYTE, first.data());
    gl::LateTexels asked(texture, GL_RGBA, GL_UNSIGNED_BYTE);
    glTextureSubImage2D(texture.name(), 0, 0, 0, 7, 5, GL_RGBA, GL_UNSIGNED_BYTE, second.data());
    gl::LateTexels later(texture, GL_RGBA, GL_UNSIGNED_BYTE);
    glFinish();
    const std::uint64_t before = gl::waitsSoFar();
    EXPECT_EQ(asked.take<std::uint8_t>(), first);
    EXPECT_EQ(later.take<std::uint8_t>(), second);
    EXPECT_EQ(gl::waitsSoFar(), before);
    EXPECT_EQ(gl::readTexture<std::uint8_t>(texture, GL_RGBA, GL_UNSIGNED_BYTE), second);
}

}  // namespace
}  // namespace timeshade
