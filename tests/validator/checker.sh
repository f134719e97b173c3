#!/bin/sh
# Tests validate.js with valid, invalid and missing files.
. "$(dirname "$0")/../support/tap.sh"
script=$(dirname "$0")/validate.js

cat >"$scratch/good.gltf" <<'END'
{"asset": {"version": "2.0"}, "nodes": [{"name": "one"}],
 "scenes": [{"nodes": [0]}], "scene": 0}
END
cat >"$scratch/bad.gltf" <<'END'
{"asset": {"version": "2.0"}, "nodes": [{"mesh": 7}],
 "scenes": [{"nodes": [0]}], "scene": 0}
END

run node "$script" "$scratch/good.gltf"
expect_status 0
expect_out '^ok 1 - .*good.gltf'
run node "$script" "$scratch/bad.gltf" "$scratch/good.gltf" "$scratch/none.gltf"
expect_status 1
expect_out '^not ok 1 - .*bad.gltf'
expect_out '# error: UNRESOLVED_REFERENCE /nodes/0/mesh'
expect_out '^ok 2 - .*good.gltf'
expect_out '^not ok 3 - .*none.gltf'
expect_out '^1..3$'
tap_done
