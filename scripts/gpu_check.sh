#!/usr/bin/env bash
# The first check on a machine with a GPU: what it is, whether the analytic cases and the scenes come out right on it,
# and what frames take, into a folder with a one-page report.md. Needs no display and no network; with the portable
# archive nothing but an OpenGL driver. A run that was interrupted goes on where it was. Exit code 0: all steps ran and
# everything was right; 1: something was not, or there is no GPU.
set -euo pipefail

usage() {
    cat <<'END'
gpu_check.sh [OPTIONS]
  --program FILE      timeshade (default: beside this script, in a build, or on the PATH)
  -o, --output DIR    folder of the results (default: gpu_check)
  --size WxH          of pictures (default: 1280x720)
  --map N             shadow map (default: 1024)
  --rounds N          how often each point is timed (default: 5)
  --scenes A,B,...    (default: chess,octopus,pillars,cubes)
  --device N          EGL device (default: as the program chooses)
  --allow-software    a software renderer will do
  --small             all pictures 96x72, map 96, 2 rounds, cases of two techniques, times of 4 samples and two frames:
                      to try this script
END
}

program="" output=gpu_check size=1280x720 map=1024 rounds=5 scenes=chess,octopus,pillars,cubes software=no small=no
spps=4,8 sequence=8
device=()

fail() {
    printf 'gpu_check: %s\n' "$*" >&2
    exit 1
}

while (($# > 0)); do
    case $1 in
    --program) program=${2:?--program: expected a file} && shift ;;
    -o | --output) output=${2:?--output: expected a folder} && shift ;;
    --size) size=${2:?--size: expected WIDTHxHEIGHT} && shift ;;
    --map) map=${2:?--map: expected a number} && shift ;;
    --rounds) rounds=${2:?--rounds: expected a number} && shift ;;
    --scenes) scenes=${2:?--scenes: expected names} && shift ;;
    --device) device=(--device "${2:?--device: expected a number}") && shift ;;
    --allow-software) software=yes ;;
    --small) small=yes ;;
    -h | --help) usage && exit 0 ;;
    *) fail "$1: unknown; gpu_check.sh --help says what there is" ;;
    esac
    shift
done

if [[ $small == yes ]]; then
    size=96x72 map=96 rounds=2 spps=4 sequence=2
fi

if [[ -z $program ]]; then
    here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
    for candidate in "$here/timeshade" "$here/../../bin/timeshade" "$here/../build/release/timeshade"; do
        [[ -x $candidate ]] && program=$candidate && break
    done
    [[ -n $program ]] || program=$(command -v timeshade) || fail "no timeshade found; expected --program FILE"
fi
[[ -x $program ]] || fail "$program: can't be run; expected the program timeshade"
mkdir -p "$output"

# step NAME COMMAND...: runs it once; what it prints goes to NAME.txt.
failed=()
step() {
    local name=$1 begin=$SECONDS
    shift
    if [[ -f $output/$name.done ]]; then
        return
    fi
    printf 'gpu_check: %s ... ' "$name" >&2
    if "$@" >"$output/$name.txt" 2>&1 </dev/null; then
        printf '%d s\n' $((SECONDS - begin)) | tee "$output/$name.done" >&2
    else
        printf 'FAILED after %d s: %s\n' $((SECONDS - begin)) "$(tail -n 1 "$output/$name.txt")" >&2
        failed+=("$name: $(tail -n 1 "$output/$name.txt")")
    fi
}

timeshade() {
    "$program" "$@" "${device[@]}"
}

# What draws, before anything else: on a machine without a GPU this takes a second, and one line says so.
if [[ ! -f $output/first.done ]]; then
    timeshade shot crossing --technique static --size 64x48 --spp 1 -o "$output/first.png" \
        --json "$output/first.json" >"$output/first.txt" 2>&1 </dev/null ||
        fail "no picture could be drawn: $(tail -n 1 "$output/first.txt")"
    touch "$output/first.done"
fi
renderer=$(sed -n 's/^ *"renderer": "\(.*\)",*$/\1/p' "$output/first.json")
version=$(sed -n 's/^ *"version": "\(.*\)",*$/\1/p' "$output/first.json" | tail -n 1)
if grep -q '"software": true' "$output/first.json" && [[ $software == no ]]; then
    rm -f "$output/first.done"
    fail "OpenGL is drawn by a software renderer ($renderer); expected a GPU, or --allow-software"
fi
step devices timeshade list --devices

in_cases=()
[[ $small == yes ]] && in_cases=(--techniques tsm,exact)
step cases timeshade cases --gl-debug "${in_cases[@]}"

