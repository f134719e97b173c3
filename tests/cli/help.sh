#!/bin/sh
# Tests --help and --version.
. "$(dirname "$0")/../support/cli.sh"

# helped COMMAND OPTION...: its help describes each of the options.
helped() {
    command=$1
    shift
    limber "$command" --help
    expect_status 0
    expect_no_err
    expect_out "^limber $command "
    for option; do
        expect_out "^ +(-., )?$option( |$)"
    done
    # It has an example, and its lines fit a terminal of 100 columns.
    expect_out "^  limber .*"
    check "limber $command --help: at most 100 columns" awk \
        'length > 100 { print; bad = 1 } END { exit bad }' "$out_file"
    cp "$out_file" "$scratch/long"
    limber "$command" -h
    check "limber $command -h: the same" cmp "$scratch/long" "$out_file"
}

limber --help
expect_status 0
expect_no_err
for command in play render pose info bench compare doctor export character levels; do
    expect_out "^ *limber $command "
done
check 'limber --help: the descriptions stand in one column' awk '
    /^  limber / && match($0, / (show|write|print|time|compare the|check) /) {
        bad = bad || (column && RSTART != column)
        column = RSTART
    }
    END { exit bad || !column }' "$out_file"
cp "$out_file" "$scratch/long"
limber -h
check 'limber -h: the same' cmp "$scratch/long" "$out_file"

helped play --demo --character --clip --time --frames --size --format --gl --egl-library \
    --gles-library --display --fps --watchdog --buttons \
    --script --clock --math --kernel --verbose --help --version
limit=$(sed -n 's/^#define LOD_ERROR_PX *\([0-9.]*\)f$/\1/p' app/scene/instance/lod.h)
expect_out "--lod PX .* auto \($limit\)"
helped render --output --demo --clip --time --frames --size --format --gl --buttons \
    --script --clock --math --kernel --verbose --help --version
helped pose --output --clip --time --math --kernel --verbose --help --version
helped character --output --verbose --help --version
helped levels --output --memory --verbose --help --version
helped info --json --verbose --help --version
helped bench --kernel --runs --json --verbose --help --version
helped doctor --config --egl-library --gles-library --json --verbose --help --version
helped compare --clip --size --kernel --fps --error --ram --ms --board --jobs --format \
    --plot --export --help

limber --version
expect_status 0
expect_no_err
expect_out '^limber [0-9]+\.[0-9]+\.[0-9]+( |$)'
expect_out '^kernels .*float'
expect_out '^displays .*image'
cp "$out_file" "$scratch/version"
limber pose --version
check 'limber pose --version: the same' cmp "$scratch/version" "$out_file"

# --help takes precedence over all other options.
limber render --size 10x10 --help
expect_status 0
expect_out '^limber render '
tap_done
