#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace timeshade {

/// An eight-bit picture: 3 channels, sRGB encoded, rows from top to bottom.
struct DisplayImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// A floating-point picture: 3 channels, linear light, rows from top to bottom.
struct LinearImage {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;
};

/// Both write to a temporary name in the same folder and rename it when whole: a full disk, a missing folder or a
/// kill leave either the old file or none. Throw Error that names the path and the system's reason. Equal pixels
/// give equal bytes. `note` (UTF-8), unless empty, goes into a text chunk "timeshade" of the PNG.
void writePng(const std::filesystem::path& path, const DisplayImage& image, const std::string& note = {});
void writeExr(const std::filesystem::path& path, const LinearImage& image);

/// Reads back what the functions above wrote, and any other PNG. Throws Error.
DisplayImage readPng(const std::filesystem::path& path);
LinearImage readExr(const std::filesystem::path& path);

/// Writes bytes under the same promise. For JSON and text.
void writeFileAtomically(const std::filesystem::path& path, std::span<const char> bytes);

/// Throws Error now if a file at this path could not be written later: a missing folder, no permission, a folder in
/// its place. Called before long work starts.
void requireWritable(const std::filesystem::path& path);

}  // namespace timeshade
