#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/memory_budget.h"
#include "core/sha256.h"

namespace timeshade::gltf {

using Bytes = std::vector<std::uint8_t>;

/// Reads a whole regular file. Throws Error for anything else: folder, pipe, device, missing file, more than `limit`
/// bytes, or more than `memory` has left, where they are counted.
Bytes readRegularFile(const std::filesystem::path& path, std::size_t limit, MemoryBudget& memory);

/// The files that a model may refer to: data URIs, and regular files inside the model's own folder. A file there may be
/// a link to one elsewhere whose name is a hash, as caches of downloads have them; a folder may not. Each file is read
/// once, however often it is named, so that memory is bounded by the files' sizes.
class FilesBeside {
  public:
    /// limit: total bytes. They are counted in `memory` as well.
    FilesBeside(std::filesystem::path folder, std::size_t limit, std::shared_ptr<MemoryBudget> memory)
        : folder_(std::move(folder)), left_(limit), memory_(std::move(memory)) {}

    /// The bytes of a buffer's or image's `uri`. Throws Error if it must not or cannot be read.
    std::shared_ptr<const Bytes> read(const std::string& uri);

    /// Of the names and contents of all files read so far; data URIs are part of the model's own file.
    Sha256 digest() const;

  private:
    std::filesystem::path resolve(const std::string& uri) const;

    std::filesystem::path folder_;
    std::size_t left_;
    std::shared_ptr<MemoryBudget> memory_;
    std::map<std::filesystem::path, std::shared_ptr<const Bytes>> known_;
};

}  // namespace timeshade::gltf
