// Fragments of a texel come in whatever order a device has: generate.comp makes the same ranges of them, sorted by
// triangle and time, in all.
#include <algorithm>
#include <random>
#include <span>
#include <tuple>

#include <gtest/gtest.h>

#include "gl/dispatch.h"
#include "gl/program_cache.h"
#include "gl/read_back.h"
#include "support/gl_environment.h"
#include "techniques/ranges/bindings.shared.h"

namespace timeshade {
namespace {

struct Fragment {
    std::uint32_t id = 0;
    float time = 0.0f, distance = 0.0f;
    glm::uvec2 slope{0};
    bool operator==(const Fragment&) const = default;
};

bool before(const Fragment& a, const Fragment& b) {
    return std::tie(a.id, a.time, a.distance) < std::tie(b.id, b.time, b.distance);
}

using Lists = std::vector<std::vector<Fragment>>;

/// Lists of 0 to about 800 fragments, two or four of a triangle.
Lists madeLists(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    Lists lists;
    for (const int triangles : {0, 1, 2, 3, 9, 20, 60, 300, 0, 17}) {
        std::vector<Fragment>& list = lists.emplace_back();
        for (int t = 0; t < triangles; ++t) {
            const std::uint32_t id = static_cast<std::uint32_t>(t) * 7u + random() % 7u;
            const int fragments = random() % 3 == 0 ? 4 : 2;
            for (int i = 0; i < fragments; ++i) list.push_back({id, unit(random), unit(random), {random(), random()}});
        }
    }
    return lists;
}

/// What generate.comp leaves of the lists.
Lists generated(const Lists& lists) {
    std::vector<GLuint> offsets{0}, cursors, ids;
    std::vector<float> times, distances;
    std::vector<glm::uvec2> slopes;
    for (const std::vector<Fragment>& list : lists) {
        for (const Fragment& f : list) {
            ids.push_back(f.id);
            times.push_back(f.time);
            distances.push_back(f.distance);
            slopes.push_back(f.slope);
        }
        offsets.push_back(static_cast<GLuint>(ids.size()));
        cursors.push_back(offsets.back());
    }
    const gl::Buffer idBuffer("ids", std::span<const GLuint>(ids)), timeBuffer("times", std::span<const float>(times)),
        distanceBuffer("distances", std::span<const float>(distances)),
        slopeBuffer("slopes", std::span<const glm::uvec2>(slopes)),
        offsetBuffer("offsets", std::span<const GLuint>(offsets)),
        cursorBuffer("cursors", std::span<const GLuint>(cursors)),
        counts("counts", std::span<const GLuint>(std::vector<GLuint>(4)));
    const auto bind = [](GLuint binding, const gl::Buffer& buffer) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.name());
    };
    bind(RANGES_IDS_BINDING, idBuffer);
    bind(RANGES_TIMES_BINDING, timeBuffer);
    bind(RANGES_DISTANCES_BINDING, distanceBuffer);
    bind(RANGES_SLOPES_BINDING, slopeBuffer);
    bind(RANGES_COUNTS_BINDING, counts);
    bind(LIST_OFFSETS_BINDING, offsetBuffer);
    bind(LIST_CURSORS_BINDING, cursorBuffer);
    const gl::Program& program =
        sharedRenderer().programs().get({.label = "ranges generate", .compute = "techniques/ranges/generate.comp"});
    program.use(gl::Inputs().set("texels", static_cast<std::uint32_t>(lists.size())));
    gl::dispatch(gl::groupsFor(lists.size(), 64));
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    ids = gl::readElements<GLuint>(idBuffer, 0, ids.size());
    times = gl::readElements<float>(timeBuffer, 0, ids.size());
    distances = gl::readElements<float>(distanceBuffer, 0, ids.size());
    slopes = gl::readElements<glm::uvec2>(slopeBuffer, 0, ids.size());
    EXPECT_EQ(gl::readElement<GLuint>(counts), 0u) << "lists with a fragment that has no partner";
    Lists result;
    for (std::size_t list = 0; list < lists.size(); ++list) {
        result.emplace_back();
        for (std::size_t i = offsets[list]; i < offsets[list + 1]; ++i)
            result.back().push_back({ids[i], times[i], distances[i], slopes[i]});
    }
    return result;
}

TEST(RangeOrder, OfArrivalDecidesNothing) {
    std::mt19937 random(11);
    for (int round = 0; round < 10; ++round) {
        Lists lists = madeLists(random);
        for (auto& list : lists) std::sort(list.begin(), list.end(), before);
        const Lists sorted = lists;
        EXPECT_EQ(generated(lists), sorted) << "in order";
        for (auto& list : lists) std::reverse(list.begin(), list.end());
        EXPECT_EQ(generated(lists), sorted) << "reversed";
        for (auto& list : lists) std::shuffle(list.begin(), list.end(), random);
        EXPECT_EQ(generated(lists), sorted) << "shuffled";
    }
}

}  // namespace
}  // namespace timeshade
