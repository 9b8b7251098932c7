#include "record/part_painter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/truth_picture.h"
#include "frame/warm_up.h"
#include "frame_setup.h"
#include "record/camera_path.h"
#include "record/stop_signals.h"

namespace timeshade {

namespace {

/// How long after a frame was drawn its picture is read, in frames.
constexpr int framesLate = 2;

int oneTurn(const Scene& scene, const FrameRequest& request) {
    return std::max(1, static_cast<int>(std::lround(scene.duration() * request.shutter.framesPerSecond)));
}

}  // namespace

PartPainter::PartPainter(FrameRenderer& renderer, const ScriptPart& part, const Scene& scene, const PictureText& text)
    : renderer_(renderer),
      part_(part),
      scene_(scene),
      text_(text),
      planner_(scene),
      first_(requestFor(part.drawn, scene)),
      techniques_(techniquesFor(part.drawn, renderer.programs())) {
    // A turn begins at its beginning, not where the scene looks best.
    if (!part.drawn.frame && !part.drawn.seconds) first_.frame = 0.0;
    frames_ = part.frames > 0 ? part.frames : oneTurn(scene, first_);
    if (part.cameraTo.empty()) return;
    FrameOptions there = part.drawn;
    there.camera = part.cameraTo;
    cameraTo_ = requestFor(there, scene).cameraIndex;
}

double PartPainter::shareOfPart(int frame) const {
    return frames_ > 1 ? static_cast<double>(frame) / (frames_ - 1) : 0.0;
}

FrameRequest PartPainter::requestOf(int frame) const {
    FrameRequest request = first_;
    request.frame += frame * part_.step;
    if (cameraTo_) {
        const double seconds = shutterTimes(scene_, request).open;
        request.cameraPose = between(scene_.camera(request.cameraIndex, seconds), scene_.camera(*cameraTo_, seconds),
                                     eased(shareOfPart(frame)));
    }
    return request;
}

bool PartPainter::drawNext() {
    const FrameRequest request = askedByAll(requestOf(drawn_), techniques_);
    std::vector<DrawnPicture> pictures;
    for (const ComparedTechnique& compared : techniques_) {
        std::optional<DrawnPicture> picture = pictureOf(compared, request);
        if (!picture) return false;
        pictures.push_back(std::move(*picture));
    }
    unread_.push_back(std::move(pictures));
    ++drawn_;
    return true;
}

std::optional<DisplayImage> PartPainter::next() {
    while (drawn_ < std::min(frames_, done_ + 1 + framesLate) && StopSignals::count() == 0 && drawNext()) {
    }
    if (unread_.empty()) return std::nullopt;
    std::vector<DisplayImage> pictures;
    for (DrawnPicture& picture : unread_.front())
        if (auto* late = std::get_if<LatePicture>(&picture))
            pictures.push_back(late->take());
        else
            pictures.push_back(std::get<DisplayImage>(std::move(picture)));
    unread_.pop_front();
    DisplayImage picture =
        composedFor(part_.drawn, easedThrough(part_.seams, shareOfPart(done_)), labelsOf(techniques_), pictures, text_);
    text_.drawCaption(picture, part_.title, part_.caption);
    ++done_;
    return picture;
}

std::optional<PartPainter::DrawnPicture> PartPainter::pictureOf(const ComparedTechnique& compared,
                                                                const FrameRequest& request) {
    const View view = part_.drawn.view;
    if (compared.file) return compared.file->shown(request.look);
    if (!compared.technique) {
        const std::optional<LinearImage> truth =
            drawTruth(renderer_, planner_, request, view, [](int, int) { return StopSignals::count() == 0; });
        return truth ? std::optional<DrawnPicture>(truthShown(*truth, view, request.look)) : std::nullopt;
    }
    const FrameRequest own = compared.on(request);
    if (drawn_ == 0) drawWarmUp(renderer_, planner_, *compared.technique, own, view);
    return drawn(*compared.technique, own);
}

std::optional<PartPainter::DrawnPicture> PartPainter::drawn(Technique& technique, const FrameRequest& request) {
    renderer_.begin(planner_.plan(request), technique, part_.drawn.view, part_.drawn.techniqueView);
    while (StopSignals::count() == 0) {
        if (!renderer_.step()) continue;
        renderer_.timer().dropAll();  // a recording states no times
        return renderer_.askPicture();
    }
    return std::nullopt;
}

}  // namespace timeshade
