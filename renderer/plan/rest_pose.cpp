#include "plan/rest_pose.h"

namespace timeshade {

const MotionMesh& RestPose::mesh() const {
    std::call_once(made_, [this] { mesh_.emplace(scene_.motionMesh(0.0, 0.0)); });
    return *mesh_;
}

}  // namespace timeshade