techniques=$("$program" list --json | sed -n '/"techniques"/,$ s/^      "name": "\([a-z]*\)",$/\1/p')
IFS=, read -ra names <<<"$scenes"
for scene in "${names[@]}"; do
    for technique in $techniques; do
        # Against the ray tracer, sample by sample. Only `exact` promises a bound.
        bound=()
        [[ $technique == exact ]] && bound=(--max-ppm 10)
        step "verify-$scene-$technique" timeshade verify "$scene" --technique "$technique" --size "$size" --spp 4 \
            --map "$map" --reference-rays 0 --set accumulation.renders=16 --gl-debug "${bound[@]}"
    done
done

step times timeshade measure "${names[@]}" --times --size "$size" --map "$map" --maps "$map" --spps "$spps" \
    --rounds "$rounds" --sequence "$sequence" -o "$output/times"

# Beside what papers report of their machines: NAME PICTURE MAP, scenes, and further arguments.
as_in_paper() {
    local name=$1 picture=$2 map_size=$3
    shift 3
    [[ $small == no ]] || picture=96x72 map_size=96
    step "$name" timeshade measure "$@" --times --size "$picture" --maps "$map_size" --rounds "$rounds" \
        -o "$output/$name"
}
as_in_paper layers 1280x720 1024 octopus --spps 4,8 --techniques layers,layers:as_published=on,tsm
as_in_paper history 1024x1024 1024 frusta --spps 1 --shutter 0 --sequence 16 --techniques static,history
as_in_paper temporal 1024x768 1024x768 rising cubes --set cubes.count=4000 --spps 8 \
    --techniques temporal,temporal:as_published=on,tsm
as_in_paper ranges 1024x768 1024x768 rising --spps 8,20 --techniques ranges,ranges:as_published=on,temporal,tsm

# table_of NAME: steady whole frames, a row a technique, a column a scene and number of samples.
table_of() {
    if [[ ! -f $output/$1/times.csv ]]; then
        printf 'not measured\n\n'
        return
    fi
    awk -F, '
        $5 == "steady" && $6 == "wall" {
            column = $1 ", " $3
            if (!(column in seen_column)) { seen_column[column] = 1; columns[++width] = column }
            if (!($2 in seen_row)) { seen_row[$2] = 1; rows[++height] = $2 }
            value[$2, column] = sprintf("%.2f", $8)
        }
        END {
            line = "| |"; rule = "| --- |"
            for (c = 1; c <= width; ++c) { line = line " " columns[c] " |"; rule = rule " --: |" }
            print line; print rule
            for (r = 1; r <= height; ++r) {
                line = "| " rows[r] " |"
                for (c = 1; c <= width; ++c) line = line " " value[rows[r], columns[c]] " |"
                print line
            }
        }' "$output/$1/times.csv"
    printf '\nAll states and steps: [%s/times.md](%s/times.md)\n\n' "$1" "$1"
}

{
    printf '# %s\n\nOpenGL %s. ' "$renderer" "$version"
    "$program" --version | head -n 1
    printf '\nPictures %s, shadow map %s, %s rounds. ' "$size" "$map" "$rounds"
    printf 'Times are of whole frames of a sequence, once caches are filled: '
    printf 'medians in milliseconds, by scene and samples per pixel.\n\n'
    echo "## Right or wrong"
    echo
    if [[ -f $output/cases.done ]]; then
        printf -- '- analytic cases: %s\n' "$(tail -n 1 "$output/cases.txt")"
    fi
    if ((${#failed[@]} == 0)); then
        echo "- every step ran"
    else
        printf -- '- FAILED: %s\n' "${failed[@]}"
    fi
    echo
    echo "Samples in a million that disagree with the ray tracer, or the footprint error where values are averages:"
    echo
    printf '| |'
    printf ' %s |' "${names[@]}"
    printf '\n| --- |'
    printf ' --: |%.0s' "${names[@]}"
    echo
    for technique in $techniques; do
        printf '| %s |' "$technique"
        for scene in "${names[@]}"; do
            file=$output/verify-$scene-$technique.txt
            value=$(sed -n 's/^ *disagree .*(\(.* ppm\)).*$/\1/p' "$file" 2>/dev/null)
            [[ -n $value ]] || value=$(sed -n 's/^ *footprint error *\([0-9.]*\) RMS.*$/RMS \1/p' "$file" 2>/dev/null)
            printf ' %s |' "${value:-failed}"
        done
        echo
    done
    echo
    echo "## What frames take"
    echo
    table_of times
    echo "## Filtered layers beside one sample a texel (Andersson et al. 2015: 36 and 30 ms on a GTX 980)"
    echo
    table_of layers
    echo "## A history beside an ordinary map (Scherzer et al. 2007: 1.5 of 15 ms on an 8800 GTX)"
    echo
    table_of history
    echo "## Temporal shadow maps (Hong and Oh 2017, their map and picture, on a GTX 980 Ti)"
    echo
    table_of temporal
    echo "## Depth-time ranges (Hong and Oh 2019, their map and picture, on a GTX 980 Ti)"
    echo
    table_of ranges
} >"$output/report.md"
printf '%s\n' "$output/report.md"
((${#failed[@]} == 0))
