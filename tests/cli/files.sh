#!/bin/sh
# Tests files that are missing, cannot be read, contain no model or cannot be
# written: limber exits with 1, after one sentence with the name and the reason.
. "$(dirname "$0")/../support/cli.sh"

out=$scratch/out

# refused PATTERN FILE: every command that reads a model refuses it.
refused() {
    limber info "$2"
    expect_refusal 1 "$1"
    limber pose "$2" -o "$out.obj"
    expect_refusal 1 "$1"
    limber render "$2" -o "$out.png"
    expect_refusal 1 "$1"
    limber play "$2" --display null --frames 1
    expect_status 1
    expect_err "^limber: .*$1"
}

refused 'none\.glb: .*[Nn]o such file' "$scratch/none.glb"
limber "$scratch/none.glb" --display null
expect_status 1
expect_err 'none\.glb: '
# limber reports a missing model before it looks for a display.
limber play "$scratch/none.glb" --display kms:/dev/none
expect_status 1
expect_err '^limber: .*none\.glb: No such file'

mkdir "$scratch/folder.glb"
refused 'folder\.glb: .*this is a folder' "$scratch/folder.glb"

: >"$scratch/empty.glb"
refused 'empty\.glb: .*empty' "$scratch/empty.glb"

echo 'no model at all' >"$scratch/text.gltf"
refused 'text\.gltf: ' "$scratch/text.gltf"

head -c 700 "$slider" >"$scratch/half.gltf"
refused 'half\.gltf: ' "$scratch/half.gltf"

printf 'glTF\002\000\000\000\377\377\377\177' >"$scratch/head.glb"
refused 'head\.glb: ' "$scratch/head.glb"

cp "$slider" "$scratch/locked.gltf"
chmod 0 "$scratch/locked.gltf"
if [ -r "$scratch/locked.gltf" ]; then
    skip 'a file that may not be read' 'this user reads everything'
else
    refused 'locked\.gltf: .*[Pp]ermission' "$scratch/locked.gltf"
fi

limber pose "$slider" --clip dance -o "$out.obj"
expect_refusal 1 'dance'
limber render "$slider" --clip 7 -o "$out.png"
expect_refusal 1 '7'

# No file is written that the command reads, or that it writes twice.
cp "$slider" "$scratch/kept.gltf"
echo '0 UP down' >"$scratch/kept.txt"
: >"$scratch/kept.character"
ln -s kept.gltf "$scratch/link"
for wrong in "pose $scratch/kept.gltf -o $scratch/../${scratch##*/}/kept.gltf" \
    "export $scratch/kept.gltf --c $scratch/link" \
    "character $scratch/link -o $scratch/kept.gltf" \
    "levels $scratch/kept.gltf -o $scratch/link" \
    "play $scratch/kept.gltf --stats $scratch/link" \
    "play $scratch/kept.gltf --watchdog $scratch/kept.gltf" \
    "play --script $scratch/kept.txt --record-buttons $scratch/kept.txt" \
    "render --demo arm -o $scratch/new.png --stats $scratch/./new.png" \
    "play --demo arm --record $scratch/new.gif --stats $scratch/new.gif"; do
    # shellcheck disable=SC2086 # a command and its options
    limber $wrong
    expect_refusal 2 'names the same file'
done
ln -s new.json "$scratch/to-new.json"
limber play --demo arm --display null --frames 2 --record-buttons \
    "$scratch/new.json" --stats "$scratch/to-new.json"
expect_refusal 2 'names the same file'
check 'the files are as they were' cmp "$slider" "$scratch/kept.gltf"
check 'no other is written' sh -c "! ls $scratch/new*"
limber play --demo arm --display null --frames 2 --stats /dev/null \
    --record-buttons /dev/null
expect_status 0
limber optimize "$scratch/kept.gltf" -o "$scratch/same.glb"
cp "$scratch/same.glb" "$scratch/kept.glb"
limber optimize "$scratch/same.glb" -o "$scratch/same.glb"
expect_refusal 2 'names the same file'
mkdir "$scratch/baked"
cp "$scratch/same.glb" "$scratch/baked/skin-2.glb"
limber compare "$scratch/baked/skin-2.glb" --export "$scratch/baked/../baked"
expect_refusal 2 'skin-2\.glb would be overwritten: give another folder'
check 'a model is not written over by optimize' \
    cmp "$scratch/same.glb" "$scratch/kept.glb"
check 'a model is not written over by compare' \
    cmp "$scratch/baked/skin-2.glb" "$scratch/kept.glb"
