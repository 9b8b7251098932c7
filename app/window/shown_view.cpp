#include "window/shown_view.h"

#include <algorithm>

namespace timeshade {

void ShownView::show(const std::string& name) {
    diagnostic = Diagnostic::None;
    light = name == "visibility" ? View::Visibility : View::Final;
    ofTechnique = name == "final" || name == "visibility" ? "" : name;
}

std::string ShownView::name() const {
    if (!ofTechnique.empty()) return ofTechnique;
    return light == View::Visibility ? "visibility" : "final";
}

void ShownView::keepTo(const Technique& technique) {
    const std::vector<std::string> names = viewNames(technique);
    if (std::find(names.begin(), names.end(), name()) == names.end()) ofTechnique.clear();
}

std::vector<std::string> viewNames(const Technique& technique) {
    std::vector<std::string> names{"final", "visibility"};
    for (const TechniqueView& own : technique.views()) names.push_back(own.name);
    return names;
}

}  // namespace timeshade
