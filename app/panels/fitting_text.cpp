#include "panels/fitting_text.h"

#include <imgui.h>

namespace timeshade {

std::string fittingText(std::string text, const std::string& end, float room) {
    while (ImGui::CalcTextSize((text + end).c_str()).x > room) {
        const std::size_t comma = text.rfind(", ");
        if (comma == std::string::npos) break;
        text.resize(comma);
    }
    return text + end;
}

}  // namespace timeshade
