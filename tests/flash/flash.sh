#!/bin/sh
# shellcheck disable=SC2154 # tap.sh's variables
# Tests flash.sh with a simulated boot loader on a pseudo-terminal, as U-Boot and, at
# the same time, as RedBoot: most of the time they wait for each other.
. "$(dirname "$0")/../support/tap.sh"
flash=board/imx31-pdk/flash.sh
images=$scratch/images
all=$scratch
loader_pid=
mkdir "$images"

# work_in NAME: the files of the board and of flash.sh go into a folder of that name.
work_in() {
    scratch=$all/$1
    served=$scratch/served
    received=$scratch/received
    chips=$scratch/chips
    out_file=$scratch/out
    err_file=$scratch/err
    mkdir "$scratch" "$served" "$chips"
}

# Images of odd sizes, and one of whole pages.
head -c 300001 /dev/urandom >"$images/zImage-dtb"
head -c 200003 /dev/urandom >"$images/initramfs.cpio.lz4"
head -c 262144 /dev/urandom >"$images/rootfs.ubi"
(cd "$images" && sha256sum -- * >SHA256SUMS)

# board LOADER [FAULT...]: starts a board and sets $line to its terminal.
board() {
    board_end
    rm -f "$scratch/line"
    board_loader=$1
    shift
    TMPDIR=$chips python3 "$(dirname "$0")/boot_console.py" "$board_loader" \
        "$served" "$received" "$@" >"$scratch/line" 2>"$scratch/board-errors" &
    loader_pid=$!
    while [ ! -s "$scratch/line" ] && kill -0 "$loader_pid" 2>/dev/null; do
        sleep 0.05
    done
    line=$(cat "$scratch/line")
}

board_end() {
    [ -z "$loader_pid" ] || kill "$loader_pid" 2>/dev/null || true
    [ -z "$loader_pid" ] || wait "$loader_pid" 2>/dev/null || true
    loader_pid=
}
trap 'board_end; rm -rf "$tap_folder"' EXIT

# flash ABOUT ARGUMENTS...: runs the script.
flash() {
    about_text=$1
    shift
    run "$flash" --images "$images" "$@"
    about "$about_text"
}

# on_board ABOUT ARGUMENTS...: runs it on the board's line with short time-outs.
on_board() {
    on_about=$1
    shift
    flash "$on_about" --port "$line" --seconds 2 "$@"
}

received_is() {
    check "$tap_about: received: $1" grep -Eq -e "$1" "$received"
}

never_received() {
    check "$tap_about: never received: $1" sh -c "! grep -Eq -e '$1' '$received'"
}

