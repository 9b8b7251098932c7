#include "record/picture_folder.h"

#include <utility>

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

PictureFolder::PictureFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::error_code failure;
    std::filesystem::create_directories(folder_, failure);
    if (failure)
        throw Error(
            fmt::format("{}: cannot be made ({}); expected a folder to write to", folder_.string(), failure.message()));
    lock_.emplace(folder_);
    requireWritable(pathOf(0));
}

void PictureFolder::add(const DisplayImage& frame) { writePng(pathOf(frames_++), frame); }

std::filesystem::path PictureFolder::pathOf(int number) const { return folder_ / fmt::format("{:04}.png", number); }

}  // namespace timeshade
