#!/bin/sh
# Tests limber export: the C source compiles without warnings, plays the same
# poses as limber, and needs as many bytes as limber prints.
. "$(dirname "$0")/../support/cli.sh"
here=$(cd "$(dirname "$0")" && pwd)
samples=${SAMPLES:-../shared}/models

# farthest A B: the largest distance of two vertices, over the largest coordinate.
farthest() {
    paste -d' ' "$1" "$2" | awk '
        { for (i = 2; i <= 4; i++) {
            d = $i - $(i + 4); d = d < 0 ? -d : d; if (d > far) far = d
            c = $i < 0 ? -$i : $i; if (c > large) large = c } }
        END { printf "%.7f\n", NR && large ? far / large : 1 }'
}

# plays MODEL CLIP TIME...: compares the exported poses with limber's.
plays() {
    model=$1
    clip=$2
    shift 2
    limber export "$model" --clip "$clip" --c "$scratch/one.c"
    expect_status 0
    expect_no_err
    rom=$(sed -n 's/.*: \([0-9]*\) bytes of tables.*/\1/p' "$out_file")
    ram=$(sed -n 's/.*, \([0-9]*\) bytes of state.*/\1/p' "$out_file")
    check "$(basename "$model"): compiles without a warning" \
        gcc -std=c99 -pedantic -Wall -Wextra -Wshadow -Werror -O1 -DP=one \
        "-DEXPORTED=\"$scratch/one.c\"" -o "$scratch/one" "$here/export_run.c" -lm
    for time in "$@"; do
        limber pose "$model" --clip "$clip" --time "$time" --math float -o "$scratch/one.obj"
        grep '^v ' "$scratch/one.obj" >"$scratch/wanted"
        "$scratch/one" "$time" >"$scratch/played"
        grep '^v ' "$scratch/played" >"$scratch/shown"
        far=$(farthest "$scratch/wanted" "$scratch/shown")
        check "$(basename "$model") at $time s: off by $far of its size" \
            sh -c "test $(wc -l <"$scratch/wanted") -eq $(wc -l <"$scratch/shown") &&
                echo $far | awk '{ exit !(\$1 < 0.00001) }'"
    done
    check "$(basename "$model"): $ram bytes of RAM" \
        grep -qx "state $ram" "$scratch/played"
    check "$(basename "$model"): compiles alone without a warning" \
        gcc -std=c99 -pedantic -Wall -Wextra -Wshadow -Werror -O0 -c \
        -o "$scratch/one.o" "$scratch/one.c"
    check "$(basename "$model"): compiles without a warning when it is optimized" \
        gcc -std=c99 -pedantic -Wall -Wextra -Wshadow -Werror -O3 -c \
        -o "$scratch/fast.o" "$scratch/one.c"
    tables=$(nm -S "$scratch/one.o" | awk '
        $3 == "r" && $4 !~ /^offset/ {
            n = 0
            for (i = 1; i <= length($2); i++)
                n = n * 16 + index("0123456789abcdef", substr($2, i, 1)) - 1
            sum += n
        } END { print sum }')
    check "$(basename "$model"): $rom bytes of ROM" test "$tables" -eq "$rom"
}

assets=$here/../../assets
limber export "$assets/walker.glb" --c "$scratch/one.c"
expect_out 'one\.c: it leaves out the model.s [1-9][0-9]* textures?$'
limber export "$slider" --c "$scratch/one.c"
check 'a model without textures loses none' sh -c "! grep textures $out_file"
expect_out 'one\.c: 1 part has no normals, so light leaves it dark: '
limber export "$here/../fixtures/gltf/material/kinds.gltf" --c "$scratch/one.c"
expect_out 'one\.c: 3 parts have no normals, so light leaves them dark: '
limber export "$assets/walker.glb" --c "$scratch/one.c"
check 'a model with normals is not dark' sh -c "! grep normals $out_file"
limber export --help
sed -n 's/^#include //p' "$scratch/one.c" >"$scratch/headers"
while read -r header; do
    check "the player's comment and the help name $header" \
        sh -c "grep -q '^ \*.*$header' $scratch/one.c && grep -q '$header' $out_file"
done <"$scratch/headers"
plays "$assets/walker.glb" walk 0 0.31 0.9
plays "$assets/face.glb" 0 0 1.7 5
plays "$slider" 0 0 0.4 9
check 'the indices of a small model take two bytes each' \
    grep -q '^typedef uint16_t one_index_t;' "$scratch/one.c"
plays "$here/../fixtures/gltf/clip/cubic.gltf" 0 0 0.3 1.2 9

# Models of a few nanometres and of the size of a planet.
for scale in 1.25e-9 1e7; do
    sed "s/\"name\": \"slider\",/&\"scale\": [$scale, $scale, $scale],/" \
        "$slider" >"$scratch/sized.gltf"
    plays "$scratch/sized.gltf" rise 0
done

# Two keys of one time are a jump.
limber export "$here/../fixtures/gltf/clip/jump.gltf" --c "$scratch/jump.c" --clip 0
expect_status 0
gcc -std=c99 -Wall -Wextra -Werror -DP=jump "-DEXPORTED=\"$scratch/jump.c\"" \
    -o "$scratch/jump" "$here/export_run.c" -lm
check 'a clip with two keys of one time holds the first until then' \
    sh -c "'$scratch/jump' 0.9999 | head -n 1 | awk '{ exit !(\$2 > 0.99 && \$2 < 1) }'"
check 'and jumps to the second' sh -c "'$scratch/jump' 1 | head -n 1 | grep -qx 'v 5 0 0'"
if [ -d "$samples" ]; then
    for name in CesiumMan.glb BoxAnimated.glb RiggedFigure.glb SimpleSkin.gltf \
        AnimatedMorphCube.glb; do
        plays "$samples/$name" 0 0.1 0.8
    done
fi

# Normals below nodes of uneven scale, with shear and mirrored.
python3 "$here/../support/uneven_normals.py" "$scratch/normals.gltf"
plays "$scratch/normals.gltf" 0 0 0.4
check 'uneven scale leaves normals at right angles to their triangles' \
    python3 "$here/../support/uneven_normals.py" --check "$scratch/played"

limber export
expect_refusal 2 'no model is given: use limber export MODEL --c FILE.c'
limber export "$slider"
expect_refusal 2 'no file to write: add --c FILE.c'
for name in 1st two-words; do
    limber export "$slider" --c "$scratch/$name.c"
    expect_refusal 1 'is not a C identifier'
    check 'no file is left' test ! -e "$scratch/$name.c"
done
limber export "$slider" --c "$scratch/none/one.c"
expect_refusal 1 'one.c: cannot be written: No such file'
tap_done
