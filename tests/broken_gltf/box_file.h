#pragma once

#include <glm/glm.hpp>

#include "gltf_writer.h"

namespace timeshade::test {

/// An upright box between two corners, faces outwards.
inline int addBox(GltfFile& file, const glm::vec3& low, const glm::vec3& high) {
    std::vector<float> positions;
    for (int i = 0; i < 8; ++i)
        positions.insert(positions.end(), {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    return file.addMesh({{"POSITION", file.vec3s(positions)}},
                        file.addAccessor<std::uint16_t>({0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                                         2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6},
                                                        "SCALAR", 1));
}

/// A box of side 1 about the vertical axis, on y = 0, that sinks from y = 2 to 0.25 in the first second and rises again
/// in the next two, while it goes along x.
inline GltfFile fileWithBouncingBox() {
    GltfFile file;
    file.addRoot({{"name", "box"}, {"mesh", addBox(file, {-0.5f, 0.0f, -0.5f}, {0.5f, 1.0f, 0.5f})}});
    file.animate(0, "translation", {0, 1, 3}, file.vec3s({-1, 2, 0, 0, 0.25f, 0, -1, 2, 0}));
    return file;
}

}  // namespace timeshade::test
