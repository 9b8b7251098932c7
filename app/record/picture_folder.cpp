#include "record/picture_folder.h"

#include <fmt/format.h>

#include "output_path.h"

namespace timeshade {

PictureFolder::PictureFolder(const std::filesystem::path& folder) : folder_(madeFolder(folder)), lock_(folder_) {
    requireWritable(pathOf(0));
}

void PictureFolder::add(const DisplayImage& frame) { writePng(pathOf(frames_++), frame); }

std::filesystem::path PictureFolder::pathOf(int number) const { return folder_ / fmt::format("{:04}.png", number); }

}  // namespace timeshade
