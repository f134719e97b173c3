#!/bin/sh
# Tests demo.sh with a replacement of limber.
. "$(dirname "$0")/../support/tap.sh"
script=$(dirname "$0")/../../toolchain/demo.sh

# given STATUS: makes a limber whose play exits with STATUS.
given() {
    rm -rf "$scratch/calls" "$scratch/pictures"
    cat >"$scratch/limber" <<END
#!/bin/sh
echo "\$*" >>$scratch/calls
[ "\$1" != play ] || exit $1
while [ "\$1" != -o ]; do shift; done
echo picture >"\$2"
END
    chmod +x "$scratch/limber"
}

demo() {
    run env DISPLAY="$1" WAYLAND_DISPLAY="$2" "$script" "$scratch/limber" \
        "$scratch/pictures"
}

pictures_are_there() {
    for demo in walker face arm crowd duel tuner; do
        expect_file "$scratch/pictures/$demo.png"
        expect_file "$scratch/pictures/$demo.gif"
        expect_out "^  .*/pictures/$demo.png$"
        expect_out "^  .*/pictures/$demo.gif$"
    done
}

given 0
demo '' ''
about 'no desktop'
expect_status 0
pictures_are_there
check 'no desktop: nothing is played' sh -c '! grep -q play "$1"' sh \
    "$scratch/calls"

for desktop in ':0 ' ' wayland-0'; do
    given 0
    demo "${desktop% *}" "${desktop#* }"
    about "a desktop (${desktop})"
    expect_status 0
    check "$tap_about: all are played" test \
        "$(grep -c '^play --demo' "$scratch/calls")" -eq 6
    check "$tap_about: nothing is drawn" test ! -e "$scratch/pictures"
done

given 1
demo :0 ''
about 'a desktop that does not open'
expect_status 0
expect_out '^limber could not open a window'
pictures_are_there

printf '#!/bin/sh\nexit 1\n' >"$scratch/limber"
demo '' ''
about 'nothing can be drawn'
expect_status 1
tap_done
