#!/bin/sh
# Tests golden.sh and texts.py with a script in place of limber.
. "$(dirname "$0")/../support/tap.sh"
here=$(dirname "$0")
fixtures=$here/checker
COMPARE=${COMPARE:-build/host/compare_png}
GOLDEN=$scratch/golden
export COMPARE GOLDEN

mkdir "$GOLDEN"
cat >"$GOLDEN/pictures.txt" <<'END'
# two pictures
one   --demo one --time 1
two   --demo two
END

# Takes the place of limber: records its arguments and copies given/DEMO.png.
cat >"$scratch/limber" <<'END'
#!/bin/sh
echo "$*" >>"$0.arguments"
demo=$3
while [ "$1" != -o ]; do shift; done
cp "${0%/*}/given/$demo.png" "$2"
END
chmod +x "$scratch/limber"
mkdir "$scratch/given"
cp "$fixtures/circle.png" "$scratch/given/one.png"
cp "$fixtures/square.png" "$scratch/given/two.png"

checks() {
    run "$here/golden.sh" check osmesa "$scratch/out" sh "$scratch/limber"
}

checks
about 'missing references'
expect_status 1
expect_out '^not ok 1 - one'
expect_out '/golden/osmesa/one.png does not exist'
expect_out '^1..3$'

run "$here/golden.sh" make "$scratch/limber"
about 'making the references'
expect_status 0
check 'both are made' test -s "$GOLDEN/osmesa/one.png" -a -s "$GOLDEN/osmesa/two.png"

: >"$scratch/limber.arguments"
checks
about 'pictures equal to their references'
expect_status 0
expect_out '^ok 1 - one'
expect_out '^ok 2 - two'
expect_out 'largest 0$'
check 'the arguments are passed on' grep -Eqx \
    'render --demo one --time 1 --gl osmesa -o .*/out/one.png' \
    "$scratch/limber.arguments"

PICTURES='t.*' checks
about 'the pictures whose names match alone'
expect_status 0
expect_out '^ok 1 - two'
expect_out '^1..2$'
PICTURES=tw checks
about 'no such picture'
expect_status 2
expect_err 'no picture is called tw'

run "$here/golden.sh" exact "$scratch/out" sh "$scratch/limber"
about 'pictures equal to the references of soft'
expect_status 0
expect_out '^ok 2 - two'
cp "$fixtures/moved.png" "$GOLDEN/soft/one.png"
run "$here/golden.sh" exact "$scratch/out" sh "$scratch/limber"
about 'a picture that differs from the reference of soft'
expect_status 1
expect_out '^not ok 1 - one'
rm "$GOLDEN/soft/one.png"
run "$here/golden.sh" exact "$scratch/out" sh "$scratch/limber"
about 'a missing reference of soft'
expect_status 1
expect_out '/golden/soft/one.png does not exist'
cp "$GOLDEN/osmesa/one.png" "$GOLDEN/soft/one.png"

cp "$fixtures/moved.png" "$scratch/given/one.png"
checks
about 'a circle that moved'
expect_status 1
expect_out '^not ok 1 - one'
expect_out '^ok 2 - two'
expect_file "$scratch/out/one-difference.png"

# Defects that are small in a large picture. painted FILE X Y WIDTH HEIGHT: a
# grey picture of 200 x 200 with a rectangle that is 40 lighter.
painted() {
    python3 -c '
import struct, sys, zlib
x, y, width, height = map(int, sys.argv[2:])
rows = [[90 + 40 * (x <= i < x + width and y <= j < y + height)
         for i in range(200) for _ in range(3)] for j in range(200)]
def chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
open(sys.argv[1], "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(
    b"IHDR", struct.pack(">2I5B", 200, 200, 8, 2, 0, 0, 0)) + chunk(
    b"IDAT", zlib.compress(b"".join(b"\0" + bytes(r) for r in rows))) +
    chunk(b"IEND", b""))' "$@"
}

