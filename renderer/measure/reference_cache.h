#pragma once

#include "image/image_file.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace timeshade {

/// Keeps converged reference images between runs. It may lose anything at any time and never gives back anything but
/// what was stored: each file holds its key, its size and a SHA-256 of everything before it, and all of that is
/// verified on every load. No function throws: a cache that does not work costs time, not a measurement.
class ReferenceCache {
  public:
    static constexpr std::uintmax_t defaultMaximumBytes = std::uintmax_t{512} << 20;

    /// The folder is made when something is stored. With an empty path nothing is kept.
    explicit ReferenceCache(std::filesystem::path folder = defaultFolder(),
                            std::uintmax_t maximumBytes = defaultMaximumBytes);

    /// $XDG_CACHE_HOME/timeshade, ~/.cache/timeshade where that is not set to an absolute path, empty without a home.
    static std::filesystem::path defaultFolder();

    /// The image stored under this key and size, bit for bit. A file of ours that fails a check is deleted.
    std::optional<LinearImage> load(const std::string& key, int width, int height) const;

    /// The key is text that says everything the image depends on. False where it could not be kept. Afterwards the
    /// images that were not used for longest are deleted until all fit the maximum; this one stays.
    bool store(const std::string& key, const LinearImage& image) const;

    /// Where load and store look. Images of two sizes under one key are two files.
    std::filesystem::path fileOf(const std::string& key, int width, int height) const;

  private:
    void shrink(const std::filesystem::path& newest) const;

    std::filesystem::path folder_;
    std::uintmax_t maximumBytes_;
};

}  // namespace timeshade
