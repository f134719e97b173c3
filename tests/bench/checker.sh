#!/bin/sh
# Shows that the check of recorded figures (arm11.py --check) can fail.
#
#   checker.sh FIGURES
set -u
folder=$(dirname "$0")
. "$folder/../support/tap.sh"
figures=$1

# check_against FILE OPTIONS...: compares with the figures of that file.
check_against() {
    file=$1
    shift
    run "$folder/arm11.py" --short --check "$file" "$@"
    about "${file##*/} $*"
}

# failures: prints the figures that failed in the last run.
failures() {
    sed -n 's/^not ok [0-9]* - \([^:]*\):.*/\1/p; s/^not ok [0-9]* - \(.* is recorded\),.*/\1/p' \
        "$out_file" | tr '\n' ',' | sed 's/,$//'
}

# expect_failures NAME LIST: the last run failed in just these figures.
expect_failures() {
    if [ "$status" -ne 0 ] && [ "$(failures)" = "$2" ]; then
        pass "$1"
    else
        fail "$1" "failed: $(failures)"
    fi
}

check_against "$figures" --rows lerp,targets-2 --kernel fixed,float
expect_status 0
expect_no_err

awk '$1 == "lerp" && $2 == "fixed" && $3 == "warm" { $4 = $4 / 1.07 } { print }' \
    "$figures" >"$scratch/faster"
check_against "$scratch/faster" --rows lerp --kernel fixed
expect_failures 'a loop that got 7% slower is noticed' 'lerp fixed warm'

awk '$1 == "lerp" && $2 == "fixed" && $3 == "warm" { $4 = $4 * 1.3 } { print }' \
    "$figures" >"$scratch/slower"
check_against "$scratch/slower" --rows lerp --kernel fixed
expect_failures 'a loop that takes far less than before is noticed' \
    'lerp fixed warm'

awk '$1 == "lerp" && $2 == "fixed" && $3 == "warm" { $4 = $4 / 1.03 } { print }' \
    "$figures" >"$scratch/near"
check_against "$scratch/near" --rows lerp --kernel fixed
expect_status 0

check_against "$figures" --rows skin-1 --kernel an4044 --model-options ddr=110
expect_failures 'slower memory is noticed where memory is used' \
    'skin-1 an4044 cold'

grep -v '^lerp float' "$figures" >"$scratch/fewer"
check_against "$scratch/fewer" --rows lerp --kernel float
expect_failures 'a figure that was never recorded is noticed' \
    'lerp float warm,lerp float cold,lerp float instructions'

echo 'lerp float hot 1' | cat "$figures" - >"$scratch/more"
check_against "$scratch/more" --rows lerp --kernel float
expect_failures 'a figure that is measured no more is noticed' \
    'lerp float hot is recorded'

# A figure that once was within its limit must stay there, whatever the 5%: here the
# limit is 1% below today's figure, and the recorded one 2% below.
awk '$1 == "pose-walker-walk" && $3 == "instructions" { $4 = $4 * 0.98 } { print }' \
    "$figures" >"$scratch/reached"
limit=$(awk '$1 == "pose-walker-walk" && $3 == "instructions" { print $4 * 0.99 }' \
    "$figures")
cp "$folder"/arm11*.py "$scratch"
sed -i "s/\"instructions\": 250/\"instructions\": $limit/" "$scratch/arm11_rows.py"
run "$scratch/arm11.py" --short --check "$scratch/reached" --rows pose-walker-walk
about 'a limit'
expect_failures 'a limit that was reached and is missed is noticed' \
    'pose-walker-walk pose instructions'

run "$folder/arm11.py" --short --check "$figures" --rows cesium --samples "$scratch"
about 'without samples'
expect_status 0
expect_out '^ok 1 - cesium # SKIP no '

echo 'all figures' >"$scratch/kept"
run "$folder/arm11.py" --short --record "$scratch/kept" --samples "$scratch"
about 'recording without samples'
expect_status 1
expect_err "kept stays as it was, as there is no $scratch/models/"
run "$folder/arm11.py" --short --record "$scratch/kept" --rows lerp
about 'recording a part'
expect_status 1
expect_err 'leave out --rows'
if [ "$(cat "$scratch/kept")" = 'all figures' ]; then
    pass 'a refused recording changes no file'
else
    fail 'a refused recording changes no file' "$(head -3 "$scratch/kept")"
fi

run "$folder/arm11.py" --short --check "$figures" --rows lerp --model "$scratch/none.so"
about 'without a model'
expect_status 1

sed -i 's/\bprepare\b//' "$scratch/arm11_frame.py"
run "$scratch/arm11.py" --short --rows gl-walker
about 'a file of the driver without a stage'
expect_status 1
expect_err 'STAGES in tests/bench/arm11_frame.py lacks platform/gl/soft/vertex/prepare.c'
tap_done