mv "$scratch/baked/skin-2.glb" "$scratch/baked/own.glb"
limber compare "$scratch/baked/own.glb" --size 48x64 --export "$scratch/baked"
expect_status 0
# A file that the command only writes is replaced.
limber optimize "$scratch/kept.gltf" -o "$scratch/same.glb"
expect_status 0
check 'a file is written again' cmp "$scratch/same.glb" "$scratch/kept.glb"

# Nor is a file that the model, a demo or another option names: by its own path,
# by links, or as one of several pictures.
cat >"$scratch/outer.py" <<'END'
"""outer.py MODEL: writes outer/own.gltf with its buffer in the file film.gif."""
import base64, json, os, sys
model = json.load(open(sys.argv[1], encoding="utf-8"))
raw = base64.b64decode(model["buffers"][0]["uri"].split(",")[1])
model["buffers"][0]["uri"] = "film.gif"
folder = os.path.dirname(os.path.abspath(sys.argv[0])) + "/outer"
os.mkdir(folder)
open(folder + "/film.gif", "wb").write(raw)
json.dump(model, open(folder + "/own.gltf", "w", encoding="utf-8"))
END
python3 "$scratch/outer.py" "$slider"
outer=$scratch/outer
cp "$outer/film.gif" "$scratch/film.kept"
for ending in png obj c glb y4m svg levels character; do
    ln "$outer/film.gif" "$outer/hard.$ending"
