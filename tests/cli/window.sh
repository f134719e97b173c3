#!/bin/sh
# Tests limber play in a window, on a virtual desktop and without a desktop.
. "$(dirname "$0")/../support/cli.sh"

limber play "$slider" --display window --frames 1
if grep -q 'no such display' "$err_file"; then
    skip_all 'this target has no window'
fi
expect_status 1
expect_err '^limber: --display window: .*(DISPLAY|desktop)'
if [ -e /dev/fb0 ] || [ -e /dev/dri/card0 ]; then
    skip 'limber without a screen' 'this machine has a screen'
else
    limber "$slider" --frames 1 --size 33x17
    expect_status 1
    expect_err '^limber: --display: .*window'
    limber "$slider" --display fbdev --frames 1
    expect_refusal 1 '/dev/fb0: this machine has no such framebuffer'
fi
limber "$slider" --display kms:/dev/null --frames 1
expect_refusal 1 '/dev/null: '
limber "$slider" --display fbdev:/dev/null --frames 1
expect_refusal 1 '/dev/null: does not answer as a framebuffer'

DISPLAY=:59000 limber "$slider" --display window --frames 1
expect_refusal 1 'there is no desktop|the desktop that .* names does not answer'

# Where SDL's library is missing: the loader takes this file for it.
mkdir "$scratch/broken"
: >"$scratch/broken/libSDL2-2.0.so.0"
for command in "play $slider --display window --frames 1" doctor; do
    # shellcheck disable=SC2086 # a command and its arguments
    SDL_VIDEODRIVER=dummy LD_LIBRARY_PATH=$scratch/broken limber $command
    expect_status 1
    cat "$out_file" >>"$err_file"
    expect_err 'there is no libSDL2-2\.0\.so\.0 on this machine .*'
    expect_err 'install .*libsdl2-2\.0-0'
done
if [ -e /dev/fb0 ] || [ -e /dev/dri/card0 ]; then
    skip 'limber without SDL and without a screen' 'this machine has a screen'
else
    SDL_VIDEODRIVER=dummy LD_LIBRARY_PATH=$scratch/broken limber "$slider" --frames 1
    expect_status 1
    expect_err '^limber: --display: found no screen '
fi
SDL_VIDEODRIVER=dummy limber play "$slider" --display window --frames 2
expect_status 0
expect_no_err
# What shows nothing opens no library of the desktop.
LD_LIBRARY_PATH=$scratch/broken limber play "$slider" --display null --frames 2
expect_status 0
expect_no_err

mkfifo "$scratch/number"
Xvfb -displayfd 3 -screen 0 800x600x24 -noreset -nolisten tcp \
    3>"$scratch/number" >"$scratch/xvfb.log" 2>&1 &
server=$!
trap 'kill $server; rm -rf "$tap_folder"' EXIT
read -r number <"$scratch/number"
DISPLAY=:$number
export DISPLAY

limber play "$slider" --frames 3
expect_status 0
expect_no_err
expect_out 'UP +play the previous clip'
expect_out 'quit \(Esc in a window\)'
limber "$slider" --frames 3 --size 320x240 --clip rise
expect_status 0
expect_no_err
limber play "$slider" --display window --frames 2 --gl osmesa
expect_status 0
expect_no_err

# --display egl: the window is the root window of the X server.
root=$(xwininfo -root | sed -n 's/.*Window id: \(0x[0-9a-f]*\).*/\1/p')
limber play "$slider" --display "egl:$root" --frames 3 --script /dev/null
expect_status 0
expect_no_err
limber play "$slider" --display "egl:$root" --frames 3 --script /dev/null --gl gles1 \
    --format rgba8888
expect_status 0
expect_no_err
limber play "$slider" --display egl --frames 3
expect_status 1
expect_err '^limber: --display egl: .*window 0 .*egl:NUMBER'

# Ctrl-C ends it.
# shellcheck disable=SC2086 # a command and its arguments
run timeout -s INT 1 $limber play "$slider"
about 'limber play until Ctrl-C'
check "$tap_about: it ends" test "$status" -ne 137
tap_done
