// Models: .gltf and .glb, with the images inside them, and a frame of what was read.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include "core/check.h"
#include "read_or_refused.h"
#include "scene/gltf_scene.h"

namespace {

using namespace timeshade;

/// A file without a folder: models are read by path.
class MemoryFile {
  public:
    MemoryFile(const std::uint8_t* data, std::size_t size) : descriptor_(::memfd_create("model", MFD_CLOEXEC)) {
        CHECK(descriptor_ >= 0);
        CHECK_EQ(::write(descriptor_, data, size), static_cast<ssize_t>(size));
    }
    ~MemoryFile() { ::close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  private:
    int descriptor_;
};

void requireSound(const MotionMesh& mesh) {
    for (const auto* positions : {&mesh.positionsOpen, &mesh.positionsClose})
        for (const glm::dvec3& p : *positions) CHECK(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    for (const glm::u32vec3& triangle : mesh.topology->triangles)
        for (int corner = 0; corner < 3; ++corner) CHECK(triangle[corner] < mesh.topology->vertexCount);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const MemoryFile file(data, size);
    fuzz::readOrRefused([&] {
        const auto scene = loadGltf(file.path(), {.memoryLimit = std::uint64_t{64} << 20});
        requireSound(scene->motionMesh(0.1, 0.2));
        scene->innerMotion(0.1, 0.2);
        for (std::size_t i = 0; i < scene->cameras().size(); ++i) scene->cameraEnds(i, 0.1, 0.2);
        scene->lightEnds(0.1, 0.2);
    });
    return 0;
}
