/*
 * The part of RedBoot that starts Linux from the flash. Its command line and its
 * network are not modelled here; tests/flash simulates them for flash.sh.
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#include "qemu/osdep.h"
#include "exec/address-spaces.h"
#include "imx31_pdk.h"
#include "qemu/bswap.h"
#include "qemu/error-report.h"

#define KERNEL_PAGE (0x100000 / PDK_NAND_PAGE)
#define KERNEL_END_PAGE (0x600000 / PDK_NAND_PAGE)
#define KERNEL_AT 0x100000
#define TAGS_AT 0x100

#define ZIMAGE_MAGIC_AT 0x24
#define ZIMAGE_MAGIC 0x016f2818
#define TREE_MAGIC 0xd00dfeed

#define TAG_CORE 0x54410001
#define TAG_MEMORY 0x54410002
#define TAG_COMMAND_LINE 0x54410009

/*
 * Reads and corrects the main bytes of a page. Returns false if the page has an
 * error that cannot be corrected.
 */
static bool read_page(PDKNandState *nand, unsigned page, uint8_t *out)
{
    uint8_t raw[PDK_NAND_RAW];
    bool good = pdk_nand_load_page(nand, page, raw);

    for (unsigned i = 0; i < IMX31_NFC_PARTS; i++) {
        uint8_t *part = raw + i * (IMX31_NFC_PART + IMX31_NFC_SPARE);

        good &= imx31_ecc_correct(part, part + IMX31_NFC_PART +
                                  IMX31_NFC_ECC_AT) != IMX31_ECC_FAILED;
        memcpy(out + i * IMX31_NFC_PART, part, IMX31_NFC_PART);
    }
    return good;
}

/*
 * Whether the block that begins at the page is marked bad. The mark is the first
 * spare byte that the controller fetches.
 */
static bool is_bad(PDKNandState *nand, unsigned page)
{
    uint8_t raw[PDK_NAND_RAW];

    pdk_nand_load_page(nand, page, raw);
    return raw[IMX31_NFC_PART] != 0xff;
}

/*
 * The length in bytes of a zImage and the device tree behind it, or 0 if there is
 * no zImage or it exceeds limit.
 */
static uint32_t length_of(const uint8_t *image, uint32_t limit)
{
    uint32_t length = ldl_le_p(image + ZIMAGE_MAGIC_AT + 8) -
                      ldl_le_p(image + ZIMAGE_MAGIC_AT + 4);

    if (ldl_le_p(image + ZIMAGE_MAGIC_AT) != ZIMAGE_MAGIC ||
        length > limit - 8) {
        return 0;
    }
    if (ldl_be_p(image + length) == TREE_MAGIC) {
        length += ldl_be_p(image + length + 4);
    }
    return length <= limit ? length : 0;
}

static uint8_t *put(uint8_t *at, uint32_t value)
{
    stl_le_p(at, value);
    return at + 4;
}

static void write_tags(hwaddr at, hwaddr memory, uint64_t memory_bytes,
                       const char *command_line)
{
    uint32_t words = (strlen(command_line) + 4) / 4;
    uint32_t bytes = (2 + 4 + 2 + words + 2) * 4;
    g_autofree uint8_t *tags = g_malloc0(bytes);
    uint8_t *p = tags;

    p = put(put(p, 2), TAG_CORE);
    p = put(put(put(put(p, 4), TAG_MEMORY), memory_bytes), memory);
    p = put(put(p, 2 + words), TAG_COMMAND_LINE);
    memcpy(p, command_line, strlen(command_line));
    cpu_physical_memory_write(at, tags, bytes);
}

hwaddr redboot_load_kernel(PDKNandState *nand, hwaddr memory,
                           uint64_t memory_bytes, const char *command_line)
{
    uint32_t limit = (KERNEL_END_PAGE - KERNEL_PAGE) * PDK_NAND_PAGE;
    g_autofree uint8_t *image = g_malloc(limit + 8);
    uint32_t length, filled = 0, failed_at = limit;

    memset(image, 0xff, limit + 8);
    for (unsigned page = KERNEL_PAGE; page < KERNEL_END_PAGE; page++) {
        if (page % PDK_NAND_BLOCK_PAGES == 0 && is_bad(nand, page)) {
            page += PDK_NAND_BLOCK_PAGES - 1;
            continue;
        }
        if (!read_page(nand, page, image + filled)) {
            failed_at = MIN(failed_at, filled);
        }
        filled += PDK_NAND_PAGE;
    }
    length = length_of(image, limit);
    if (!length) {
        error_report("RedBoot: the flash has no kernel at 1 MiB");
        return 0;
    }
    if (failed_at < length) {
        error_report("RedBoot: the kernel in the flash is damaged at 0x%x",
                     failed_at);
        return 0;
    }
    cpu_physical_memory_write(memory + KERNEL_AT, image, length);
    write_tags(memory + TAGS_AT, memory, memory_bytes, command_line);
    return memory + KERNEL_AT;
}
