#include "plan/view_plan.h"

#include <algorithm>
#include <cmath>

namespace timeshade {

namespace {

/// Columns right, up, corner: maps (s, t, 1) to the ray of the image position (s, t).
glm::dmat3 rayMatrix(const ViewEnd& end) { return {end.right, end.up, end.corner}; }

glm::mat4 viewMatrix(const glm::dmat3& viewFromWorld, const glm::dvec3& eye) {
    glm::dmat4 matrix(viewFromWorld);
    matrix[3] = glm::dvec4(-(viewFromWorld * eye), 1.0);
    return glm::mat4(matrix);
}

}  // namespace

ViewEnd viewEndOf(const CameraPose& pose, const glm::dvec3& origin, double aspect) {
    const double height = 2.0 * std::tan(0.5 * pose.verticalFieldOfView);
    ViewEnd end;
    end.eye = pose.eye - origin;
    end.right = pose.axes[0] * (height * aspect);
    end.up = pose.axes[1] * height;
    end.corner = -pose.axes[2] - 0.5 * end.right - 0.5 * end.up;
    return end;
}

void finishView(ViewPlan& view, glm::dvec2 size, double nearDistance, double farDistance) {
    shared::ViewBlock& block = view.block;
    block.size = glm::vec2(size);
    block.nearDistance = static_cast<float>(nearDistance);
    block.farDistance = static_cast<float>(farDistance);
    block.raysOpen = block.raysClose = glm::mat4(1.0f);
    view.turns = false;
    if (view.projection == Projection::Orthographic) {
        // corner, right and up span the map; depth is across it.
        const auto matrixOf = [](const ViewEnd& end) {
            return viewMatrix(glm::inverse(glm::dmat3(end.right, end.up, end.direction)), end.eye + end.corner);
        };
        block.viewFromWorldOpen = matrixOf(view.open);
        block.viewFromWorldClose = matrixOf(view.close);
        return;
    }
    const glm::dmat3 open = rayMatrix(view.open), close = rayMatrix(view.close);
    double difference = 0.0;
    for (int column = 0; column < 3; ++column)
        difference = std::max(difference, glm::length(open[column] - close[column]));
    view.turns = difference > 1e-12;
    // The view coordinates of a turning view use its axes at u = 1/2, so that its ray matrices stay near the identity.
    const glm::dmat3 viewFromWorld = glm::inverse(view.turns ? 0.5 * (open + close) : open);
    block.viewFromWorldOpen = viewMatrix(viewFromWorld, view.open.eye);
    block.viewFromWorldClose = viewMatrix(viewFromWorld, view.close.eye);
    if (view.turns) {
        block.raysOpen = glm::mat4(glm::dmat4(viewFromWorld * open));
        block.raysClose = glm::mat4(glm::dmat4(viewFromWorld * close));
    }
}

}  // namespace timeshade