done
ln "$outer/film.gif" "$outer/still-0002.png"
ln -s film.gif "$outer/soft.glb"
mkdir "$outer/baked"
ln "$outer/film.gif" "$outer/baked/morph.glb"
echo '[character]' >"$outer/own.character"
cp "$outer/own.character" "$scratch/character.kept"
for wrong in "render -o $outer/film.gif" "render -o $outer/../outer/film.gif" \
    "render -o $outer/hard.png" "render --frames 9 -o $outer/still.png" \
    "render -o $outer/hard.y4m" "pose -o $outer/hard.obj" \
    "export --c $outer/hard.c" "optimize -o $outer/hard.glb" \
    "optimize -o $outer/soft.glb" "levels -o $outer/hard.levels" \
    "compare --plot $outer/hard.svg" \
    "play --display null --frames 2 --record $outer/film.gif" \
    "play --display null --frames 2 --stats $outer/film.gif" \
    "play --display null --frames 2 --stats $outer/own.character" \
    "play --display null --frames 2 --record-buttons $outer/own.character" \
    "play --display null --frames 2 --buttons script:$scratch/kept.txt --record-buttons $scratch/kept.txt"; do
    words=${wrong#* }
    # shellcheck disable=SC2086 # a command and its options
    limber ${wrong%% *} "$outer/own.gltf" $words
    expect_status 1
    expect_err '^limber: .*: cannot be written: limber reads this file: give another name$'
    check 'limber prints one sentence' test "$(wc -l <"$err_file")" -eq 1
done
check 'the buffer is as it was' cmp "$scratch/film.kept" "$outer/film.gif"
check 'the character file is as it was' \
    cmp "$scratch/character.kept" "$outer/own.character"
check 'the script is as it was' grep -q UP "$scratch/kept.txt"
check 'no temporary file is left' sh -c "! ls '$outer' | grep part"

# Names of another kind of file: limber writes no C source into a picture.
for wrong in "pose -o $scratch/new.png" "pose -o $scratch/new.c" \
    "pose -o $scratch/new.fbx" "pose -o $scratch/new.STL" \
    "export --c $scratch/new.cpp" "export --c $scratch/new.GLB" \
    "character -o $scratch/new.levels" "levels -o $scratch/new.gltf"; do
    # shellcheck disable=SC2086 # a command and its options
    limber $wrong "$scratch/kept.gltf"
    expect_refusal 2 'new\..*: this command writes .*: give a name that ends in '
done
check 'no file of another kind is written' sh -c "! ls $scratch/new*"
for right in "pose -o $scratch/new" "pose -o $scratch/new.txt" \
    "pose -o $scratch/new.OBJ" "levels -o $scratch/new.levels"; do
    # shellcheck disable=SC2086 # a command and its options
    limber $right "$scratch/kept.gltf"
    expect_status 0
done

# Long names are read, not left out. Those that no file can have are refused.
deep=$scratch/$(printf '%01000d' 0 | sed 's|0|./|g')
echo 'nonsense = 1' >"$scratch/long.conf"
limber play "$slider" --display null --frames 2 --config "$deep/long.conf"
expect_refusal 1 '/long\.conf:.*nonsense'
echo '[nonsense]' >"$scratch/long.character"
limber play "$slider" --display null --frames 2 \
    --character "$deep/long.character"
expect_refusal 1 '/long\.character:.*nonsense'
cp "$slider" "$scratch/long.gltf"
limber play "$deep/long.gltf" --display null --frames 2
expect_refusal 1 '/long\.character:.*nonsense'
mkdir "$scratch/long.assets"
echo 'no model' >"$scratch/long.assets/arm.glb"
kept_assets=${LIMBER_ASSETS-}
LIMBER_ASSETS=$deep/long.assets
export LIMBER_ASSETS
limber play --demo arm --display null --frames 2
expect_refusal 1 '/long\.assets/arm\.glb:'
LIMBER_ASSETS=$kept_assets
[ -n "$kept_assets" ] || unset LIMBER_ASSETS
limber play "$slider" --display null --frames 2 --config "$deep/$deep/$deep/x"
expect_status 2
rm -r "$scratch"/long.*

# Folders that do not exist.
limber pose "$slider" -o "$scratch/nowhere/out.obj"
expect_refusal 1 'nowhere/out\.obj: .*[Nn]o such'
limber render "$slider" -o "$scratch/nowhere/out.png"
expect_refusal 1 'nowhere/out.*\.png: .*[Nn]o such'
limber render "$slider" --frames 2 -o "$scratch/nowhere/out.gif"
expect_refusal 1 'nowhere/out\.gif: '
limber render "$slider" --frames 2 -o "$scratch/nowhere/out.y4m"
expect_refusal 1 'nowhere/out\.y4m: .*[Nn]o such'

# A full disk: a device like /dev/full, which root can make in a folder of the
# test's own.
full=$scratch/full
if ! { mknod -m 666 "$full" c 1 7 && : >"$full"; } 2>/dev/null; then
    rm -f "$full"
    full=/dev/full
fi
if [ -c "$full" ] && [ -w "$full" ]; then
    limber pose "$slider" -o "$full"
    expect_refusal 1 'full: .*[Nn]o space'
    check 'a device stays where it is' test -c "$full"
    limber play "$slider" --display null --frames 2 --stats "$full"
    expect_status 1
    expect_err 'full: .*[Nn]o space'
    check 'a device stays where it is after --stats' test -c "$full"
    limber export "$slider" --clip slide --c "$full"
    expect_status 1
    check 'a device stays where it is after export' test -c "$full"
    for words in info 'info --json' 'doctor --json' compare 'compare --format json'
    do
        # shellcheck disable=SC2086,SC2016 # a command and its arguments
        run sh -c 'full=$1; shift; "$@" >"$full"' sh "$full" $limber $words \
            "$slider"
        about "limber $words onto a full disk"
        expect_status 1
        expect_err '^limber: .*[Nn]o space'
    done
else
    skip 'a full disk' 'this machine has no /dev/full that may be written to'
fi

# A file that cannot be written is reported before the work, not after it.
for command in 'play --display null --stats out.json' \
    'play --display null --record out.gif' \
    'play --display null --record-buttons out.txt' \
    'render --frames 9999 -o out.y4m' 'optimize -o out.glb' 'compare --plot out.svg' \
    'compare --export out'; do
    words=${command% *}
    # shellcheck disable=SC2086 # a command and its options
    limber ${words%% *} "$slider" ${words#* } "$scratch/nowhere/${command##* }"
    expect_refusal 1 'nowhere/out.*: .*No such file or directory'
done
mkdir "$scratch/closed"
chmod 555 "$scratch/closed"
if [ -w "$scratch/closed" ]; then
    skip 'an export into a folder that is closed' 'this user may write anywhere'
else
    limber compare "$slider" --export "$scratch/closed"
    expect_refusal 1 'closed: the folder cannot be written: .*: choose one'
fi

# A file that may not grow: the older file is kept, and no other file is left.
mkdir "$scratch/kept"
for command in 'pose -o out.obj' 'render -o out.png' 'render --frames 3 -o out.gif' \
    'render --frames 3 -o out.y4m' 'export --clip slide --c out.c' \
    'play --display null --frames 2 --stats out.json' \
    'play --display null --frames 2 --record out.gif' \
    'compare --plot out.svg'; do
    file=$scratch/kept/${command##* }
    words=${command% *}
    echo old >"$file"
    # shellcheck disable=SC2086,SC2016 # a command and its arguments
    run sh -c '(ulimit -f 0; exec "$@") 2>&1 | cat' sh $limber \
        ${words%% *} "$slider" ${words#* } "$file"
    about "limber $words on a disk that is full"
    expect_out '^limber: .*out.*: .*too large'
    check "${file##*/} is as it was" test "$(cat "$file")" = old
    rm "$file"
done
check 'no temporary file is left' test -z "$(ls -A "$scratch/kept")"

# limber writes to pipes, to standard output and through links.
# shellcheck disable=SC2086,SC2016 # a command and its arguments
run sh -c 'mkfifo "$1"; cat "$1" & shift; "$@"; wait' sh "$scratch/pipe" $limber \
    pose "$slider" -o "$scratch/pipe"
about 'limber pose into a pipe'
expect_status 0
expect_out '^o node0_prim0$'
check 'the pipe is still a pipe' test -p "$scratch/pipe"
# It is not opened before the plot is ready, which would end its reader.
# shellcheck disable=SC2086,SC2016 # a command and its arguments
run sh -c 'mkfifo "$1"; cat "$1" & shift; "$@" >/dev/null; wait' sh \
    "$scratch/pipe.svg" $limber compare "$slider" --size 48x64 \
    --plot "$scratch/pipe.svg"
about 'limber compare --plot into a pipe'
expect_status 0
expect_out '</svg>'
limber pose "$slider" -o /dev/stdout
expect_status 0
expect_out '^o node0_prim0$'
echo first >"$scratch/appended"
# shellcheck disable=SC2086,SC2016 # a command and its arguments
run sh -c 'file=$1; shift; "$@" >>"$file"' sh "$scratch/appended" $limber pose \
    "$slider" -o /dev/stdout
about 'limber pose, appending standard output'
check 'what stood in the file before is kept' \
    test "$(head -n 1 "$scratch/appended")" = first
check 'the pose follows it' grep -q '^o node0_prim0$' "$scratch/appended"

# "-" is standard output of the commands that print nothing but their file.
limber pose "$slider" -o -
expect_status 0
expect_out '^o node0_prim0$'
limber character "$slider"
cp "$out_file" "$scratch/sketch"
limber character "$slider" -o -
expect_status 0
check 'it is what character prints without -o' \
    cmp "$scratch/sketch" "$out_file"
refused_dash() {
    limber "$@"
    expect_refusal 2 '-: only pose and character write to standard output: '
}
refused_dash render "$slider" -o -
refused_dash levels "$slider" -o -
refused_dash optimize "$slider" -o -
refused_dash export "$slider" --c -
refused_dash play "$slider" --stats -
refused_dash play "$slider" --record-buttons -
check 'no file is named -' test ! -e -

# Outputs that are no regular files: standard output that the shell has redirected,
# devices, named pipes and folders.

# Every command and option that writes a file whose name need not tell its format.
writers='pose -o:character -o:levels -o:optimize -o:export --c:compare --size 48x64 --plot'

# each FUNCTION: calls it with the words of each writer.
each() {
    kept_ifs=$IFS
    IFS=:
    for writer in $writers; do
        IFS=$kept_ifs
        # shellcheck disable=SC2086 # a command and its options
        "$1" $writer
    done
    IFS=$kept_ifs
}

# written COMMAND OPTION... FILE: the command with the model in its place.
written() {
    command=$1
    shift
    # shellcheck disable=SC2086 # a command and its arguments
    $limber "$command" "$scratch/stream.gltf" "$@"
}
cp "$slider" "$scratch/stream.gltf"

# What the command writes into a file is what it writes into standard output, and
# what it prints about the file does not follow there.
to_stdout() {
    about "limber $* /dev/stdout"
    whole=$scratch/stream.${1}
    case $1 in
    optimize) whole=$whole.glb ;;
    export) whole=$scratch/stream.c ;;
    compare) whole=$whole.svg ;;
    esac
    rm -f "$whole"
    written "$@" "$whole" >"$scratch/report" 2>&1
    for name in /dev/stdout /dev/fd/1; do
        printf 'first\n' >"$scratch/appended"
        status=0
        written "$@" "$name" >>"$scratch/appended" 2>"$err_file" || status=$?
        expect_status 0
        check "$name: what was there is kept and the file follows" sh -c \
            '{ echo first; cat "$1"; } | cmp - "$2"' sh \
            "$whole" "$scratch/appended"
    done
}
each to_stdout

into_device() {
    written "$@" /dev/null >"$out_file" 2>"$err_file"
    status=$?
    about "limber $* /dev/null"
    expect_status 0
    check 'it stays a device' test -c /dev/null
}
each into_device

into_pipe() {
    rm -f "$scratch/reader"
    mkfifo "$scratch/reader"
    wc -c <"$scratch/reader" >"$scratch/count" &
    written "$@" "$scratch/reader" >"$out_file" 2>"$err_file"
    status=$?
    about "limber $* PIPE"
    expect_status 0
    [ "$status" -eq 0 ] || : >"$scratch/reader" # lets the reader end
    wait
    check 'its reader gets the file' test "$(cat "$scratch/count")" -gt 4
}
each into_pipe

mkdir "$scratch/a-folder.svg" "$scratch/a-folder.glb"
into_folder() {
    folder=$scratch/a-folder.glb
    case $1 in
    pose | character | levels | export)
        mkdir -p "$scratch/a-folder"
        folder=$scratch/a-folder
        ;;
    compare) folder=$scratch/a-folder.svg ;;
    esac
    written "$@" "$folder" >"$out_file" 2>"$err_file"
    status=$?
    about "limber $* FOLDER"
    expect_refusal 1 'cannot be written: Is a directory: name a file in it'
}
each into_folder

