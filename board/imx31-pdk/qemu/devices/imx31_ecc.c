/*
 * The Hamming code that protects 512 bytes of the flash: it corrects one wrong
 * bit and detects two. imx31_pdk.h says what its bits are.
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#include "qemu/osdep.h"
#include "imx31_pdk.h"
#include "qemu/host-utils.h"

#define POSITION_BITS 12
#define CODE_MASK ((1u << 2 * POSITION_BITS) - 1)

/*
 * Bit 2k is the parity of the bits whose position has bit k clear, bit 2k + 1
 * of those where it is set. The position of a bit is its byte's index times 8
 * plus its number in the byte.
 */
static uint32_t parities_of(const uint8_t *part)
{
    unsigned ones = 0, total = 0;
    uint8_t column = 0;
    uint32_t parities = 0;

    for (unsigned i = 0; i < IMX31_NFC_PART; i++) {
        column ^= part[i];
        if (ctpop8(part[i]) & 1) {
            ones ^= i << 3;
            total ^= 1;
        }
    }
    for (unsigned bit = 0; bit < 8; bit++) {
        if (column >> bit & 1) {
            ones ^= bit;
        }
    }
    for (unsigned k = 0; k < POSITION_BITS; k++) {
        unsigned odd = ones >> k & 1;

        parities |= (odd << 1 | (odd ^ total)) << 2 * k;
    }
    return parities;
}

void imx31_ecc_compute(const uint8_t *part, uint8_t *code)
{
    uint32_t stored = ~parities_of(part) & CODE_MASK;

    code[0] = stored;
    code[1] = stored >> 8;
    code[2] = stored >> 16;
}

enum imx31_ecc imx31_ecc_correct(uint8_t *part, const uint8_t *code)
{
    uint32_t stored = code[0] | code[1] << 8 | (uint32_t)code[2] << 16;
    uint32_t apart = (stored ^ ~parities_of(part)) & CODE_MASK;
    uint32_t pairs = (apart ^ apart >> 1) & 0x555555;
    unsigned position = 0;

    if (!apart) {
        return IMX31_ECC_GOOD;
    }
    if (is_power_of_2(apart)) {
        return IMX31_ECC_CORRECTED; /* a bit of the code itself */
    }
    if (pairs != 0x555555) {
        return IMX31_ECC_FAILED;
    }
    for (unsigned k = 0; k < POSITION_BITS; k++) {
        position |= (apart >> (2 * k + 1) & 1) << k;
    }
    part[position >> 3] ^= 1 << (position & 7);
    return IMX31_ECC_CORRECTED;
}
