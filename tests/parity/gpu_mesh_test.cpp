// Only what has changed of a mesh is uploaded, and the device then holds all of it.
#include <gtest/gtest.h>

#include <cstring>

#include "gl/changed_upload.h"
#include "gl/read_back.h"
#include "passes/gpu_mesh.h"
#include "scene_catalogue.h"
#include "support/gl_environment.h"

namespace timeshade {
namespace {

void expectHolds(const gl::Buffer& buffer, const std::vector<glm::vec4>& values) {
    const auto held = gl::readElements<glm::vec4>(buffer, 0, values.size());
    EXPECT_EQ(std::memcmp(held.data(), values.data(), values.size() * sizeof(glm::vec4)), 0);
}

TEST(GpuMesh, UploadsWhatMovesAndHoldsAll) {
    const std::unique_ptr<Scene> scene = openScene("chess", "");
    FramePlanner planner(*scene);
    FrameRequest request;
    GpuMesh mesh;
    std::size_t first = 0;
    for (const double frame : {0.0, 1.0, 1.0, 7.0}) {
        request.frame = frame;
        const FramePlan plan = planner.plan(request);
        mesh.update(plan);
        expectHolds(mesh.positions(), plan.texels->positions);
        if (first == 0)
            first = mesh.uploadedBytes();
        else
            EXPECT_LT(mesh.uploadedBytes(), first / 4) << "three of the pieces move";
    }
    EXPECT_GT(first, std::size_t{1} << 20);
}

TEST(GpuMesh, ChangedRunsAreFoundWhereverTheyLie) {
    constexpr std::size_t count = 5000;  // 20,000 bytes: four whole blocks and a part
    std::vector<std::uint32_t> before(count, 1);
    gl::Buffer buffer("numbers", std::span<const std::uint32_t>(before));
    for (const std::vector<std::size_t>& places :
         {std::vector<std::size_t>{}, {0}, {1023, 1024}, {4999}, {0, 2048, 4999}, {1024, 2048, 3072}}) {
        std::vector<std::uint32_t> now = before;
        for (const std::size_t place : places) ++now[place];
        const std::size_t bytes =
            gl::uploadChanged(buffer, std::span<const std::uint32_t>(now), std::span<const std::uint32_t>(before));
        EXPECT_EQ(gl::readElements<std::uint32_t>(buffer, 0, count), now);
        EXPECT_LE(bytes, places.size() * 4096);
        before = now;
    }
}

}  // namespace
}  // namespace timeshade
