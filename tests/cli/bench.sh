#!/bin/sh
# Tests what limber bench prints. The speed of this machine does not matter.
. "$(dirname "$0")/../support/cli.sh"
skinned=tests/fixtures/gltf/skin/and_morph.gltf

limber bench "$skinned" --runs 2
expect_status 0
expect_no_err
expect_out 'nanoseconds a vertex on this machine, the median of 2 runs'
for kernel in float fixed an4044; do
    expect_out "^(skin positions)? +$kernel +[0-9.]+ +[0-9.]+ "
done
check 'limber bench: every time is a positive number' \
    sh -c '! grep -Eqw "inf|nan|0\.00" "$1"' sh "$out_file"

limber bench "$skinned" --runs 1 --kernel float
expect_status 0
check 'limber bench --kernel float: measures no other kernel' \
    sh -c '! grep -Eq "fixed|an4044" "$1"' sh "$out_file"

limber bench --runs 1 --kernel float --json
expect_status 0
expect_no_err
check 'limber bench --json: every row has three sizes' node -e '
    const bench = JSON.parse(require("fs").readFileSync(process.argv[1]));
    if (bench.model !== null || bench.runs !== 1) throw Error("head");
    if (bench.results.length < 10) throw Error("rows");
    for (const {name, kernel, times} of bench.results) {
        if (times.length !== 3) throw Error(`${name}, ${kernel}`);
        for (const {vertices, warm_ns, cold_ns} of times)
            if (!(vertices > 0 && warm_ns > 0 && cold_ns > 0)) throw Error(name);
    }' "$out_file"

limber bench "$slider" --runs 1
expect_refusal 1 'nothing in it is skinned'
limber bench none.glb
expect_refusal 1 'none.glb'
for runs in '' 0 -1 one 1.5 1002; do
    limber bench --runs "$runs"
    expect_refusal 2 '--runs'
done
limber bench --kernel none
expect_refusal 2 'float'
limber bench --frames 3
expect_refusal 2 '--help'
tap_done
