#include "window/truth_refinement.h"

#include <utility>

#include "compare/compared_side.h"
#include "compare/truth_picture.h"
#include "window/display_texture.h"
#include "window/moment_key.h"

namespace timeshade {

namespace {

std::vector<double> keyOf(const FrameDriver::Wanted& wanted) {
    std::vector<double> key = momentKeyOf(wanted.request);
    key.insert(key.end(), {double(wanted.scene), double(wanted.shaders), double(wanted.view),
                           double(wanted.request.width), double(wanted.request.height)});
    return key;
}

}  // namespace

bool TruthRefinement::follows(const FrameDriver::Wanted& wanted) const { return builder_ && keyOf(wanted) == key_; }

bool TruthRefinement::update(const FrameDriver::Wanted& wanted) {
    if (std::vector<double> key = keyOf(wanted); !builder_ || key != key_) begin(wanted, std::move(key));
    const bool look = samples_ > 0 && look_ != wanted.request.look;
    if (look) show(wanted);
    if (rests()) return look;
    if (!renderer_) renderer_.emplace();
    builder_->step(*renderer_);
    if (builder_->complete() || builder_->batchesDone() > 0) show(wanted);
    if (builder_->complete()) renderer_.reset();
    return true;
}

void TruthRefinement::begin(const FrameDriver::Wanted& wanted, std::vector<double> key) {
    // The renderer stays: its programs are those of the next truth, too.
    samples_ = 0;
    stopped_ = false;
    builder_ = std::make_unique<ReferenceBuilder>(truthPlan(*wanted.planner, wanted.request), truthOptions(wanted.view),
                                                  cache_);
    key_ = std::move(key);
}

void TruthRefinement::show(const FrameDriver::Wanted& wanted) {
    image_ = truthShown(builder_->soFar(), wanted.view, wanted.request.look);
    look_ = wanted.request.look;
    upload(texture_, image_);
    samples_ = builder_->complete() ? truthSamples : builder_->batchesDone() * maximumSamplesPerPixel;
}

void TruthRefinement::clear() {
    builder_.reset();
    renderer_.reset();
    key_.clear();
    samples_ = 0;
    stopped_ = false;
    image_ = {};
    texture_.reset();
}

std::size_t TruthRefinement::bytes() const {
    const std::size_t values = image_.rgb.size();
    // Its sums in double precision or the picture in single, both on the screen and in memory.
    const std::size_t held = builder_ ? values * (complete() ? sizeof(float) : sizeof(double)) : 0;
    return held + values + values / 3 * 4 + (renderer_ ? renderer_->memory().total() : 0);
}

}  // namespace timeshade
