#!/bin/sh
# Models that are small and valid in each number, but that would make a program
# overflow, hang or fill the memory (hostile.py writes them). Each command ends
# within seconds, with a picture or with one sentence. And what each signal does.
. "$(dirname "$0")/../support/cli.sh"
RUN_SECONDS=${RUN_SECONDS:-60}

python3 "$(dirname "$0")/hostile.py" "$scratch"

# In qemu-arm it takes up to half a minute until a model is refused, by the same lines
# for each command. One command shows there that the sizes are right.
case $limber in
qemu-*) emulated=true ;;
*) emulated=false ;;
esac

# expect_too_large NAME: each command that poses the model refuses it by its
# need of memory.
expect_too_large() {
    set -- "$1" info "pose -o $scratch/x.obj" "render --size 64x64 -o $scratch/x.png"
    ! $emulated || set -- "$1" info
    too_large=$1
    shift
    for command in "$@"; do
        # shellcheck disable=SC2086 # a command and its options
        limber $command "$scratch/$too_large"
        expect_refusal 1 'more than 256 MiB of memory: .*--memory'
    done
}

expect_too_large many-nodes.gltf
expect_too_large shared-mesh.gltf
models=empty-targets
if ! $emulated; then
    limber compare "$scratch/shared-mesh.gltf"
    expect_refusal 1 'more than 256 MiB of memory: .*--memory'
    models="many-nodes shared-mesh $models"
fi
for model in $models; do
    limber export "$scratch/$model.gltf" --c "$scratch/x.c"
    expect_refusal 1 'too large to be C source'
done

# Whatever does not fit into the limit of memory, limber names the limit.
kib=16
while ! $emulated && [ $kib -lt 400 ]; do
    for words in '--show keys,weights' '--demo crowd' '--demo duel' '--demo tuner'; do
        # shellcheck disable=SC2086 # options and their values
        limber render $words --frames 1 --size 32x32 --memory ${kib}k \
            -o "$scratch/x.png" tests/fixtures/gltf/skin/and_morph.gltf
        if [ "$status" -ne 0 ]; then
            expect_refusal 1 "more than $kib KiB of memory: .*--memory"
        fi
    done
    kib=$((kib + 8))
done

# Numbers are finite and of a sane size; what nodes make of them may not be.
limber info "$scratch/far-apart.gltf"
expect_refusal 1 'nodes/0/translation/0: is larger than 1e9'
for model in nested-scales edge; do
    limber info "$scratch/$model.gltf"
    expect_status 0
    for command in "render --size 64x64 -o $scratch/x.png" \
        "play --display null --frames 2"; do
        # shellcheck disable=SC2086 # a command and its options
        limber $command "$scratch/$model.gltf"
        expect_status 0
    done
done

# A model without a node has no joint to show.
for words in '' '--demo crowd' '--demo tuner'; do
    # shellcheck disable=SC2086 # an option and its value
    limber play $words --display null --frames 2 \
        --show skeleton,weights,wireframe,keys,pivots,curve,layers \
        "$scratch/nothing.gltf"
    expect_status 0
done

# The time that a file takes grows with its size, not with the square.
RUN_SECONDS=10 limber info "$scratch/repeated-levels.gltf"
expect_refusal 1 'has 20000 numbers instead of 3'

RUN_SECONDS=30 limber play --display null --frames 2 "$scratch/many-floors.gltf"
expect_status 0

RUN_SECONDS=10 limber levels -o "$scratch/x.levels" "$scratch/colliding-cells.gltf"
expect_status 0

RUN_SECONDS=30 limber character "$scratch/long-chain.gltf"
expect_out ';bones = joint11999 16'

# Keys of a long clip are searched at a part of its moments; what is found holds at
# all of them. The search misses the jerk and comes back for it.
if ! $emulated; then
    RUN_SECONDS=120 limber optimize -o "$scratch/x.glb" "$scratch/long-clip.gltf"
    expect_status 0
    expect_out '^5 of 1800 keys are left. No vertex moves by more than 0\.0'
