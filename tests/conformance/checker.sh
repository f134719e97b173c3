#!/bin/sh
# Tests the program conformance with made-up references and OBJ files. The
# environment may set CONFORMANCE, the program.
. "$(dirname "$0")/../support/tap.sh"
checker=${CONFORMANCE:-build/host/conformance}

samples=$scratch/samples
mkdir -p "$samples/models" "$samples/oracle" "$scratch/out"
: >"$samples/models/Two.glb"
reference=$samples/oracle/Two@0@0.5.json
cat >"$reference" <<'END'
{"meshes": [
  {"node": 0, "primitive": 0, "positions": [[0,0,0],[2,0,0],[0,1,0]]},
  {"node": 3, "primitive": 1, "positions": [[0,0,1],[1,0,1],[0,1,1]]}]}
END

# The output that the reference requires.
cat >"$scratch/good.obj" <<'END'
# two parts
o node0_prim0
v 0.000000 0.000000 0.000000
v 2.000000 0.000100 0.000000
v 0.000000 1.000000 -0.000150
f 1 2 3
o node3_prim1
v 0.000000 0.000000 1.000000
v 1.000000 0.000000 1.000000
v 0.000000 1.000000 1.000000
f 4 5 6
END

# Takes the place of limber: records its arguments and copies given.obj.
cat >"$scratch/limber" <<'END'
#!/bin/sh
echo "$*" >"$0.arguments"
while [ "$1" != -o ]; do shift; done
cp "${0%/*}/given.obj" "$2"
END
chmod +x "$scratch/limber"

# given [SED]: compares good.obj, edited by sed, with the reference.
given() {
    sed "${1-}" "$scratch/good.obj" >"$scratch/given.obj"
    run "$checker" "$samples" "$scratch/out" "$scratch/limber"
}

# refuses NAME SED PATTERN
refuses() {
    given "$2"
    about "$1"
    expect_status 1
    expect_out '^not ok 1 - Two@0@0.5.json'
    expect_err "$3"
}

CMOCKA_MESSAGE_OUTPUT=TAP
export CMOCKA_MESSAGE_OUTPUT

given
about 'equal within 1e-4 of the extent'
expect_status 0
expect_out '^1..1$'
expect_out '^ok 1 - Two@0@0.5.json'
check 'the clip and the time are passed on' grep -Eqx \
    'pose .*/models/Two.glb --time 0.5 -o .*/out/.*.obj --clip 0' \
    "$scratch/limber.arguments"

refuses 'a wrong vertex' 's/^v 1.000000 0.000000 1/v 1.000300 0.000000 1/' \
    'node3_prim1: 1 of 3 vertices'
refuses 'a missing vertex' '/^v 0.000000 1.000000 -/d; s/^f 1 2 3/f 1 2 1/; s/^f 4.*/f 3 4 5/' \
    'node0_prim0 has 2 vertices instead of 3'
refuses 'a missing object' '/^o node3/,$d' 'the object node3_prim1 is missing'
refuses 'an object too many' '$a o node4_prim0\nv 0 0 0\nf 7 7 7' \
    'the reference has no object node4_prim0'
refuses 'an object twice' 's/node3_prim1/node0_prim0/' 'the file has the object node0_prim0 twice'
refuses 'NaN' 's/^v 2.000000/v nan/' 'does not have three finite numbers'
refuses 'infinity' 's/^v 2.000000/v inf/' 'does not have three finite numbers'
refuses 'vertices in another order' '3{h;d};4G' 'node0_prim0: 2 of 3 vertices'
refuses 'two numbers a vertex' 's/^v 2.000000 /v /' 'does not have three finite numbers'
refuses 'a face with a vertex that does not exist' 's/^f 4 5 6/f 4 5 7/' 'is not a triangle'
refuses "a face of another object's vertices" 's/^f 4 5 6/f 3 5 6/' 'is not a triangle'
refuses 'no faces' '/^f 4/d' 'node3_prim1 has no faces'
refuses 'an unexpected line' '1a stray' 'comes before the first object'

run "$checker" "$samples" "$scratch/out" false
about 'a command that fails'
expect_status 1
expect_err 'exit status 1'

run "$checker" "$samples" "$scratch/out" true
about 'a command that writes nothing'
expect_status 1
expect_err 'No such file'

mv "$reference" "$samples/oracle/Two@-@0.json"
given
about 'the rest pose'
expect_status 0
check 'no clip is passed for the rest pose' grep -Eqx \
    'pose .*/models/Two.glb --time 0 -o .*.obj' "$scratch/limber.arguments"

mv "$samples/models/Two.glb" "$samples/models/Other.glb"
given
about 'a missing model'
expect_status 1
expect_err 'Two.glb and .gltf are missing'

mv "$samples/oracle/Two@-@0.json" "$samples/oracle/Two.json"
given
about 'a reference with a malformed name'
expect_status 1

rm "$samples/oracle/Two.json"
given
about 'an empty folder of references'
expect_out '^1..0$'

rmdir "$samples/oracle"
given
about 'no folder of references'
expect_status 0
expect_out '^1..0 # SKIP .*SAMPLES='

# Tests fixed.sh with a script in place of both programs. With the kernel $WRONG
# it writes another vertex.
cat >"$scratch/stand-in" <<'END'
#!/bin/sh
[ "$1" != info ] || { echo '{"clips": []}'; exit; }
kernel=
for word; do
    case $last in
    --kernel) kernel=$word ;;
    -o) echo "v 1 2 $([ "$kernel" = "$WRONG" ] && echo 4 || echo 3)" >"$word" ;;
    esac
    last=$word
done
END
chmod +x "$scratch/stand-in"
for wrong in none armv6; do
    WRONG=$wrong run tests/conformance/fixed.sh "$samples" \
        "$scratch/stand-in" "$scratch/stand-in"
    about "fixed.sh, wrong kernel: $wrong"
    if [ "$wrong" = none ]; then
        expect_status 0
        expect_out '^ok .*walker.glb at rest'
    else
        expect_status 1
        expect_out '^not ok .*walker.glb at rest'
    fi
done

tap_done
