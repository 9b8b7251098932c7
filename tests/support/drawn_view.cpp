#include "support/drawn_view.h"

#include "support/gl_environment.h"

namespace timeshade {

std::vector<float> drawnView(const FramePlan& plan, Technique& technique, const std::string& name) {
    FrameRenderer& renderer = sharedRenderer();
    renderer.draw(plan, technique, View::Final, name);
    const LinearImage image = renderer.readRadiance();
    std::vector<float> values;
    for (int y = image.height - 1; y >= 0; --y)  // rows upwards, as the buffers have them
        for (int x = 0; x < image.width; ++x)
            values.push_back(image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                            static_cast<std::size_t>(x))]);
    return values;
}

}  // namespace timeshade
