#!/bin/sh
# cc.sh ARGUMENT...: the compiler with which build.sh builds QEMU. What runs often
# while the board is emulated is optimized: the ARM1136's translation and its
# instructions, memory, clocks, the chip's devices and what they share. The rest
# is not, which halves the time that QEMU takes to build.
set -eu

object=
before=
for word in "$@"; do
    [ "$before" != -o ] || object=$word
    before=$word
done

# That a precompiled header is for other files is not worth a warning.
set -- "$@" -Wno-invalid-pch

case $object in
# Instructions of newer processors.
*/target_arm_*mve*.o | */target_arm_*neon*.o | */target_arm_vec_helper*.o | \
    */target_arm_crypto_helper*.o | */target_arm_iwmmxt_helper*.o | \
    */target_arm_m_helper*.o | */target_arm_translate-m-nocp*.o | \
    */accel_tcg_tcg-runtime-gvec*.o | */hw_intc_armv7m*.o) ;;
*/target_arm_* | */tcg_* | */accel_tcg_* | */fpu_* | */plugins_* | \
    */softmmu_* | */cpu*.o | */qom_* | */hw_arm_* | */hw_core_* | \
    */hw_char_* | */hw_gpio_* | */hw_intc_* | */hw_misc_* | */hw_timer_* | */util_*)
    exec cc "$@"
    ;;
esac
case $object in
*.c.o) exec cc "$@" -O0 -U_FORTIFY_SOURCE ;;
esac
exec cc "$@"
