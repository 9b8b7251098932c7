#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include <sys/types.h>

namespace timeshade {

/// A new file beside the one that it is to become: whole or not at all. Its name cannot be foreseen, it never follows a
/// link, and it is deleted unless it is renamed. What killed programs left behind of the same file is deleted on the
/// way; the lock that each holds on its own part says which these are.
///
/// A link in the target's place is followed where it belongs to this user or to root, and is refused otherwise: in a
/// folder that others can write to, a link may lead anywhere. Throws Error that names the path and the system's reason.
class PartFile {
  public:
    explicit PartFile(std::filesystem::path path);
    ~PartFile();
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    /// Open for reading and writing; closed when another program is started, unless it is handed on.
    int descriptor() const { return descriptor_; }
    void write(std::span<const char> bytes);
    /// Makes the bytes safe on disk, gives the file the permissions of the one that it replaces, and renames it.
    void renameOntoTarget();

  private:
    void create();
    void removeLeftovers() const;

    std::filesystem::path path_;    ///< as the user wrote it
    std::filesystem::path target_;  ///< with links followed
    std::optional<mode_t> mode_;    ///< permissions of the file that is there now
    std::filesystem::path part_;
    int descriptor_ = -1;
    bool renamed_ = false;
};

/// What lies at a path that is to be written.
enum class TargetKind { Nothing, File, Stream };

/// The kind, with links followed as PartFile follows them. Throws Error for a folder, for what may not be written, and
/// for links of others. A stream (device, pipe) is written to and never replaced.
TargetKind kindOfTarget(const std::filesystem::path& path);

/// Writes all of the bytes to an open file. Throws Error that names `path`, which is what the user wrote.
void writeAll(const std::filesystem::path& path, int descriptor, std::span<const char> bytes);

/// The path with links followed as PartFile follows them.
std::filesystem::path followOwnLinks(const std::filesystem::path& path);

}  // namespace timeshade
