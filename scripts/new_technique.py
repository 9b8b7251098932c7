#!/usr/bin/env python3
"""Makes the folders of a new technique and its line in the registry.

    scripts/new_technique.py NAME "Title"

NAME is the technique's name on the command line and of its folders: lower case letters, digits and underscores. What is
made is a small, correct technique, a plain shadow map of one instant, which passes all tests as it is: the place to
begin from. docs/techniques.md says what each part is for.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
REGISTRY = ROOT / "renderer" / "techniques" / "registry.def"

HEADER = '''#pragma once

#include "technique/technique.h"

namespace timeshade {

/// @TITLE@: one ordinary shadow map of everything at the centre of the shutter, and one test of it a camera sample.
/// Replace this by the idea, its source, and what it guarantees: spaces, units, errors.
class @CLASS@ final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit @CLASS@(gl::ProgramCache&) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    Footprint footprint() const override { return {}; }
    SamplingTraits samplingTraits() const override;
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    void build(const TechniqueFrame& frame) override;
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override;
    std::size_t bytes() const override { return 0; }

  private:
    float bias_{}, slopeBias_{};
    const gl::Texture* map_ = nullptr;  ///< the frame's
};

}  // namespace timeshade
'''

SOURCE = '''#include "techniques/@NAME@/@NAME@_shadow.h"

#include "technique/technique_entry.h"

namespace timeshade {

namespace {

/// The centre of the shutter, or the plan's one sample time.
float instantOf(const FramePlan& plan) {
    return plan.block.timeBase + 0.5f * static_cast<float>(plan.block.strata) * plan.block.timeScale;
}

}  // namespace

const TechniqueDescription& @CLASS@::describe() {
    static const TechniqueDescription description{
        .name = "@NAME@",
        .title = "@TITLE@",
        .shortTitle = "@TITLE@",
        .summary = "One ordinary shadow map at the centre of the shutter.",
        .source = "Williams 1978",
        .wrong = "All motion: whatever moves throws the sharp shadow of one instant.",
        .look = "octopus: the arms are blurred, their shadows are not.",
        .picture = "",
        .references = {"L. Williams 1978: Casting curved shadows on curved surfaces. SIGGRAPH."},
    };
    return description;
}

void @CLASS@::visitSettings(SettingsVisitor& visitor) {
    visitor.number("bias", bias_, 0.5, 0.0, 16.0, "texels",
                   "How much nearer to the light a caster must be before it counts.");
    visitor.number("slope_bias", slopeBias_, 1.0, 0.0, 8.0, "half texels of slope",
                   "Further bias in proportion to how steeply the surface falls away from the light.");
}

SamplingTraits @CLASS@::samplingTraits() const {
    return {.times = SamplingTraits::Times::OneInstant, .texelCentres = true, .biasTexels = static_cast<double>(bias_)};
}

std::vector<PassDecision> @CLASS@::passes(const FramePlan& plan) const {
    return {{"build", "one ordinary shadow map at u = 0.5", plan.motion.triangles},
            {"lookup", "each camera sample's surface point, taken to u = 0.5, against that map", 0}};
}

void @CLASS@::build(const TechniqueFrame& frame) { map_ = &frame.maps.atInstant(instantOf(frame.plan)); }

LookupProgram @CLASS@::lookupProgram(const TechniqueFrame& frame, Casters casters) {
    const gl::Texture& map =
        casters == Casters::Static ? frame.maps.ofStaticCasters(LightMaps::Coverage::Rasterized) : *map_;
    LookupProgram lookup{"@NAME@ lookup", "techniques/@NAME@/lookup.frag", {}, {}};
    lookup.inputs.set("instant", instantOf(frame.plan)).texture("shadowMap", map);
    return lookup;
}

TechniqueEntry @NAME@Technique() { return entryOf<@CLASS@>(); }

}  // namespace timeshade
'''

SHADER = '''// One test in an ordinary shadow map of one instant. The receiver is followed to that instant.
#include "lib/lookup.glsl"

uniform sampler2DArray shadowMap;
uniform float instant;

float litOf(MovingTriangle t, Receiver r) {
    MapPoint m = mapPointOf(pointAt(t, r.triangle, r.barycentrics, instant), instant);
    ivec2 texel = ivec2(floor(m.position * lightView.size));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(lightView.size)))) return 1.0;
    float depth = m.depth - depthBias(m, setting.bias, setting.slope_bias);
    return depth > mapDistance(texelFetch(shadowMap, ivec3(texel, 0), 0).x) ? 0.0 : 1.0;
}

#include "lib/lookup_main.glsl"
'''


def fail(message):
    print(f"new_technique: error: {message}", file=sys.stderr)
    sys.exit(1)


def write(path, text, values):
    for key, value in values.items():
        text = text.replace(f"@{key}@", value)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def main():
    if len(sys.argv) != 3:
        print(__doc__.strip(), file=sys.stderr)
        sys.exit(2)
    name, title = sys.argv[1:]
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name):
        fail(f"the name '{name}' is none; expected lower case letters, digits and underscores, a letter first")
    if not title or '"' in title or "\\" in title:
        fail(f"the title '{title}' is none; expected words without quotes and backslashes")
    line = f"TECHNIQUE({name})\n"
    folders = [ROOT / "renderer" / "techniques" / name, ROOT / "shaders" / "techniques" / name]
    if line in REGISTRY.read_text() or any(folder.exists() for folder in folders):
        fail(f"there is a technique '{name}' already")
    class_name = "".join(part.capitalize() for part in name.split("_")) + "Shadow"
    values = {"NAME": name, "TITLE": title, "CLASS": class_name}
    write(folders[0] / f"{name}_shadow.h", HEADER, values)
    write(folders[0] / f"{name}_shadow.cpp", SOURCE, values)
    write(folders[1] / "lookup.frag", SHADER, values)
    with REGISTRY.open("a") as registry:
        registry.write(line)
    print(f"renderer/techniques/{name}, shaders/techniques/{name} and a line in renderer/techniques/registry.def")


if __name__ == "__main__":
    main()
