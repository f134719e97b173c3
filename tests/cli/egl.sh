#!/bin/sh
# Tests limber play on the screen of a vendor's EGL. tests/fake_gles stands in for
# the vendor's libraries: it draws nothing and logs every call.
. "$(dirname "$0")/../support/cli.sh"

# The libraries are beside the unit tests of the same build.
fake=$(dirname "${limber##* }")/unit/fake_gles.so
if [ ! -e "$fake" ]; then
    fail 'the fake EGL library exists' "$fake is missing: make check-build"
    tap_done
fi
FAKE_GLES_LOG=$scratch/calls
export FAKE_GLES_LOG

limber play "$slider" --script /dev/null --display egl --frames 3 --egl-library "$fake" \
    --gles-library "$fake"
expect_status 0
expect_no_err
check 'three frames are shown' \
    test "$(grep -c SwapBuffers "$FAKE_GLES_LOG")" -eq 3
check 'the whole screen is used' grep -q '^CreateWindowSurface .* window 0x0$' \
    "$FAKE_GLES_LOG"
check 'nothing is read back' sh -c '! grep -q ReadPixels "$1"' sh \
    "$FAKE_GLES_LOG"
check 'everything that was created is destroyed' \
    test "$(grep -c '^Destroy' "$FAKE_GLES_LOG")" -eq 2

rm "$FAKE_GLES_LOG"
LIMBER_EGL=$fake LIMBER_GLES=$fake
export LIMBER_EGL LIMBER_GLES
limber play "$slider" --script /dev/null --display egl:0x42 --frames 1 --format rgba8888
expect_status 0
expect_no_err
check 'the given window is used' grep -q \
    '^CreateWindowSurface config 1 window 0x42$' "$FAKE_GLES_LOG"
limber play "$slider" --display egl:front --frames 1
expect_refusal 2 'egl:front: give'
limber play "$slider" --display egl --frames 1 --egl-library "$scratch/none.so"
expect_refusal 1 'none\.so'
tap_done
