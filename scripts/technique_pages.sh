#!/usr/bin/env bash
# Draws the pictures of the technique pages: a detail of what a technique gets wrong beside the same without the error.
# Takes a minute or two on a software renderer.
set -euo pipefail

here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
run=$here/../run
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# page NAME X Y [OPTIONS OF BOTH] -- OPTIONS OF THE LEFT -- OPTIONS OF THE RIGHT: the detail at X, Y of each
page() {
    local name=$1 x=$2 y=$3 part=0 side both=() left=() right=()
    shift 3
    for word in "$@"; do
        case $part:$word in
            *:--) part=$((part + 1)) ;;
            0:*) both+=("$word") ;;
            1:*) left+=("$word") ;;
            2:*) right+=("$word") ;;
        esac
    done
    "$run" shot "${both[@]}" --size 640x360 --spp 8 "${left[@]}" -o "$work/left.png"
    "$run" shot "${both[@]}" --size 640x360 --spp 8 "${right[@]}" -o "$work/right.png"
    for side in left right; do convert "$work/$side.png" -crop "224x176+$x+$y" +repage "$work/$side.png"; done
    convert "$work/left.png" "$work/right.png" +append -dither None -colors 96 -depth 8 -strip \
        -define png:compression-level=9 "$here/../renderer/techniques/$name/page.png"
}

page static 400 130 octopus --camera reef --frame 96 --map 512 -- --technique static -- --technique exact
page tsm 330 80 pillars --frame 11 --map 512 -- --technique tsm -- --technique exact
page deep 270 150 pillars --frame 11 --map 512 -- --technique deep -- --technique exact
page layers 390 130 octopus --camera reef --frame 96 --map 512 -- --technique tsm -- --technique layers
page interleaved 200 100 pillars --frame 11 --map 256 -- --technique interleaved -- --technique exact
page temporal 250 170 pillars --camera between --frame 12 --map 256 -- --technique temporal -- --technique exact
page intervals 270 150 pillars --frame 11 --map 512 \
    -- --technique intervals --set intervals.as_published=on --set intervals.published_bias=1 -- --technique exact
page ranges 250 170 pillars --camera between --frame 12 --map 256 -- --technique ranges -- --technique exact
page history 60 150 chess --camera knight --frame 20 --map 256 -- --technique history -- --technique exact
page exact 340 110 cubes --set cubes.count=2000 --technique exact -- --view final -- --view candidates
page accumulation 390 184 octopus --camera above --frame 90 --map 512 \
    -- --technique accumulation --set accumulation.renders=6 -- --technique exact
