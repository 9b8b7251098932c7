#pragma once

#include <filesystem>
#include <string>

#include "image/part_folder.h"
#include "measure/verification.h"

namespace timeshade {

/// Writes what `verify` saw as three CSV files that other tools can check: triangles.csv, light.csv, samples.csv
/// (design section 4). Nine significant digits, one header line each, positions less the plan's origin. The folder
/// appears when all is whole: until then it is a PartFolder.
class SampleDump {
  public:
    /// Throws Error where the folder is there already or can't be made.
    SampleDump(const std::filesystem::path& folder, const FramePlan& plan);

    void add(const VerifiedSample& sample);
    void finish();

  private:
    void writeTriangles(const FramePlan& plan) const;
    void writeLight(const FramePlan& plan) const;

    PartFolder part_;
    std::string samples_;
};

}  // namespace timeshade
