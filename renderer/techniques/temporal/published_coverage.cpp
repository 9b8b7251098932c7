#include "techniques/temporal/published_coverage.h"

#include <array>

#include "techniques/temporal/bindings.shared.h"

namespace timeshade {

PublishedCoverage::PublishedCoverage(gl::ProgramCache& programs)
    : programs_(programs), target_("published coverage target") {
    target_.setColorCount(1);
}

void PublishedCoverage::draw(const MapSize& size, const MovingCovers& covers) {
    if (!coverage_ || MapSize(coverage_->width(), coverage_->height()) != size) {
        nearest_ = gl::Texture::array2D("nearest map", GL_RG32F, size.width, size.height, 1);
        coverage_ = gl::Texture::array2D("coverage map", GL_R32F, size.width, size.height, 1);
        depth_ = gl::Texture::array2D("coverage depth", GL_DEPTH_COMPONENT32F, size.width, size.height, 1);
        target_.attach(GL_DEPTH_ATTACHMENT, *depth_);
    }
    const std::array<GLfloat, 4> nobody{-1.0f, -1.0f, 0.0f, 0.0f};
    const float farthest = 0.0f;
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_GREATER);  // reversed
    target_.attach(GL_COLOR_ATTACHMENT0, *nearest_);
    target_.bindForDrawing(size.width, size.height);
    glClearNamedFramebufferfv(target_.name(), GL_COLOR, 0, nobody.data());
    glClearNamedFramebufferfv(target_.name(), GL_DEPTH, 0, &farthest);
    covers.draw(programs_, "techniques/temporal/published_nearest.frag", {}, {});

    target_.attach(GL_COLOR_ATTACHMENT0, *coverage_);
    target_.bindForDrawing(size.width, size.height);
    glClearNamedFramebufferfv(target_.name(), GL_COLOR, 0, nobody.data());
    glDepthFunc(GL_ALWAYS);
    covers.draw(programs_, "techniques/temporal/published_overlap.frag", {},
                gl::Inputs().texture("nearestMap", *nearest_));

    // The third pass reads the coverage map that it writes. A pass may not; but a triangle in the coverage map is the
    // one in the nearest map, so that is read instead.
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    covers.draw(programs_, "techniques/temporal/published_reset.frag", {},
                gl::Inputs().texture("nearestMap", *nearest_));
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

std::size_t PublishedCoverage::bytes() const {
    std::size_t sum = 0;
    for (const auto* texture : {&nearest_, &coverage_, &depth_}) sum += *texture ? (*texture)->bytes() : 0;
    return sum;
}

}  // namespace timeshade
