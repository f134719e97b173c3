#!/bin/sh
# Models that are small and valid in each number, but that would make a program
# overflow, hang or fill the memory (hostile.py writes them). Each command ends
# within seconds, with a picture or with one sentence.
. "$(dirname "$0")/../support/cli.sh"
RUN_SECONDS=${RUN_SECONDS:-60}

python3 "$(dirname "$0")/hostile.py" "$scratch"

# expect_too_large NAME: each command that poses the model refuses it by its
# need of memory.
expect_too_large() {
    for command in info "pose -o $scratch/x.obj" \
        "render --size 64x64 -o $scratch/x.png"; do
        # shellcheck disable=SC2086 # a command and its options
        limber $command "$scratch/$1"
        expect_refusal 1 'more than 256 MiB of memory: .*--memory'
    done
}

expect_too_large many-nodes.gltf
expect_too_large shared-mesh.gltf
limber compare "$scratch/shared-mesh.gltf"
expect_refusal 1 'more than 256 MiB of memory: .*--memory'
for model in many-nodes shared-mesh empty-targets; do
    limber export "$scratch/$model.gltf" --c "$scratch/x.c"
    expect_refusal 1 'too large to be C source'
done

# The limit is an option.
limber info --memory 100k "$slider"
expect_refusal 1 'more than 100 KiB of memory'
limber info --memory 1m "$slider"
expect_status 0
for wrong in 0 -1 x 1t 9g 1e99 nan; do
    limber info --memory "$wrong" "$slider"
    expect_refusal 2 '--memory .*such as'
done

tap_done
