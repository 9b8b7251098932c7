#include "plan/motion_classifier.h"

#include <atomic>
#include <cstring>

#include "core/parallel.h"
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

/// Whether camera samples have the same places and times.
bool samePattern(const shared::FrameBlock& a, const shared::FrameBlock& b) {
    return a.seed == b.seed && a.timeBase == b.timeBase && a.timeScale == b.timeScale &&
           a.firstStratum == b.firstStratum && a.imageSize == b.imageSize && a.pixelCentres == b.pixelCentres &&
           a.positions == b.positions;
}

/// As many as are worth a thread.
constexpr std::size_t trianglesTogether = 2048;

/// What of some triangles is other than in the frame before.
struct Changes {
    std::size_t reclassified = 0;
    bool casters = false;  ///< static casters
    bool seen = false;     ///< what the camera sees of what stands still
    bool shading = false;  ///< normals of that

    /// `before`: null where there is none to compare with.
    void add(const TriangleMotion& motion, const TriangleMotion* before, bool samePlace) {
        ++reclassified;
        if (before == nullptr) return;
        if (isStaticCaster(motion) || isStaticCaster(*before))
            casters = casters || !samePlace || isStaticCaster(motion) != isStaticCaster(*before);
        if (isStaticBeforeCamera(motion) || isStaticBeforeCamera(*before))
            seen = seen || !samePlace || isStaticBeforeCamera(motion) != isStaticBeforeCamera(*before);
    }
    /// Of a triangle that is where it was.
    void addShading(const TriangleMotion& motion, const MeshTexels& before, const MeshTexels& now, std::size_t id) {
        if (shading || &before == &now || !isStaticBeforeCamera(motion)) return;
        const std::size_t at = id * TRIANGLE_SHADING_TEXELS;
        shading = std::memcmp(&before.shading[at], &now.shading[at], TRIANGLE_SHADING_TEXELS * sizeof(glm::vec4)) != 0;
    }
};

/// What was found in the frame before.
struct Before {
    const MeshTexels* texels;  ///< null: there was none
    const MotionClassifier::Motion& motion;
    bool sameViews;
};

/// Fills in what `now` says of triangles, and returns what is other.
Changes classify(const MeshTexels& texels, const FrameViews& views, const Before& before,
                 MotionClassifier::Motion& now) {
    const std::size_t count = texels.positions.size() / TRIANGLE_POSITION_TEXELS;
    auto triangles = before.sameViews ? std::make_shared<std::vector<TriangleMotion>>(*before.motion.triangles)
                                      : std::make_shared<std::vector<TriangleMotion>>(count);
    auto inMap = before.sameViews ? std::make_shared<std::vector<shared::SweptBounds>>(*before.motion.inMap)
                                  : std::make_shared<std::vector<shared::SweptBounds>>(count);
    std::atomic<std::size_t> reclassified{0};
    std::atomic<bool> casters{false}, seen{false}, shading{false};
    forRanges(count, trianglesTogether, [&](std::size_t begin, std::size_t end) {
        Changes changes;
        for (std::size_t id = begin; id < end; ++id) {
            const std::size_t at = id * TRIANGLE_POSITION_TEXELS;
            const bool samePlace =
                before.texels != nullptr &&
                (before.texels == &texels || std::memcmp(&before.texels->positions[at], &texels.positions[at],
                                                         TRIANGLE_POSITION_TEXELS * sizeof(glm::vec4)) == 0);
            TriangleMotion& motion = (*triangles)[id];
            if (!(samePlace && before.sameViews)) {
                motion = motionOf(texels.positions, static_cast<std::uint32_t>(id), views, (*inMap)[id]);
                changes.add(motion, before.texels ? &(*before.motion.triangles)[id] : nullptr, samePlace);
            }
            if (samePlace) changes.addShading(motion, *before.texels, texels, id);
        }
        reclassified += changes.reclassified;
        if (changes.casters) casters = true;
        if (changes.seen) seen = true;
        if (changes.shading) shading = true;
    });
    now.triangles = std::move(triangles);
    now.inMap = std::move(inMap);
    return {reclassified, casters, seen, shading};
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
    bool sameShading = !first, sameCasters = sameLight, sameSeen = sameCamera && samePattern(block_, views.block);

    Motion now;
    if (!(sameCamera && sameLight && texels_ == texels)) {
        const Changes changes =
            classify(*texels, views, {first ? nullptr : texels_.get(), last_, sameCamera && sameLight}, now);
        now.reclassified = changes.reclassified;
        sameCasters = sameCasters && !changes.casters;
        sameSeen = sameSeen && !changes.seen;
        sameShading = !changes.shading;
    } else {
        now.triangles = last_.triangles;
        now.inMap = last_.inMap;
    }
    now.versions.casters = sameCasters ? last_.versions.casters : newVersion();
    now.versions.samples = sameSeen ? last_.versions.samples : newVersion();
    const bool sameLit = sameCasters && sameSeen && sameBlock;
    now.versions.lit = sameLit ? last_.versions.lit : newVersion();
    now.versions.shading = sameLit && sameShading ? last_.versions.shading : newVersion();
    texels_ = texels;
    camera_ = views.camera.block;
    light_ = views.light.block;
    block_ = views.block;
    last_ = now;
    return now;
}

}  // namespace timeshade
