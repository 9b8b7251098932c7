#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "plan/frame_plan.h"

namespace timeshade {

/// Embree at its best on a frame's camera samples, as the baseline to measure against: linear motion blur, packets of
/// eight neighbours in one stratum, all threads, no callbacks, floats throughout. No doubtful sample is resolved
/// exactly, and nothing is handed over: this is the bare loop. The reference is Oracle.
class EmbreeBaseline {
  public:
    /// Makes room for what is traced; the plan must outlive it. Throws Error where alpha cuts something out.
    explicit EmbreeBaseline(const FramePlan& plan);
    ~EmbreeBaseline();
    EmbreeBaseline(const EmbreeBaseline&) = delete;
    EmbreeBaseline& operator=(const EmbreeBaseline&) = delete;

    /// Builds the acceleration structure: before anything is traced.
    void build();
    /// Makes the rays of all camera samples without tracing them: what that costs alone.
    void makeRays();
    /// Traces what every camera sample sees: [stratum][row from the bottom][column].
    const std::vector<std::uint32_t>& tracePrimaries();
    /// Traces a shadow ray from every point that tracePrimaries has hit to the light at its time. Returns how many are
    /// in shadow.
    std::size_t traceShadows();

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace timeshade
