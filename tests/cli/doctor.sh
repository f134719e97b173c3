#!/bin/sh
# limber doctor: a sound model has nothing, and each pitfall its sentence.
. "$(dirname "$0")/../support/cli.sh"

python3 "$(dirname "$0")/doctor_models.py" "$scratch" >"$scratch/pitfalls"
limber doctor "$scratch/sound.gltf"
expect_status 0
expect_no_err
expect_out 'nothing in it that players get wrong'
cp "$out_file" "$scratch/sound.out"

while read -r name pattern; do
    limber doctor "$scratch/$name.gltf"
    expect_out "^- .*$pattern"
    check "$name: only where it is" sh -c "! grep -q '$pattern' '$scratch/sound.out'"
done <"$scratch/pitfalls"
check 'every pitfall had its model' test "$(wc -l <"$scratch/pitfalls")" -ge 24

limber doctor "$scratch/none.glb"
expect_refusal 1 'none.glb: '
tap_done
