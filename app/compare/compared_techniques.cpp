#include "compare/compared_techniques.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "compare/composed_picture.h"
#include "frame_setup.h"
#include "options_text.h"

namespace timeshade {

namespace {

/// "bias 2; dynamic bias on"; empty where all settings but the number of renders are at their defaults.
std::string changedInWords(Technique& technique) {
    std::string words;
    for (const Setting& setting : settingsOf(technique)) {
        if (!isChanged(setting) || (setting.key == "renders" && technique.renders() > 1)) continue;
        std::string key = setting.key;
        std::replace(key.begin(), key.end(), '_', ' ');
        words += (words.empty() ? "" : "; ") + key + " " + textOf(setting);
    }
    return words;
}

}  // namespace

std::string sampleCountLabel(Technique& technique, int samplesPerPixel) {
    std::string label = technique.description().shortTitle;
    if (const std::string changed = changedInWords(technique); !changed.empty()) label += " (" + changed + ")";
    if (technique.renders() > 1) return fmt::format("{}, {} renders", label, technique.renders());
    return fmt::format("{}, {} spp", label, samplesPerPixel);
}

std::vector<std::string> labelsOf(const std::vector<ComparedTechnique>& techniques) {
    std::vector<std::string> labels;
    for (const ComparedTechnique& compared : techniques) labels.push_back(compared.label);
    return labels;
}

FrameRequest ComparedTechnique::on(FrameRequest request) const {
    if (side.samplesPerPixel) request.samplesPerPixel = *side.samplesPerPixel;
    return request;
}

namespace {

ComparedTechnique comparedOf(const std::string& text, const PictureOptions& options, gl::ProgramCache& programs) {
    ComparedTechnique compared{ComparedSide::of(text), nullptr, nullptr, ""};
    const ComparedSide& side = compared.side;
    switch (side.kind) {
    case ComparedSide::Kind::Truth: compared.label = truthLabel(truthSamples); break;
    case ComparedSide::Kind::File:
        compared.file = std::make_unique<FilePicture>(side.path);
        compared.file->requireSize(options.width, options.height);
        compared.label = compared.file->label();
        break;
    case ComparedSide::Kind::Technique:
        compared.technique = side.variant.make(options.settings, programs);
        compared.label = sampleCountLabel(*compared.technique, side.samplesPerPixel.value_or(options.samplesPerPixel));
    }
    return compared;
}

}  // namespace

std::vector<ComparedTechnique> techniquesFor(const PictureOptions& options, gl::ProgramCache& programs) {
    std::vector<ComparedTechnique> techniques;
    for (const std::string& variant : options.compared) techniques.push_back(comparedOf(variant, options, programs));
    if (techniques.empty()) techniques.push_back({{}, techniqueFor(options, programs), nullptr, ""});
    return techniques;
}

FrameRequest askedByAll(FrameRequest request, const std::vector<ComparedTechnique>& techniques) {
    for (const ComparedTechnique& compared : techniques)
        if (compared.technique) request = compared.technique->asked(std::move(request));
    return request;
}

DisplayImage composedFor(const CompareOptions& options, double seam, const std::vector<std::string>& labels,
                         const std::vector<DisplayImage>& pictures, const PictureText& text) {
    if (pictures.size() == 1) return pictures.front();
    const int width = pictures.front().width;
    DisplayImage picture = composed(pictures[0], pictures[1], options.compareMode, seam, options.compareGain);
    if (options.compareMode == CompareMode::Difference) {
        text.drawLabel(picture, differenceLabel(options.compareGain, labels[0], labels[1]), 0, width,
                       PictureText::Side::Left);
        return picture;
    }
    const int column = options.compareMode == CompareMode::Side ? width / 2 : seamColumn(width, seam);
    text.drawLabel(picture, labels[0], 0, column, PictureText::Side::Left);
    text.drawLabel(picture, labels[1], column, width, PictureText::Side::Right);
    return picture;
}

}  // namespace timeshade
