#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace timeshade::gltf {

using Bytes = std::vector<std::uint8_t>;

/// The whole of a regular file. Anything else (folder, pipe, device, missing, longer than limit) is an Error.
Bytes readRegularFile(const std::filesystem::path& path, std::size_t limit);

/// What a model may refer to: data URIs, and regular files inside the model's own folder. A file is read once,
/// however often it is named, so that memory is bounded by what lies on the disk.
class FilesBeside {
  public:
    /// limit: bytes in all.
    FilesBeside(std::filesystem::path folder, std::size_t limit) : folder_(std::move(folder)), left_(limit) {}

    /// The bytes that a buffer's or image's `uri` stands for; Error where it may not be read.
    std::shared_ptr<const Bytes> read(const std::string& uri);

  private:
    std::filesystem::path resolve(const std::string& uri) const;

    std::filesystem::path folder_;
    std::size_t left_;
    std::map<std::filesystem::path, std::shared_ptr<const Bytes>> known_;
};

}  // namespace timeshade::gltf
