#include "window/frame_graph.h"

namespace timeshade {

void FrameGraph::note(const ShownPicture& shown) {
    if (shown.number == lastNumber_ || !shown.complete() || shown.newest <= 0.0) return;
    lastNumber_ = shown.number;
    if (bars_.size() == kept) bars_.erase(bars_.begin());
    bars_.push_back({static_cast<float>(shown.newest), shown.preview});
}

}  // namespace timeshade
