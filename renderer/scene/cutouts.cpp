#include "scene/cutouts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/check.h"

namespace timeshade {

float cutoutThreshold(double cutoff, double factor) {
    constexpr double never = 1e6;
    if (!(cutoff > 0.0)) return 0.0f;
    const double threshold = factor > 0.0 ? std::min(255.0 * cutoff / factor, never) : never;
    // Images hold whole numbers: a cutoff that was meant to be one of them must not miss it by its rounding.
    const double whole = std::round(threshold);
    return static_cast<float>(std::abs(threshold - whole) < 1e-3 ? whole : threshold);
}

std::shared_ptr<const Cutouts> Cutouts::of(const std::vector<Material>& materials, const std::vector<Image>& images) {
    const auto cut = [](const Material& material) { return material.cutout.has_value(); };
    if (std::none_of(materials.begin(), materials.end(), cut)) return nullptr;
    auto cutouts = std::make_shared<Cutouts>();
    cutouts->sheets_.resize(materials.size());
    std::map<int, std::size_t> known;
    for (std::size_t m = 0; m < materials.size(); ++m) {
        if (!cut(materials[m])) continue;
        const Cutout& cutout = *materials[m].cutout;
        const TextureUse& use = materials[m].baseColor;
        Sheet& sheet = cutouts->sheets_[m];
        sheet = {true, cutout.threshold, 1, 1, cutouts->alphas_.size(), use.wrapU, use.wrapV, cutout.nearest};
        if (use.image >= 0) {
            const Image& image = images[static_cast<std::size_t>(use.image)];
            sheet.width = image.width;
            sheet.height = image.height;
        }
        const auto [place, isNew] = known.try_emplace(use.image, sheet.first);
        sheet.first = place->second;
        if (!isNew) continue;
        if (use.image < 0) {
            cutouts->alphas_.push_back(255);
            continue;
        }
        const std::vector<std::uint8_t>& rgba = images[static_cast<std::size_t>(use.image)].rgba;
        CHECK_EQ(rgba.size(), 4 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height));
        for (std::size_t i = 3; i < rgba.size(); i += 4) cutouts->alphas_.push_back(rgba[i]);
    }
    return cutouts;
}

}  // namespace timeshade
