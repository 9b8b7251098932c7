#pragma once

#include <memory>

#include "oracle/oracle.h"

namespace timeshade {

/// The oracle of one piece of a shutter after another: built anew where the motion is another one.
class PieceOracle {
  public:
    const Oracle& of(const FramePlan& plan) {
        if (mesh_ != plan.mesh) oracle_ = std::make_unique<Oracle>(plan);
        mesh_ = plan.mesh;
        return *oracle_;
    }

  private:
    std::unique_ptr<Oracle> oracle_;
    std::shared_ptr<const MotionMesh> mesh_;
};

}  // namespace timeshade
