#!/usr/bin/env bash
# Draws the pictures of the README again: tsm at 8 samples per pixel beside brute force of 1,024 renders. Takes some
# minutes on a software renderer.
set -euo pipefail

here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for scene in chess octopus pillars; do
    "$here/../../run" shot "$scene" --technique tsm --spp 8 --size 640x480 -o "$work/$scene-tsm.png"
    "$here/../../run" shot "$scene" --technique accumulation --set accumulation.renders=1024 --size 640x480 -o "$work/$scene-accumulation.png"
    convert "$work/$scene-tsm.png" "$work/$scene-accumulation.png" +append -quality 88 "$here/$scene.jpg"
done