fi

# A model's own character reaches the clips that a character may hold.
RUN_SECONDS=30 limber play --display null --frames 2 \
    --clip 2500 "$scratch/many-clips.gltf"
expect_status 0
expect_err 'buttons reach 1000 of the 3000 clips'

# Files that never end, and that hold no text.
for option in --config --script; do
    limber play --demo arm --display null --frames 2 $option /dev/zero
    expect_refusal 1 '/dev/zero'
done

# Named pipes that no program writes to: nothing waits for one.
mkfifo "$scratch/pipe" "$scratch/arm.character"
cp assets/arm.glb "$scratch"
for option in --config --script --character --failsafe '--buttons script:'; do
    case $option in
    *:) set -- "$option$scratch/pipe" ;;
    *) set -- "$option $scratch/pipe" ;;
    esac
    # shellcheck disable=SC2086 # an option and its value
    RUN_SECONDS=10 limber play --demo arm --display null --frames 2 ${1}
    case $option in
    --failsafe) expect_status 0 ;;
    *) expect_refusal 1 "$scratch/pipe: cannot be read" ;;
    esac
done
RUN_SECONDS=10 limber play --demo arm --display null --frames 2 \
    --watchdog "$scratch/pipe"
expect_status 0
RUN_SECONDS=10 limber play "$scratch/arm.glb" --display null --frames 2
expect_refusal 1 'arm.character: cannot be read'

# A signal ends whatever limber does within a second, and disables the watchdog.
: >"$scratch/watchdog"
# shellcheck disable=SC2086 # a command and its arguments
$limber play --demo walker --time 86400 --display null --no-labels \
    --watchdog "$scratch/watchdog" >"$out_file" 2>"$err_file" &
child=$!
sleep 1
kill -TERM $child
began=$(date +%s)
wait $child
took=$(($(date +%s) - began))
check 'SIGTERM ends a long preparation within a second' test $took -le 2
check 'the watchdog is disabled then' \
    test "$(tail -c 1 "$scratch/watchdog")" = V

# A model that is still loaded ends limber in order as well.
# shellcheck disable=SC2086 # a command and its arguments
$limber play "$scratch/large-images.gltf" --display null --frames 1 \
    >"$out_file" 2>"$err_file" &
child=$!
if $emulated; then
    sleep 2
else
    # Until limber, no longer the shell, catches SIGTERM, which is bit 14. A mutant's
    # program has another name (tests/mutants).
    n=0
    until awk -v name="$(basename "$limber" | cut -c1-15)" '
            /^Name:/ { runs = $2 == name }
            runs && /^SigCgt:.*[4-7c-f]...$/ { catches = 1 }
            END { exit !catches }' /proc/$child/status || [ $n = 500 ]; do
        sleep 0.02
        n=$((n + 1))
    done
fi
kill -TERM $child
wait $child
status=$?
tap_about='limber play that SIGTERM ends while it decodes images'
expect_status 0
expect_no_err

# So does one of which the duel fits key frames, which takes seconds.
if ! $emulated; then
    for seconds in 1 2; do
        # shellcheck disable=SC2086 # a command and its arguments
        $limber play --demo duel "$scratch/heavy.gltf" --display null --frames 1 \
            >"$out_file" 2>"$err_file" &
        child=$!
        sleep $seconds
        kill -TERM $child
        wait $child
        status=$?
        tap_about="limber play that SIGTERM ends ${seconds} s after its start"
        expect_status 0
        expect_no_err
    done
fi

# Nothing is left of a file whose content is still computed.
if ! $emulated; then
    # shellcheck disable=SC2086 # a command and its arguments
    $limber optimize -o "$scratch/stopped.glb" "$scratch/long-clip.gltf" \
        >"$out_file" 2>"$err_file" &
    child=$!
    sleep 0.5
    kill -TERM $child
    wait $child
    check 'SIGTERM leaves no temporary file of optimize' \
        sh -c "! ls '$scratch' | grep stopped"
