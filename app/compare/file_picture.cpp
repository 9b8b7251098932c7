#include "compare/file_picture.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "measure/display_encoding.h"

namespace timeshade {

FilePicture::FilePicture(std::string path) : path_(std::move(path)) {
    if (path_.ends_with(".exr")) {
        linear_ = readExr(path_);
        width_ = linear_.width;
        height_ = linear_.height;
    } else {
        display_ = readPng(path_);
        width_ = display_.width;
        height_ = display_.height;
    }
    if (long{width_} * height_ > mostPixels)
        throw Error(fmt::format("{}: is {} x {}, expected at most {} pixels", path_, width_, height_, mostPixels));
}

std::string FilePicture::label() const { return std::filesystem::path(path_).filename().string(); }

DisplayImage FilePicture::shown(const DisplayLook& look) const {
    return linear_.rgb.empty() ? display_ : displayed(linear_, look);
}

const LinearImage& FilePicture::radiance() const {
    if (linear_.rgb.empty())
        throw Error(fmt::format("{}: a PNG holds no linear light; expected an EXR to be written beside an EXR", path_));
    return linear_;
}

void FilePicture::requireSize(int width, int height) const {
    if (!hasSize(width, height))
        throw Error(fmt::format("{}: is {} x {}, expected {} x {} as the picture it is compared with", path_, width_,
                                height_, width, height));
}

}  // namespace timeshade
