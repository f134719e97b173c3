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
    awk '/ (fixed|float|an4044) / && !($(NF - 2) > 0 && $(NF - 1) > 0) { exit 1 }' "$out_file"

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

# filters PID: how many filters of system calls the kernel applies to a process.
filters() {
    awk '/^Seccomp_filters:/ { print $2 }' "/proc/$1/status" 2>/dev/null
}

# seen_confined COMMAND...: while it runs it has a filter that this shell lacks.
seen_confined() {
    "$@" >"$scratch/confined.out" 2>&1 &
    confined=$!
    for _ in 1 2 3 4 5 6 7 8 9 10; do
        sleep 0.2
        seen=$(filters "$confined")
        [ "${seen:-0}" -gt "$(filters $$)" ] && break
    done
    kill "$confined" 2>/dev/null
    wait "$confined" 2>/dev/null
    [ "${seen:-0}" -gt "$(filters $$)" ]
}
case $limber,$(filters $$) in
*qemu-arm*) skip 'limber bench MODEL: confined' 'qemu-arm filters no calls' ;;
*,) skip 'limber bench MODEL: confined' 'this kernel does not count filters' ;;
*)
    check 'limber bench MODEL: confined while it works on the model' \
        seen_confined "$limber" bench "$skinned" --runs 1001
    ;;
esac

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