painted "$GOLDEN/osmesa/one.png" 0 0 100 200
painted "$scratch/given/one.png" 0 0 101 200
checks
about 'an edge that is off by a pixel'
expect_status 0
painted "$GOLDEN/osmesa/one.png" 0 0 0 0
for defect in '70 30 1 40' '30 70 40 1' '61 77 8 8'; do
    # shellcheck disable=SC2086 # four words
    painted "$scratch/given/one.png" $defect
    checks
    about "a defect of $defect"
    expect_status 1
    expect_out '^not ok 1 - one'
done
cp "$fixtures/circle.png" "$GOLDEN/osmesa/one.png"

cp "$fixtures/square.png" "$scratch/given/one.png"
checks
about 'another size'
expect_status 1
expect_out 'the picture is 32x32, its reference 48x48'

echo no >"$scratch/given/one.png"
checks
about 'a file that is not a PNG'
expect_status 1
expect_out 'cannot be read as a PNG'

rm "$scratch/given/one.png"
run "$here/golden.sh" make "$scratch/limber"
about 'making references where limber fails'
expect_status 1
check 'the others are made' test ! -e "$GOLDEN/osmesa/one.png" -a -s "$GOLDEN/osmesa/two.png"

cp "$fixtures/circle.png" "$GOLDEN/osmesa/one.png"
checks
about 'limber fails'
expect_status 1
expect_out '^not ok 1 - one'
expect_out '^ok 2 - two'

cp "$fixtures/circle.png" "$scratch/given/one.png"
cp "$fixtures/circle.png" "$GOLDEN/osmesa/three.png"
checks
about 'a reference that is not listed'
expect_status 1
expect_out '^not ok 3 '
expect_out 'three.png: pictures.txt does not list this reference'

# Takes the place of limber: prints a line and copies a file.
cat >"$scratch/texts" <<'END'
#!/bin/sh
echo "read $1 us_per_frame | 3"
[ "$2" = none ] || cp "$1" "$2"
exit "$3"
END
printf 'one %s none 0\ntwo %s OUT/copy.txt 3\n' "$scratch/given/text" \
    "$scratch/given/text" >"$GOLDEN/texts.txt"
: >"$GOLDEN/films.txt"
printf 'gravity = 0 -9.81\n| name | us_per_frame |\n| walk | 17.5 |\n' \
    >"$scratch/given/text"

texts() {
    run "$here/texts.py" check "$scratch/out" sh "$scratch/texts"
}

texts
about 'missing reference texts'
expect_status 1
expect_out '^not ok 1 - one'
expect_out '/golden/texts/one.txt does not exist: run make golden, and read it$'

run "$here/texts.py" make sh "$scratch/texts"
about 'making the reference texts'
expect_status 0
check 'the status and the file are kept' test \
    "$(grep -c -e '^status 3$' -e '^copy.txt:$' "$GOLDEN/texts/two.txt")" -eq 2
texts
about 'equal texts'
expect_status 0
expect_out '^ok 2 - two'
expect_out '^1..3$'

# changed SED STATUS WHAT: the check of a file that sed has changed.
cp "$scratch/given/text" "$scratch/text"
changed() {
    sed "$1" "$scratch/text" >"$scratch/given/text"
    texts
    about "$3"
    expect_status "$2"
}
changed 's/9.81/9.811/' 0 'a number within 0.1%'
changed 's/17.5/25.5/' 0 'another measured time'
changed 's/9.81/9.83/' 1 'a number off by 0.2%'
expect_out '^not ok 2 - two'
expect_out '^# -gravity = 0 -9.81$'
expect_out '^# [+]gravity = 0 -9.83$'
changed 's/= 0/= 1/' 1 'another whole number'
changed 's/walk/run/' 1 'another word'
changed '1d' 1 'a missing line'
changed '' 0 'the text as it was'

