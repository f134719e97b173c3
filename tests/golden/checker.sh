#!/bin/sh
# The picture runner itself, with a stand-in for limber.
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

# Stands in for limber: notes its arguments and draws given/DEMO.png.
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
expect_out 'no reference .*/golden/one.png'
expect_out '^1..3$'

run "$here/golden.sh" make "$scratch/limber"
about 'making the references'
expect_status 0
check 'both are made' test -s "$GOLDEN/one.png" -a -s "$GOLDEN/two.png"

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

run "$here/golden.sh" exact "$scratch/out" sh "$scratch/limber"
about 'pictures equal to soft own references'
expect_status 0
expect_out '^ok 2 - two'
cp "$fixtures/moved.png" "$GOLDEN/soft/one.png"
run "$here/golden.sh" exact "$scratch/out" sh "$scratch/limber"
about 'a reference of soft that differs'
expect_status 1
expect_out '^not ok 1 - one'
rm "$GOLDEN/soft/one.png"
run "$here/golden.sh" exact "$scratch/out" sh "$scratch/limber"
about 'a reference of soft that is missing'
expect_status 1
expect_out 'no reference .*/golden/soft/one.png'
cp "$GOLDEN/one.png" "$GOLDEN/soft/one.png"

cp "$fixtures/moved.png" "$scratch/given/one.png"
checks
about 'a circle that moved'
expect_status 1
expect_out '^not ok 1 - one'
expect_out '^ok 2 - two'
expect_file "$scratch/out/one-difference.png"

cp "$fixtures/square.png" "$scratch/given/one.png"
checks
about 'another size'
expect_status 1
expect_out '32x32, not 48x48'

echo no >"$scratch/given/one.png"
checks
about 'no picture at all'
expect_status 1
expect_out 'missing or no PNG'

rm "$scratch/given/one.png"
run "$here/golden.sh" make "$scratch/limber"
about 'making references where limber fails'
expect_status 1
check 'the others are made' test ! -e "$GOLDEN/one.png" -a -s "$GOLDEN/two.png"

cp "$fixtures/circle.png" "$GOLDEN/one.png"
checks
about 'limber fails'
expect_status 1
expect_out '^not ok 1 - one'
expect_out '^ok 2 - two'

cp "$fixtures/circle.png" "$scratch/given/one.png"
cp "$fixtures/circle.png" "$GOLDEN/three.png"
checks
about 'a reference for nothing'
expect_status 1
expect_out '^not ok 3 '
expect_out 'three.png is a reference for nothing'

tap_done
