"""Names of techniques outside their folders.

A technique is its folders in renderer/techniques and shaders/techniques and one line of the registry. Elsewhere no
quoted id, class or include path of one may stand, but for the one default, the tour's script and tests about that very
technique: those whose name begins with its id, and those listed here.
"""
import os
import re

import tree

FOLDER = "renderer/techniques"
CLASS = re.compile(r"^(?:class|struct) (\w+)[^;()]*\{", re.MULTILINE)
REGISTRY = "renderer/techniques/registry.cpp"
THE_DEFAULT = ("app/options/technique_options.h", '"tsm')  # the technique that is drawn where none is named

# Ids that are ordinary words too, where they mean just that.
ORDINARY = {
    "app/cases.cpp": ("exact",),  # the exact value of a case
    "renderer/measure/case_picture.cpp": ("exact",),
    "app/options/frame_options.cpp": ("intervals",),  # interval samples of the camera
    "app/options_text.cpp": ("intervals",),
    "app/report.cpp": ("intervals",),
    "renderer/measure/technique_variant.cpp": ("intervals",),
    "renderer/measure/verification_json.cpp": ("intervals",),
    "tests/cli/refusals_test.py": ("intervals",),
    "tests/verify/cutouts_test.py": ("intervals",),
    "renderer/passes/light_maps.cpp": ("static",),  # static casters
    "renderer/techniques/interleaved/interleaved_shadow.cpp": ("layers",),  # of a texture
    "renderer/techniques/tsm/tsm_shadow.cpp": ("layers",),
    "tests/parity/technique_views_test.cpp": ("static",),
}

# Tests about techniques that their names do not name. A new technique needs no entry here: tests of all techniques get
# them from the registry or from `list --json`.
ABOUT = {
    # properties of these techniques
    "tests/cli/gpu_check_test.py": ("exact", "tsm"),
    "tests/cli/reproduce_test.py": ("exact", "tsm"),
    "tests/cli/times_test.py": ("exact", "static"),
    "tests/golden/golden_test.py": ("accumulation", "exact", "history", "ranges", "static", "temporal", "tsm"),
    "tests/parity/range_lists_test.cpp": ("ranges",),
    "tests/parity/range_order_test.cpp": ("ranges",),
    "tests/parity/sample_pass_test.cpp": ("static",),
    "tests/parity/shader_variants_test.cpp": ("exact", "integral", "interleaved", "tsm"),
    "tests/parity/technique_views_test.cpp": ("ranges",),
    "tests/technique/reload_test.cpp": ("exact",),  # changes its shader
    "tests/technique/interval_samples_test.cpp": ("exact", "integral", "static"),  # solved and asked at instants
    "tests/technique/acne_test.cpp": ("interleaved", "ranges", "temporal", "tsm"),
    "tests/technique/closed_form_test.cpp": ("accumulation", "history", "interleaved", "layers", "tsm"),
    "tests/technique/history_converged_test.cpp": ("static",),
    "tests/technique/history_moving_test.cpp": ("static",),
    "tests/technique/metamorphic_test.cpp": ("accumulation", "history", "layers"),
    "tests/technique/reference_technique_test.cpp": ("tsm",),
    "tests/technique/epipolar_test.cpp": ("accumulation", "deep", "exact", "interleaved", "layers", "ranges", "static",
                                           "temporal", "tsm"),
    "tests/technique/shutter_response_test.cpp": ("accumulation", "exact"),
    "tests/technique/reload_test.cpp": ("exact",),  # changes its build shader
    "tests/cli/limits_test.py": ("exact", "ranges"),  # their lists
    "tests/window/driver_test.py": ("static", "tsm"),  # by key and by name
    "tests/technique/motion_steps_test.cpp": ("accumulation", "exact", "integral", "tsm"),
    "tests/technique/turning_light_test.cpp": ("exact",),
    "tests/technique/cutouts_test.cpp": ("exact", "integral", "intervals"),
    "tests/verify/cutouts_test.py": ("exact",),
    "tests/verify/definition_test.py": ("exact",),
    "tests/technique/two_errors_test.cpp": ("accumulation", "tsm"),
    "tests/verify/mutations_test.py": ("accumulation", "tsm"),  # breaks their shaders
    # settings and names of these techniques as examples: on the command line, in reports, in the window
    "tests/cli/equal_test.py": ("accumulation", "exact", "static", "tsm"),
    "tests/cli/journal_test.py": ("static",),
    "tests/cli/shared_folder_test.py": ("static",),
    "tests/cli/light_test.py": ("exact",),  # agrees with the oracle, whatever moves
    "tests/cli/help_test.py": ("exact", "ex"),
    "tests/technique/changed_light_test.cpp": ("exact",),
    "tests/window/light_test.py": ("exact",),
    "tests/window/partners_test.py": ("exact",),
    "tests/window/honest_test.cpp": ("accumulation", "static"),  # of each kind one, soon compiled
    "tests/cli/compare_test.py": ("exact", "static", "tsm"),
    "tests/unit/script_text_test.cpp": ("tsm",),
    "tests/cli/kill_test.py": ("static", "tsm"),
    "tests/cli/outputs_test.py": ("accumulation",),
    "tests/cli/pictures_test.py": ("accumulation", "exact", "history", "static", "tsm"),
    "tests/cli/program.py": ("accumulation", "history"),
    "tests/cli/record_test.py": ("accumulation", "exact", "history", "integral", "interleaved", "ranges", "static",
                                 "temporal", "tsm"),  # the tour
    "tests/cli/refusals_test.py": ("accumulation", "exact", "static", "tsm"),
    "tests/cli/reports_test.py": ("accumulation", "exact", "history", "static", "tsm"),
    "tests/soak/soak.cpp": ("accumulation", "static"),
    "tests/unit/chart_test.cpp": ("exact", "tsm"),
    "tests/unit/include_arrows_test.cpp": ("accumulation", "static", "tsm"),
    "tests/unit/options_text_test.cpp": ("ranges", "tsm"),
    "tests/unit/settings_test.cpp": ("accumulation", "ranges", "tsm"),
    "tests/unit/sweep_report_test.cpp": ("accumulation", "exact", "static", "tsm"),
    "tests/verify/commands_test.py": ("accumulation", "history", "static", "tsm"),
    "tests/verify/dump_test.py": ("tsm",),
    "tests/verify/readme_test.py": ("accumulation",),
    "tests/window/alive_test.py": ("static", "tsm"),
    "tests/window/desk.py": ("accumulation",),
    "tests/window/settings_test.py": ("accumulation", "exact", "static", "tsm"),
    "tests/window/techniques_test.py": ("exact", "history", "static", "tsm"),
    "tests/window/window_test.py": ("accumulation", "history", "static", "tsm"),
}


