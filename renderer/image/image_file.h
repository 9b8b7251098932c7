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

/// Both write to a temporary name in the same folder and rename it when the file is complete: a full disk, a missing
/// folder or a kill leaves either the old file or none. Throw Error that names the path and the system's reason. Equal
/// pixels give equal bytes. `image.rgb` must hold 3 * width * height values (checked). A `note` (UTF-8) that is not
/// empty is stored in a text chunk "timeshade" of the PNG.
void writePng(const std::filesystem::path& path, const DisplayImage& image, const std::string& note = {});
void writeExr(const std::filesystem::path& path, const LinearImage& image);

/// Read a PNG of any kind, and an EXR of scan lines with the channels R, G and B. Throw Error.
DisplayImage readPng(const std::filesystem::path& path);
LinearImage readExr(const std::filesystem::path& path);

/// Writes bytes atomically, as above. For JSON and text.
void writeFileAtomically(const std::filesystem::path& path, std::span<const char> bytes);

/// Throws Error if a file at this path could not be written: missing folder, no permission, or the path is a folder.
/// Called before long work starts.
void requireWritable(const std::filesystem::path& path);

}  // namespace timeshade
