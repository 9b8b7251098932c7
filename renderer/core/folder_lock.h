#pragma once

#include <filesystem>

namespace timeshade {

/// Keeps a folder to one writer: two programs that write into one folder would mix what they write. The lock is the
/// kernel's, on the folder itself: it leaves no file behind and ends with the process, however that ends. Throws Error
/// where another process holds it. File systems without locks (some network ones) are taken as free.
class FolderLock {
  public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int descriptor_ = -1;
};

}  // namespace timeshade