printf 'gravity = 0 -9.81\n| name | instructions_per_frame |\n| walk |  |\n' \
    >"$scratch/text"
printf '  a b  us here k instr.\n  walk 7 1.5 -\n\n  end 1 2\n' >>"$scratch/text"
changed '' 1 'another text'
run "$here/texts.py" make sh "$scratch/texts"
changed 's/walk |  /walk | 75.5 /' 0 'a count of instructions'
changed 's/1.5 -/2.5 3000/' 0 'a measured time in the last columns'
changed 's/walk 7/walk 8/' 1 'another number before the last columns'
changed 's/end 1 2/end 1 3/' 1 'another number after that table'
changed '' 0 'the text as it was'
echo "two $scratch/given/text none 1" >>"$GOLDEN/texts.txt"
texts
about 'a second command of the same name'
expect_status 1
expect_out '^# [+]limber .*/text none 1$'
expect_out '^# [+]status 1$'
sed -i '$d' "$GOLDEN/texts.txt"

echo 'status 0' >"$GOLDEN/texts/three.txt"
texts
about 'a reference text that is not listed'
expect_status 1
expect_out 'texts.txt and films.txt do not list three.txt'
rm "$GOLDEN/texts/three.txt"

# glb FILE X: a .glb of two bytes, of which an accessor reads the second as X.
glb() {
    python3 -c '
import json, struct, sys
root = json.dumps({"accessors": [{"bufferView": 0, "byteOffset": 1, "count": 1,
    "type": "SCALAR", "componentType": 5121}],
    "bufferViews": [{"buffer": 0, "byteLength": 2}]}).encode()
root += b" " * (-len(root) % 4)
data = bytes([7, int(sys.argv[2])])
open(sys.argv[1], "wb").write(
    struct.pack("<4s4I", b"glTF", 2, 0, len(root), 0x4E4F534A) + root +
    struct.pack("<2I", len(data), 0x4E4942) + data)' "$@"
}
glb "$scratch/given/model.glb" 5
echo "model $scratch/given/model.glb OUT/model.glb 0" >"$GOLDEN/texts.txt"
rm "$GOLDEN/texts"/*
run "$here/texts.py" make sh "$scratch/texts"
check 'an accessor has its sums' grep -q '"sums": \[5, 5\]' \
    "$GOLDEN/texts/model.txt"
glb "$scratch/given/model.glb" 6
texts
about 'another value of an accessor'
expect_status 1
expect_out '^not ok 1 - model'

# film BYTE: the script draws a film of two pictures of 4 x 4 pixels, half a second
# each; the byte, in octal, is the brightness of the last pixel.
cat >"$scratch/texts" <<'END'
#!/bin/sh
while [ "$1" != -o ]; do shift; done
cp "$0.film" "$2"
END
film() {
    row='\000\100\200\300'
    gray='\200\200\200\200\200\200\200\200'
    {
        printf 'YUV4MPEG2 W4 H4 F2:1 Ip C420jpeg\n'
        printf 'FRAME\n%b' "$row$row$row$row$gray"
        printf 'FRAME\n%b' "$row$row$row\\000\\100\\200\\0$1$gray"
    } >"$scratch/texts.film"
}
film 300
: >"$GOLDEN/texts.txt"
echo 'small --demo small' >"$GOLDEN/films.txt"
rm "$GOLDEN/texts"/*
run "$here/texts.py" make sh "$scratch/texts"
check 'a picture has a line' test \
    "$(grep -c '^0\.[05]0 s  [0-9a-f]\{8\}  00 25 50 75, .*, 00 25 50 75$' \
    "$GOLDEN/texts/film-small.txt")" -eq 2
film 301
texts
about 'a pixel of the second picture that is off by one'
expect_status 1
expect_out '^# -0\.50 s '
expect_out '^# [+]0\.50 s '
check 'the first picture is as before' test -z "$(grep '^# [-+]0.00' "$out_file")"

tap_done
