#include "plan/motion_classifier.h"

#include <atomic>
#include <cstring>

#include "plan/frame_plan.h"

namespace timeshade {

namespace {

/// One counter for all planners, so that no number is used twice.
std::uint64_t newVersion() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

template <typename T>
bool sameBytes(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

bool isStaticCaster(const TriangleMotion& t) { return !t.light.moves && t.light.reach != Reach::Outside; }

bool isStaticBeforeCamera(const TriangleMotion& t) {
    return !t.camera.moves && t.camera.reach != Reach::Outside && (t.doubleSided || t.camera.facing != Facing::Away);
}

}  // namespace

MotionClassifier::Motion MotionClassifier::update(const std::shared_ptr<const MeshTexels>& texels,
                                                  const FrameViews& views) {
    const bool first = !texels_ || texels_->positions.size() != texels->positions.size();
    const bool sameCamera = !first && sameBytes(camera_, views.camera.block) && block_.strata == views.block.strata;
    const bool sameLight = !first && sameBytes(light_, views.light.block) &&
                           block_.lightDirection == views.block.lightDirection &&
                           block_.lightDirectionClose == views.block.lightDirectionClose &&
                           block_.lightPositionOpen == views.block.lightPositionOpen &&
                           block_.lightPositionClose == views.block.lightPositionClose;
    const bool sameBlock = !first && sameBytes(block_, views.block);
    const bool samePattern =
        block_.seed == views.block.seed && block_.timeBase == views.block.timeBase &&
        block_.timeScale == views.block.timeScale && block_.firstStratum == views.block.firstStratum &&
        block_.imageSize == views.block.imageSize && block_.pixelCentres == views.block.pixelCentres &&
        block_.positions == views.block.positions;
    bool sameCasters = sameLight, sameSeen = sameCamera && samePattern;

    Motion now;
    if (!(sameCamera && sameLight && texels_ == texels)) {
        const std::size_t count = texels->positions.size() / TRIANGLE_POSITION_TEXELS;
        const bool sameViews = sameCamera && sameLight;
        auto triangles = sameViews ? std::make_shared<std::vector<TriangleMotion>>(*last_.triangles)
                                   : std::make_shared<std::vector<TriangleMotion>>(count);
        auto inMap = sameViews ? std::make_shared<std::vector<shared::SweptBounds>>(*last_.inMap)
                               : std::make_shared<std::vector<shared::SweptBounds>>(count);
        for (std::uint32_t id = 0; id < count; ++id) {
            const std::size_t at = std::size_t{id} * TRIANGLE_POSITION_TEXELS;
            const bool samePlace =
                !first && (texels_ == texels || std::memcmp(&texels_->positions[at], &texels->positions[at],
                                                            TRIANGLE_POSITION_TEXELS * sizeof(glm::vec4)) == 0);
            if (samePlace && sameViews) continue;
            TriangleMotion& motion = (*triangles)[id];
            motion = motionOf(texels->positions, id, views, (*inMap)[id]);
            ++now.reclassified;
            if (first) continue;
            const TriangleMotion& before = (*last_.triangles)[id];
            if (isStaticCaster(motion) || isStaticCaster(before))
                sameCasters = sameCasters && samePlace && isStaticCaster(motion) == isStaticCaster(before);
            if (isStaticBeforeCamera(motion) || isStaticBeforeCamera(before))
                sameSeen = sameSeen && samePlace && isStaticBeforeCamera(motion) == isStaticBeforeCamera(before);
        }
        now.triangles = std::move(triangles);
        now.inMap = std::move(inMap);
    } else {
        now.triangles = last_.triangles;
        now.inMap = last_.inMap;
    }
    now.versions.casters = sameCasters ? last_.versions.casters : newVersion();
    now.versions.samples = sameSeen ? last_.versions.samples : newVersion();
    now.versions.lit = sameCasters && sameSeen && sameBlock ? last_.versions.lit : newVersion();
    texels_ = texels;
    camera_ = views.camera.block;
    light_ = views.light.block;
    block_ = views.block;
    last_ = now;
    return now;
}

}  // namespace timeshade