fi

# So does a reader of standard output that goes away.
: >"$scratch/watchdog"
# shellcheck disable=SC2086 # a command and its arguments
$limber play --demo walker --display null --watchdog "$scratch/watchdog" \
    >"$out_file" 2>"$err_file" &
child=$!
sleep 1
kill -PIPE $child
wait $child
check 'SIGPIPE leaves the watchdog disabled' \
    test "$(tail -c 1 "$scratch/watchdog")" = V

# end_by SIGNAL [OPTION...]: a signal ends limber play while it shows pictures. A
# shell lets what it starts with "&" ignore some signals, which env undoes.
end_by() {
    signal=$1
    shift
    run sh -c 'ulimit -c 0
        env --default-signal "$@" & pid=$!; n=0
        until [ -s "$0" ] || [ $n = 1000 ]; do sleep 0.02; n=$((n + 1)); done
        kill -'"$signal"' $pid; wait $pid' "$out_file" \
        $limber play --demo arm --size 64x64 --display null "$@"
    about "limber play that SIG$signal ends"
}

for name in INT TERM HUP; do
    end_by $name
    expect_status 0
    expect_no_err
done

end_by PIPE
expect_status 1
expect_err 'play: ended early: .*SIGPIPE'
expect_err_lines 1

end_by XCPU
expect_status 1
expect_err 'play: ended early: .*SIGXCPU.*ulimit -St'
expect_err_lines 1

for ending in QUIT:131 ALRM:142 USR1:138; do
    end_by ${ending%:*}
    expect_status ${ending#*:}
done

# What is recorded is complete in any case.
end_by XCPU --record-buttons "$scratch/run.txt" --record "$scratch/film.gif"
expect_status 1
check 'the film of an early end is complete' \
    sh -c 'tail -c 1 "$1" | od -An -tx1 | grep -q 3b' sh "$scratch/film.gif"
check 'the buttons of an early end are kept' test -e "$scratch/run.txt"

# A limit of files is an error of writing.
end_by XFSZ --frames 20
expect_status 0
run sh -c 'ulimit -f 8; "$@"' sh $limber play --demo arm --size 320x240 \
    --display null --frames 40 --clock fixed:25 --record "$scratch/long.gif"
about 'limber play at the limit of files'
expect_status 1
expect_err 'long.gif: .*too large'

# One picture under many names, and a warning for each of many references.
expect_too_large many-names.x
limber info "$scratch/many-textures.gltf"
expect_status 0
limber render --size 64x64 --frames 1 -o "$scratch/x.png" \
    "$scratch/many-textures.gltf"
expect_refusal 1 'more than 256 MiB of memory: .*--memory'
limber pose -o "$scratch/x.obj" "$scratch/many-warnings.x"
expect_status 0
expect_err_lines 9
expect_err '99992 more warnings'

# Large pictures take the memory of textures. The limit bounds the time, too.
if ! $emulated; then
    limber render --size 64x64 --frames 1 -o "$scratch/x.png" \
        "$scratch/large-images.gltf"
    expect_status 0
    expect_err 'images have 201 million pixels, .* uses 12 million: .* 40 s'
    expect_too_large too-large-images.gltf
fi

# Names reach neither a terminal nor a compiler as they are.
for command in info "info --json" doctor "doctor --json" compare \
    "compare --format json" "export --c $scratch/names.c"; do
    # shellcheck disable=SC2086 # a command and its options
    limber $command "$scratch/names.gltf"
    expect_status 0
    check "$tap_about: prints no control characters" \
        sh -c '! LC_ALL=C grep -aq "$(printf "[\001-\010\013-\037\177]\|\302[\200-\237]\|\342\200\256")" "$@"' \
        sh "$out_file" "$err_file"
done
check 'the end of a comment in a name does not end the comment' \
    sh -c "! grep -q '\*/ int evil' '$scratch/names.c'"

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
