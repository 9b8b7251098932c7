#!/usr/bin/env bash
# Draws the README's pictures. Takes some minutes on a software renderer.
set -euo pipefail

here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
run=$here/../../run
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# tsm at 8 samples per pixel beside brute force of 1,024 renders
for scene in chess octopus pillars; do
    "$run" shot "$scene" --technique tsm --spp 8 --size 640x480 -o "$work/$scene-tsm.png"
    "$run" shot "$scene" --technique accumulation --set accumulation.renders=1024 --size 640x480 \
        -o "$work/$scene-accumulation.png"
    convert "$work/$scene-tsm.png" "$work/$scene-accumulation.png" +append -quality 88 "$here/$scene.jpg"
done

# what is wrong with a picture
"$run" shot pillars --size 480x360 --map 512 --view error -o "$work/error.png"
"$run" shot pillars --size 480x360 --map 512 --view disagreement -o "$work/disagreement.png"
convert "$work/error.png" "$work/disagreement.png" +append -quality 88 "$here/wrong.jpg"

# how a history converges
"$run" measure frusta --convergence 1,5,10,20,40,60 --size 512x512 --map 512 --spp 1 --shutter 0 -o "$work/converged"
cp "$work/converged/frusta.png" "$here/history.png"
cp "$work/converged/frusta-strip.png" "$here/history-detail.png"

# the parts of filtered layers: truth, all, one layer, no choice among neighbouring tiles
above=(shot octopus --camera above --size 320x240)
layers=("${above[@]}" --technique layers --spp 4 --map 512 --set layers.as_published=on --set layers.bias=2)
"$run" "${above[@]}" --technique exact --spp 32 -o "$work/parts-0.png"
"$run" "${layers[@]}" -o "$work/parts-1.png"
"$run" "${layers[@]}" --set layers.count=1 -o "$work/parts-2.png"
"$run" "${layers[@]}" --set layers.neighbour_tiles=off -o "$work/parts-3.png"
convert "$work"/parts-?.png -crop 120x100+160+95 +repage -filter point -resize 300% +append "$here/layers-parts.png"

# Palmér's figures 4.1 to 4.4: a cube above a plane that stands still, turns, and turns less; chess without a filter in
# the first column. As published, repaired, tsm with 8 samples, ground truth.
interval=(--samples intervals --spp 1 --size 320x240 --map 512 --technique intervals)
published=(--set intervals.as_published=on)
filtered=(--set intervals.bilinear=on)
for figure in "cube" "cube --set cube.turning=on" "cube --set cube.turning=on --set cube.angle=3"; do
    read -ra scene <<<"$figure"
    "$run" shot "${scene[@]}" "${interval[@]}" "${published[@]}" "${filtered[@]}" -o "$work/figure-0.png"
    "$run" shot "${scene[@]}" "${interval[@]}" "${filtered[@]}" -o "$work/figure-1.png"
    "$run" shot "${scene[@]}" --technique tsm --spp 8 --size 320x240 --map 512 -o "$work/figure-2.png"
    "$run" shot "${scene[@]}" --technique exact --spp 32 --size 320x240 -o "$work/figure-3.png"
    convert "$work"/figure-?.png -crop 150x75+110+88 +repage -filter point -resize 200% +append \
        "$work/row-$((rows = ${rows:-0} + 1)).png"
done
chess=(chess --camera knight)
"$run" shot "${chess[@]}" "${interval[@]}" "${published[@]}" -o "$work/figure-0.png"
"$run" shot "${chess[@]}" "${interval[@]}" "${filtered[@]}" -o "$work/figure-1.png"
"$run" shot "${chess[@]}" --technique tsm --spp 8 --size 320x240 --map 512 -o "$work/figure-2.png"
"$run" shot "${chess[@]}" --technique exact --spp 32 --size 320x240 -o "$work/figure-3.png"
convert "$work"/figure-?.png -crop 150x75+60+150 +repage -filter point -resize 200% +append "$work/row-4.png"
convert "$work"/row-?.png -append -quality 88 "$here/interval-figures.jpg"

# No noise in time: integral on interval samples, 4 positions a pixel; exact with 8 and with 32 samples.
for figure in "octopus --camera above" "chess --camera knight"; do
    read -ra scene <<<"$figure"
    "$run" shot "${scene[@]}" --size 320x240 --technique integral --samples intervals --spp 4 -o "$work/noise-0.png"
    "$run" shot "${scene[@]}" --size 320x240 --technique exact --spp 8 -o "$work/noise-1.png"
    "$run" shot "${scene[@]}" --size 320x240 --technique exact --spp 32 -o "$work/noise-2.png"
    convert "$work"/noise-?.png -crop 160x90+90+105 +repage -filter point -resize 250% +append \
        "$work/noise-row-$((noise = ${noise:-0} + 1)).png"
done
convert "$work"/noise-row-?.png -append -quality 88 "$here/interval-noise.jpg"

# a newcomer's first steps in the window
TIMESHADE=$here/../../build/release/timeshade "$here/tour.py" "$here"
