#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "measure/reference_cache.h"
#include "oracle/oracle.h"

namespace timeshade {

/// The converged visibility of every pixel of a frame: the oracle's mean over the whole shutter, weighted by its
/// response, and the pixel's area, in two independent halves of rays / 2 camera rays a pixel. What shadow errors are
/// measured against.
struct ReferenceVisibility {
    int width = 0, height = 0;
    int rays = 0;                      ///< camera rays a pixel, both halves together
    std::vector<float> first, second;  ///< means of the halves, [row from the bottom][column]; NONE where no ray of the
                                       ///< half saw a surface that faces the light inside its cone

    static constexpr float NONE = -1.0f;
    static constexpr int defaultRays = 1024;
    /// The pixel has a visibility: both halves do. These are the pixels over which shadow errors are taken.
    bool has(std::size_t pixel) const { return first[pixel] >= 0.0f && second[pixel] >= 0.0f; }
};

/// Computes it some rows at a time, so that a window stays alive meanwhile, or takes it from the cache. The cache must
/// outlive it.
class ReferenceVisibilityBuilder {
  public:
    /// `rays` is rounded up to whole packets of both halves, and of all pieces of the shutter. Sample count, seed and
    /// map size of the plan do not matter.
    ReferenceVisibilityBuilder(FramePlan plan, int rays, const ReferenceCache& cache);
    ~ReferenceVisibilityBuilder();
    ReferenceVisibilityBuilder(const ReferenceVisibilityBuilder&) = delete;
    ReferenceVisibilityBuilder& operator=(const ReferenceVisibilityBuilder&) = delete;

    bool complete() const { return complete_; }
    int rowsDone() const { return rowsDone_; }
    /// Of all pieces of the shutter.
    int rows() const { return result_->height * pieces(); }
    /// Looks into the cache the first time, and computes some rows each time after that. True when it is complete.
    bool step();
    /// Once it is complete.
    std::shared_ptr<const ReferenceVisibility> result() const { return result_; }

  private:
    int pieces() const { return rendersOf(plan_, 1); }
    bool load();
    void store() const;

    FramePlan plan_;
    const ReferenceCache& cache_;
    std::string key_;
    std::unique_ptr<Oracle> oracle_;  ///< of the piece that is being traced
    std::vector<VisibilityMean> sums_[2];
    std::shared_ptr<ReferenceVisibility> result_;
    int rowsDone_ = 0;
    bool soughtInCache_ = false, complete_ = false;
};

/// The same in one go. `progress` is told rows done, of how many, if set.
std::shared_ptr<const ReferenceVisibility> referenceVisibility(const FramePlan& plan, int rays,
                                                               const ReferenceCache& cache,
                                                               const std::function<void(int, int)>& progress = {});

/// The cache key: two frames with one key have one converged visibility.
std::string referenceVisibilityKey(const FramePlan& plan, int rays);

}  // namespace timeshade
