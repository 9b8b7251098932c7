#!/usr/bin/env bash
# Builds the fuzz targets and runs each for some seconds, under AddressSanitizer and UndefinedBehaviorSanitizer.
#
#   tests/fuzz/run.sh                    every target, ten seconds each
#   tests/fuzz/run.sh 3600 model image   these, an hour each
#
# A run begins with corpus/TARGET and with what earlier runs found, in build/fuzz/found/TARGET. The first input that
# ends a target lies in build/fuzz/failures; `build/fuzz/tests/fuzz/fuzz_TARGET FILE` reads it again.
set -euo pipefail

folder=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
root=$(dirname -- "$(dirname -- "$folder")")
seconds=${1:-10}
shift || true
targets=("$@")
if ((${#targets[@]} == 0)); then
    targets=(model image settings script journal)
fi

cd "$root"
build=$root/build/fuzz
mkdir -p "$build/seeds/model" "$build/failures"
for step in "cmake --preset fuzz" "cmake --build --preset fuzz"; do
    if ! $step >"$build/build.log" 2>&1; then
        tail -n 60 "$build/build.log" >&2
        exit 1
    fi
done
"$build/tests/fuzz/fuzz_seeds" "$build/seeds/model"

for target in "${targets[@]}"; do
    seeds=$folder/corpus/$target
    if [[ $target == model ]]; then
        seeds=$build/seeds/model
    fi
    options=(-max_total_time="$seconds" -seed=1 -timeout=20 -rss_limit_mb=2048 -print_final_stats=1)
    if [[ -f $folder/$target.dict ]]; then
        options+=(-dict="$folder/$target.dict")
    fi
    mkdir -p "$build/found/$target"
    printf 'fuzz %s: %s seconds\n' "$target" "$seconds"
    if ! "$build/tests/fuzz/fuzz_$target" "${options[@]}" -artifact_prefix="$build/failures/$target-" \
        "$build/found/$target" "$seeds" >"$build/$target.log" 2>&1; then
        tail -n 60 "$build/$target.log" >&2
        exit 1
    fi
    grep -E 'stat::(number_of_executed_units|peak_rss_mb)' "$build/$target.log"
done
