#!/bin/sh
# xfile.sh SAMPLES COMMAND...: compares the poses that `limber pose` writes for
# DirectX .x files with those of assimp. SAMPLES/models/x holds the files;
# COMMAND runs limber.
. "$(dirname "$0")/../support/tap.sh"
samples=$1/models/x
shift
here=$(dirname "$0")

agrees() {
    file=$samples/$1.x
    clip=$2
    time_s=$3
    shift 3
    if [ -n "$clip" ]; then
        set -- "$@" pose "$file" --clip "$clip" --time "$time_s"
    else
        set -- "$@" pose "$file" --time "$time_s"
    fi
    name="${file##*/} at $time_s s"
    run "$@" -o "$scratch/posed.obj"
    about "$name: is posed"
    expect_status 0
    run python3 "$here/xfile_assimp.py" "$file" "$time_s" "$scratch/posed.obj"
    about "$name: agrees with assimp"
    cat "$out_file"
    expect_status 0
}

if [ ! -d "$samples" ]; then
    skip 'poses of .x files' "there is no folder $samples"
    tap_done
    exit
fi
for time_s in 0 0.1 0.5 0.77; do
    agrees anim_test 0 "$time_s" "$@"
done
for kind in text binary compressed; do
    agrees "test_cube_$kind" '' 0.5 "$@"
done
run "$@" info "$samples/malformed_skinweights_oob.x"
about 'a skin weight of a vertex that does not exist'
expect_status 1
expect_err 'malformed_skinweights_oob\.x: line [0-9]+: SkinWeights of bone "Cube" refers to vertex 1000000'
tap_done
