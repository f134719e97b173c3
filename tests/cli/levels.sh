#!/bin/sh
# Tests limber levels, and that play and render read what it writes.
. "$(dirname "$0")/../support/cli.sh"
assets=$(dirname "$0")/../../assets

cp "$assets/walker.glb" "$scratch/robot.glb"
model=$scratch/robot.glb

limber levels "$model"
expect_status 2
expect_err '^limber: levels: the model or the file to write is missing: '
limber render "$model" --size 120x160 --frames 1 --time 0.5 -o "$scratch/made.png"
expect_quiet
limber levels "$model" -o "$scratch/robot.levels"
expect_quiet
limber render "$model" --size 120x160 --frames 1 --time 0.5 -o "$scratch/read.png"
expect_quiet
check 'the picture is the same with the file' \
    cmp "$scratch/made.png" "$scratch/read.png"

cp "$assets/arm.glb" "$model"
limber render "$model" --size 120x160 --frames 1 --time 0.5 -o "$scratch/other.png"
expect_status 0
expect_err '^limber: .*robot.levels: these are not the levels of .*robot.glb: '
tap_done
