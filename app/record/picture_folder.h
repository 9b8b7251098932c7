#pragma once

#include <filesystem>

#include "core/folder_lock.h"
#include "record/frame_sink.h"

namespace timeshade {

/// A folder of 0000.png, 0001.png, ...; each is whole as soon as it is there.
class PictureFolder final : public FrameSink {
  public:
    /// Makes the folder where there is none. Throws Error where no picture can be written to it.
    explicit PictureFolder(const std::filesystem::path& folder);

    void add(const DisplayImage& frame) override;
    void finish() override {}
    std::string kept() const override { return folder_.string(); }

  private:
    std::filesystem::path pathOf(int number) const;

    std::filesystem::path folder_;
    FolderLock lock_;
    int frames_ = 0;
};

}  // namespace timeshade