def ids(root):
    folder = os.path.join(root, FOLDER)
    return sorted(name for name in os.listdir(folder) if os.path.isdir(os.path.join(folder, name)))


def classes(root, technique):
    """Types that the headers of a technique's folder declare."""
    headers = tree.files(os.path.join(root, FOLDER, technique), ("c++",))
    return sorted({name for path in headers if path.endswith(".h")
                   for name in CLASS.findall(tree.read(root, os.path.join(FOLDER, technique, path)))})


def is_about(path, technique):
    stem = os.path.basename(path).split(".")[0]
    own = path.startswith((f"{FOLDER}/{technique}/", f"shaders/techniques/{technique}/"))
    return own or (path.startswith("tests/") and (stem.split("_")[0] == technique or technique in ABOUT.get(path, ())))


def pattern_of(technique, types):
    names = [rf"""["']{technique}(?=["'.:=,])""", f"techniques/{technique}/", *(rf"\b{name}\b" for name in types)]
    return "|".join(names)


def patterns(root):
    """(id, pattern) of all that names a technique."""
    return [(name, re.compile(pattern_of(name, classes(root, name)))) for name in ids(root)]


def without_comments(path, text):
    """Text without comments, which may give examples; strings stay."""
    if tree.kind_of(path) in ("c++", "glsl"):
        keep = re.compile(r'("(?:\\.|[^"\\\n])*")|//[^\n]*|/\*.*?\*/', re.DOTALL)
        return keep.sub(lambda match: match.group(1) or "\n" * match.group(0).count("\n"), text)
    return re.sub(r'(?m)^\s*#.*$', "", text)


def named(path, text, of_techniques):
    """(line, name) for each place of a text that names a technique which the file is not about."""
    if path == REGISTRY or path.startswith(("tests/style/", "tests/new_technique/")):
        return []
    code = without_comments(path, text)
    return [(code.count("\n", 0, match.start()) + 1, match.group(0))
            for technique, pattern in of_techniques if not is_about(path, technique)
            for match in pattern.finditer(code)
            if match.group(0).strip("\"'") not in ORDINARY.get(path, ()) and (path, match.group(0)) != THE_DEFAULT]