mkdir "$scratch/elsewhere"
ln -s elsewhere/target.obj "$scratch/link.obj"
limber pose "$slider" -o "$scratch/link.obj"
expect_quiet
check 'the link is still a link' test -L "$scratch/link.obj"
check 'the target of the link is written' test -s "$scratch/elsewhere/target.obj"
limber render "$slider" -o "$out.bmp"
expect_err '^limber: .*\.bmp: .*png.*gif.*y4m'
expect_no_out

# A standard stream that is closed is not a file that limber writes.
limber render "$slider" --size 16x16 --frames 2 -o "$scratch/open.y4m"
limber play "$slider" --display null --frames 2 \
    --record-buttons "$scratch/open.txt"
for closed in '0<&-' '1>&-' '2>&-' '0<&- 2>&-' '0<&- 1>&- 2>&-'; do
    # shellcheck disable=SC2086,SC2016 # a command and its arguments
    run sh -c 'file=$1 closed=$2; shift 2
        eval "exec \"\$@\" --verbose -o \"\$file\" $closed"' sh \
        "$scratch/closed.y4m" "$closed" $limber render "$slider" --size 16x16 \
        --frames 2
    about "limber render with $closed"
    expect_status 0
    check 'the film has no messages in it' \
        cmp "$scratch/open.y4m" "$scratch/closed.y4m"
    # shellcheck disable=SC2086,SC2016 # a command and its arguments
    run sh -c 'file=$1 closed=$2; shift 2
        eval "exec \"\$@\" --record-buttons \"\$file\" $closed"' sh \
        "$scratch/closed.txt" "$closed" $limber play "$slider" --display null \
        --frames 2
    check 'nor has a recording' cmp "$scratch/open.txt" "$scratch/closed.txt"
