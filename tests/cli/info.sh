#!/bin/sh
# Tests what limber info prints, as text and as JSON.
. "$(dirname "$0")/../support/cli.sh"

limber info "$slider"
expect_status 0
expect_no_err
expect_out 'slider\.gltf'
expect_out 'triangle'
expect_out 'slide'
expect_out 'rise'
expect_out ' 2\.0+ '

expect_out 'slider\.gltf: .*, 1 node, 3 vertices, 1 triangle, '

# Targets without names are counted, not listed.
targets=tests/fixtures/gltf/mesh/weights.gltf
limber info "$targets"
expect_status 0
check 'no list of (unnamed) targets' sh -c '! grep -q "targets: (unnamed)" "$1"' \
    sh "$out_file"

limber info "$slider" --json
expect_status 0
expect_no_err
# shellcheck disable=SC2016 # JavaScript
check 'the JSON has the clips' node -e '
    const info = JSON.parse(require("fs").readFileSync(process.argv[1]));
    const names = info.clips.map((clip) => clip.name);
    if (names.join() !== "slide,rise") { throw new Error(names.join()); }
' "$out_file"

levels=tests/fixtures/gltf/mesh/levels.gltf
limber info "$levels"
expect_status 0
expect_no_err
expect_out 'levels: 6 at 10 mm, 2 at 100 mm, 1 at 50 mm for shadows'

limber info "$levels" --json
# shellcheck disable=SC2016 # JavaScript
check 'the JSON has the levels of detail' node -e '
    const info = JSON.parse(require("fs").readFileSync(process.argv[1]));
    const told = info.meshes[0].levels.map((level) =>
        `${level.triangles} ${level.error_m.toFixed(3)} ${level.shape}`);
    if (told.join() !== "6 0.010 false,2 0.100 false,1 0.050 true") {
        throw new Error(told.join());
    }
' "$out_file"
tap_done