# with_loader LOADER: the tests of both.
with_loader() {
    loader=$1
    work_in "$loader"
    case $loader in
    uboot)
        start='^bootz 0x81000000 0x82000000:0x30d43$'
        writes='^nand (erase|write)'
        transfer='^tftpboot 0x81000000 zImage-dtb$'
        transfers=tftpboot
        ;;
    redboot)
        start='^exec -b 0x100000 -l 0x493e1 -r 0x2000000 -s 0x30d43 '
        writes='^fis create'
        transfer='^load -r -b 0x100000 zImage-dtb$'
        transfers='load -r'
        ;;
    esac

    rm -f "$served"/*
    board $loader
    on_board "$loader: run" run --tftp "$served"
    expect_status 0
    expect_out "The boot loader is $loader"
    received_is "$transfer"
    received_is "$start"
    never_received "$writes"

    board $loader
    on_board "$loader: write" write --yes
    expect_status 0
    received_is "$writes"
    on_board "$loader: the same again has nothing to do" write --yes
    expect_status 0
    expect_out 'kernel holds zImage-dtb already'
    expect_out 'rootfs holds rootfs.ubi already'
    check "$tap_about: each part was written once" \
        [ "$(grep -Ec "$writes" "$received")" -le 4 ]

    board $loader
    on_board "$loader: the user does not say yes" write
    expect_status 1
    expect_err 'kernel was not changed'
    never_received "$writes"

    board $loader lose=17
    on_board "$loader: hurried characters are lost" run
    expect_status 0
    received_is "$start"
    check "$tap_about: no command came damaged" \
        sh -c "! grep -Evq '^(setenv|tftpboot|crc32|bootz|load|cksum|exec) ' '$received'"

    board $loader drop=9
    on_board "$loader: one character is lost" run
    expect_status 0
    received_is "$start"

    board $loader refuse=1
    on_board "$loader: one transfer is refused" run
    expect_status 0
    expect_err 'try 1 of 3'
    received_is "$start"

    board $loader refuse=9
    on_board "$loader: every transfer is refused" run --tries 2
    expect_status 1
    expect_err 'zImage-dtb: .*(refused|access violation)'
    never_received "$start"

    board $loader silent_server=9
    on_board "$loader: the server is silent" run --tries 1
    expect_status 1
    expect_err 'zImage-dtb: .*(does not answer|timed out)'

    board $loader short=1 corrupt=2
    on_board "$loader: the server's copy is short, then damaged" run
    expect_status 0
    expect_err 'received [0-9]+ bytes instead|did not receive 300001 bytes'
    expect_err 'its checksum on the board is wrong'

    board $loader deaf=1
    on_board "$loader: one command gets no answer" run
    expect_status 0

    board $loader deaf=3
    on_board "$loader: a time-out ends it" run --tries 1
    expect_status 1
    expect_err 'no answer to'

    board $loader
    mv "$served/initramfs.cpio.lz4" "$scratch/away"
    on_board "$loader: the second file is missing" run --tries 1
    expect_status 1
    expect_err 'initramfs.cpio.lz4: '
    mv "$scratch/away" "$served/initramfs.cpio.lz4"
    on_board "$loader: it goes on where it was" run
    expect_status 0
    received_is "$start"
    check "$tap_about: the first file went over once" \
        [ "$(grep -c "^$transfers.*zImage-dtb" "$received")" -eq 1 ]

    board $loader erase=1
    on_board "$loader: one erase fails" write --yes
    expect_status 0
    expect_err 'kernel: .*(erase)'

    board $loader write=1
    on_board "$loader: one write fails" write --yes
    expect_status 0
    expect_err 'the content of the NAND differs from zImage-dtb'

    # The 40 blocks of the kernel are erased first.
    board $loader cut=30 returns address
    on_board "$loader: the power goes in an erase and comes back" write --yes \
        --address 192.168.1.9 --server 192.168.1.2
    expect_status 0
    expect_err 'kernel: the board was reset during .* \(try 1 of 3\)'

    board $loader cut=60
    on_board "$loader: the line goes in a program" write --yes
    expect_status 1
    expect_err 'the serial line has gone: .*start the same command again'

    board $loader autoboot=1
    on_board "$loader: stopped in its autoboot" run
    expect_status 0
    received_is "$start"

    board $loader linux=1
    on_board "$loader: the board runs Linux" run
    expect_status 1
    expect_err 'the board runs Linux: reset it'

    rm -f "$received"
    flash "$loader: dry run" write --dry-run --loader $loader --port /dev/none
    expect_status 0
    expect_out "$(echo "$transfer" | tr -d '^$')"
    expect_out "$(echo "$writes" | tr -d '^')"
    board_end
    check "$loader: no board leaves its chip behind" [ -z "$(ls -A "$chips")" ]
    echo '# all tests have run'
}

for loader in uboot redboot; do
    with_loader $loader >"$all/$loader.tap" &
    loaders="${loaders-} $!"
done
# shellcheck disable=SC2086 # process numbers are words
wait $loaders
for loader in uboot redboot; do
    awk -v count="$tap_count" '/^(not )?ok [0-9]/ {
        sub(/ok [0-9]+/, "ok " ++count) } { print }' "$all/$loader.tap"
    tap_count=$((tap_count + $(grep -Ec '^(not )?ok [0-9]' "$all/$loader.tap")))
    tap_failed=$((tap_failed + $(grep -c '^not ok' "$all/$loader.tap")))
    check "$loader: all tests have run" \
        grep -qx '# all tests have run' "$all/$loader.tap"
done

work_in both
cp "$images/zImage-dtb" "$images/initramfs.cpio.lz4" "$served"
board uboot address
on_board 'no address' run --tries 1
expect_status 1
expect_err 'give --server and --address'
on_board 'an address' run --address 192.168.1.9 --server 192.168.1.2
expect_status 0
received_is '^setenv serverip 192.168.1.2$'

board uboot
on_board 'the wrong dialect' run --loader redboot
expect_status 1
expect_err "the prompt is not that of redboot"

rm "$served/zImage-dtb"
board uboot
on_board 'not on the server' run --tries 1
expect_status 1
expect_err 'no such file \(--tftp copies it\)'

flash 'no line' run --port "$scratch/none"
expect_status 1
expect_err 'no such serial line: choose one with --port'
flash 'nothing asked' --port x
expect_status 2
flash 'a typo' run --prot x
expect_status 2
expect_err 'no such option'
flash 'no address' run --server here
expect_status 2

printf x >>"$images/zImage-dtb"
flash 'a damaged image' run --port "$line"
expect_status 1
expect_err 'its checksum differs from SHA256SUMS'
head -c 5300000 /dev/zero >"$images/zImage-dtb"
(cd "$images" && sha256sum zImage-dtb rootfs.ubi >SHA256SUMS)
flash 'a kernel too large' write --dry-run --loader uboot
expect_status 1
expect_err 'larger than its partition'
rm "$images/rootfs.ubi"
flash 'no image' write --dry-run --loader uboot
expect_status 1
expect_err 'rootfs.ubi: this file is missing: run make image'

board_end
check 'no board leaves its chip behind' [ -z "$(ls -A "$chips")" ]

tap_done
