#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compare/picture_text.h"
#include "options.h"
#include "techniques/technique.h"

namespace timeshade {

/// One of the techniques that are drawn of a moment, with what it is called on the picture.
struct ComparedTechnique {
    std::unique_ptr<Technique> technique;
    std::string label;  ///< "ranges, 8 spp"; empty where it stands alone
};

/// The two that --compare names, or the one of --technique.
std::vector<ComparedTechnique> techniquesFor(const Options& options, gl::ProgramCache& programs);

/// Their pictures as the one that the options ask for, labelled. One picture alone stays as it is.
DisplayImage composedFor(const Options& options, double seam, const std::vector<ComparedTechnique>& techniques, const std::vector<DisplayImage>& pictures,
                         const PictureText& text);

} // namespace timeshade
