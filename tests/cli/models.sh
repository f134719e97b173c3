#!/bin/sh
# Runs every command on every sample and every fixture. Each one succeeds, or
# fails with sentences on standard error; none is ended by a signal.
. "$(dirname "$0")/../support/cli.sh"
samples=${SAMPLES:-../shared}

# expect_orderly_end: exit status 0, or 1 with only sentences of limber.
expect_orderly_end() {
    if [ "$status" -eq 0 ] ||
        { [ "$status" -eq 1 ] && grep -q '^limber: ' "$err_file" &&
            ! grep -vq '^limber: ' "$err_file"; }; then
        pass "$tap_about: ends in order"
    else
        fail "$tap_about: ends in order" "$(tap_show)"
    fi
}

find "$samples/models" "$(dirname "$0")/../fixtures" \
    "$(dirname "$0")/slider.gltf" -name '*.glb' -o -name '*.gltf' -o \
    -name '*.x' 2>/dev/null | sort >"$scratch/models"
out=$scratch/out
while read -r model; do
    # In qemu-arm large models take half a minute to compare. Of those cli/compare.sh
    # compares the walker there. Texts are made from the same figures as JSON.
    compared=compare
    texts=yes
    case $limber in
    qemu-*)
        texts=
        [ "$(wc -c <"$model")" -lt 200000 ] || compared=
        ;;
    esac
    for command in ${texts:+info doctor} "info --json" "doctor --json" \
        "pose -o $out.obj" \
        "render --size 32x32 --frames 1 -o $out.png" \
        "play --size 32x32 --display null --frames 1 --clock fixed:30" \
        "play --demo crowd --size 32x32 --display null --frames 3 --clock fixed:9" \
        "play --demo duel --size 32x32 --display null --frames 3 --clock fixed:9" \
        "play --demo tuner --size 32x32 --display null --frames 3 --clock fixed:9" \
        ${compared:+"compare --size 32x32 --fps 4"} "export --c ${out}.c" \
        "bench --runs 1"; do
        # shellcheck disable=SC2086 # a command and its options
        limber $command "$model"
        expect_orderly_end
    done
done <"$scratch/models"
check 'there are models' test -s "$scratch/models"

tap_done
