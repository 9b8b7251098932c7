#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compare/compared_side.h"
#include "compare/file_picture.h"
#include "compare/picture_text.h"
#include "options/picture_options.h"
#include "technique/technique.h"

namespace timeshade {

/// One of the sides that are drawn of a moment, with what it is called on the picture.
struct ComparedTechnique {
    ComparedSide side;
    std::unique_ptr<Technique> technique;  ///< null for the ground truth and a file
    std::unique_ptr<FilePicture> file;     ///< null for what is drawn
    std::string label;                     ///< "Ranges, 8 spp"; empty where it stands alone

    /// The request on its own number of samples, where it has one.
    FrameRequest on(FrameRequest request) const;
};

/// The two that --compare names, or the one of --technique. Throws Error for a file that can't be read.
std::vector<ComparedTechnique> techniquesFor(const PictureOptions& options, gl::ProgramCache& programs);

/// The request as all of them ask for it: on one picture they are drawn on the same camera samples.
FrameRequest askedByAll(FrameRequest request, const std::vector<ComparedTechnique>& techniques);

/// What a viewer should know of a technique: "TSM, 8 spp", with settings that are not at their defaults
/// "TSM (bias 2; dynamic bias on), 8 spp"; of brute force its number of renders.
std::string sampleCountLabel(Technique& technique, int samplesPerPixel);

/// Their pictures as the one that the options ask for, labelled. One picture alone stays as it is.
DisplayImage composedFor(const CompareOptions& options, double seam, const std::vector<std::string>& labels,
                         const std::vector<DisplayImage>& pictures, const PictureText& text);

/// The techniques' labels.
std::vector<std::string> labelsOf(const std::vector<ComparedTechnique>& techniques);

}  // namespace timeshade
