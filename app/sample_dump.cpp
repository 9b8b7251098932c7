#include "sample_dump.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

namespace {
void appendVector(std::string& text, const glm::dvec3& v) {
    fmt::format_to(std::back_inserter(text), ",{:.9g},{:.9g},{:.9g}", v.x, v.y, v.z);
}

/// The folder, if it may be made.
std::filesystem::path unused(std::filesystem::path folder) {
    if (!folder.has_filename()) folder = folder.parent_path();  // it ends in a slash
    std::error_code failure;
    if (std::filesystem::exists(folder, failure) && !std::filesystem::is_empty(folder, failure))
        throw Error(fmt::format("--dump {}: is there already; expected a new or an empty folder", folder.string()));
    const std::filesystem::path parent = folder.parent_path();
    if (!parent.empty()) std::filesystem::create_directories(parent, failure);  // PartFolder says why it can't be
    return folder;
}

}  // namespace

SampleDump::SampleDump(const std::filesystem::path& folder, const FramePlan& plan)
    : part_(unused(folder)), samples_("px,py,k,u,id,x,y,z,tested,lit\n") {
    writeTriangles(plan);
    writeLight(plan);
}

void SampleDump::writeTriangles(const FramePlan& plan) const {
    std::string text =
        "id,x0,y0,z0,x1,y1,z1,x2,y2,z2,x0_close,y0_close,z0_close,x1_close,y1_close,z1_close,x2_close,y2_close,z2_"
        "close\n";
    const auto& triangles = plan.mesh->topology->triangles;
    for (std::size_t id = 0; id < triangles.size(); ++id) {
        fmt::format_to(std::back_inserter(text), "{}", id);
        for (std::size_t end = 0; end < 2; ++end)
            for (int corner = 0; corner < 3; ++corner)
                appendVector(text, glm::dvec3(plan.texels->vertices[2 * std::size_t{triangles[id][corner]} + end]));
        text += "\n";
    }
    writeFileAtomically(part_.path() / "triangles.csv", text);
}

void SampleDump::writeLight(const FramePlan& plan) const {
    std::string text = "x0,y0,z0,x1,y1,z1,axis_x,axis_y,axis_z,cos_half_angle,axis_x_close,axis_y_close,axis_z_close\n";
    const bool directional = plan.lightOpen.kind == LightKind::Directional;
    const glm::dvec3 open(glm::dvec4(plan.block.lightDirection)), close(glm::dvec4(plan.block.lightDirectionClose));
    std::string line, end;
    appendVector(line, directional ? open : plan.lightOpen.position - plan.origin);
    appendVector(line, directional ? close : plan.lightClose.position - plan.origin);
    appendVector(line, open);
    appendVector(end, close);
    text += line.substr(1) + fmt::format(",{:.9g}", directional ? -2.0 : std::cos(plan.lightOpen.outerConeAngle)) +
            end + "\n";
    writeFileAtomically(part_.path() / "light.csv", text);
}

void SampleDump::add(const VerifiedSample& s) {
    fmt::format_to(std::back_inserter(samples_), "{},{},{},{:.9g},{}", s.index.x, s.index.y, s.index.stratum,
                   s.truth.time, s.triangle);
    appendVector(samples_, s.truth.position);
    fmt::format_to(std::back_inserter(samples_), ",{},{:.9g}\n", s.truth.tested ? 1 : 0, s.lit);
}

void SampleDump::finish() {
    writeFileAtomically(part_.path() / "samples.csv", samples_);
    part_.renameOntoTarget();
}

}  // namespace timeshade
