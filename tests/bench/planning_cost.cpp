// What the processor does for a frame before anything is drawn, by step: medians over frames of a playing scene.
#include <vector>

#include <fmt/format.h>

#include "frame_setup.h"
#include "plan/mesh_texels.h"
#include "scene_catalogue.h"
#include "timing.h"

using namespace timeshade;

namespace {

constexpr int frames = 41;

void report(const std::string& label, const Scene& scene) {
    FramePlanner planner(scene);
    FrameRequest request;
    request.width = 64;
    request.height = 48;
    request.mapSize = MapSize{512, 512};
    std::vector<double> deform, pack, whole;
    std::size_t triangles = 0;
    for (int frame = 0; frame < frames; ++frame) {
        request.frame = frame;
        const double open = request.shutter.openSeconds(request.frame),
                     close = request.shutter.closeSeconds(request.frame);
        MotionMesh mesh;
        deform.push_back(millisecondsOf([&] { mesh = scene.motionMesh(open, close); }));
        pack.push_back(millisecondsOf([&] { packMesh(mesh, scene.materials(), scene.bounds().centre()); }));
        whole.push_back(millisecondsOf([&] { planner.plan(request); }));
        triangles = mesh.topology->triangles.size();
    }
    fmt::print("{:<14} {:>8} triangles   deform {:6.2f}   pack {:6.2f}   plan, both included {:6.2f} ms\n", label,
               triangles, median(deform), median(pack), median(whole));
}

}  // namespace

int main() {
    for (const char* name : {"octopus", "chess"}) report(name, *openScene(name, ""));
    for (const char* count : {"2500", "20000"})
        report(fmt::format("cubes {}", count), *openScene("cubes", "", {{"cubes.count", count}}));
    return 0;
}