done

# Frames feed a watchdog, and limber disables it at the end. Without a watchdog
# limber plays as well.
: >"$scratch/watchdog"
limber play "$slider" --display null --frames 2 --watchdog "$scratch/watchdog"
expect_status 0
expect_no_err
check 'a watchdog is fed and disabled' \
    test "$(bytes "$scratch/watchdog" 0 9)" = 0056
limber play "$slider" --display null --frames 2 --watchdog "$scratch/none"
expect_status 0
expect_err '^limber: --watchdog .*none: No such file'
# What holds data is no watchdog: feeding it would destroy the data.
for file in film.gif hard.png own.character; do
    cp "$outer/$file" "$scratch/held"
    limber play "$outer/own.gltf" --display null --frames 2 \
        --watchdog "$outer/$file"
    expect_status 0
    expect_err "^limber: --watchdog .*$file: this is no watchdog: it holds data"
    check "$file is as it was" cmp "$scratch/held" "$outer/$file"
done

# Button scripts.
limber render "$slider" --script "$scratch/none.txt" -o "$out.png"
expect_refusal 1 'none\.txt: .*[Nn]o such file'
printf '0 UP down\n10 SIDEWAYS down\n' >"$scratch/bad.txt"
limber render "$slider" --script "$scratch/bad.txt" -o "$out.png"
expect_refusal 1 'bad\.txt.*2.*SIDEWAYS'
limber render "$slider" --buttons nonsense -o "$out.png"
expect_err '^limber: .*nonsense: .*script'
expect_no_out

for kind in obj png bmp; do
    check "nothing is left of a failed $kind" test ! -e "$out.$kind"
done
tap_done
