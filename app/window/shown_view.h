#pragma once

#include <string>
#include <vector>

#include "options/technique_options.h"
#include "technique/technique.h"

namespace timeshade {

/// What is shown of a frame: light, one of the technique's own views, or a diagnostic in place of either.
struct ShownView {
    View light = View::Final;
    std::string ofTechnique;  ///< name of one of the technique's views, instead of `light`; empty for none
    Diagnostic diagnostic = Diagnostic::None;

    /// By the name of the command line. Ends a diagnostic, too.
    void show(const std::string& name);
    /// As on the command line; a diagnostic has none here.
    std::string name() const;
    /// Another technique, or another setting of it, may not have the view.
    void keepTo(const Technique& technique);
};

/// The views that can be shown of a technique, by the names of the command line: those of light first.
std::vector<std::string> viewNames(const Technique& technique);

}  // namespace timeshade
