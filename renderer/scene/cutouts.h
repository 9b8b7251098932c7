#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "scene/material.h"

namespace timeshade {

/// The alphas of all materials of a scene that are cut out, in one block. Immutable.
class Cutouts {
  public:
    /// One material's part of the block: `height` rows of `width` bytes, from the top as in glTF.
    struct Sheet {
        bool cuts = false;  ///< false: the material is not cut out, and the rest means nothing
        float threshold = 0.0f;
        int width = 0, height = 0;
        std::size_t first = 0;  ///< byte in alphas()
        Wrap wrapU = Wrap::Repeat, wrapV = Wrap::Repeat;
        bool nearest = false;
    };

    /// Null where no material is cut out.
    static std::shared_ptr<const Cutouts> of(const std::vector<Material>& materials, const std::vector<Image>& images);

    const Sheet& sheet(std::size_t material) const { return sheets_[material]; }
    const std::vector<Sheet>& sheets() const { return sheets_; }  ///< one a material
    const std::vector<std::uint8_t>& alphas() const { return alphas_; }

  private:
    std::vector<Sheet> sheets_;
    std::vector<std::uint8_t> alphas_;
};

}  // namespace timeshade
