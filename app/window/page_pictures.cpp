#include "window/page_pictures.h"

#include "core/data_folder.h"
#include "image/image_file.h"
#include "window/display_texture.h"

namespace timeshade {

const gl::Texture* PagePictures::of(const std::string& technique) {
    const auto [entry, isNew] = pictures_.try_emplace(technique);
    std::optional<gl::Texture>& picture = entry->second;
    if (isNew) {
        try {
            upload(picture, readPng(dataFolder() / "renderer" / "techniques" / technique / "page.png"));
            picture->setFilters(GL_LINEAR, GL_LINEAR);
        } catch (const std::exception&) {
            picture.reset();  // the page says the same in words
        }
    }
    return picture ? &*picture : nullptr;
}

}  // namespace timeshade
