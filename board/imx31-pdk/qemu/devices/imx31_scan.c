/*
 * How the i.MX31's IPU reads a picture from memory: decodes the picture's place
 * and format from the channel parameter memory, reads its rows, and notices
 * whether the processor writes there meanwhile.
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#include "qemu/osdep.h"
#include "exec/address-spaces.h"
#include "exec/ram_addr.h"
#include "imx31_pdk.h"

struct imx31_scan imx31_scan_of(const uint32_t *words, unsigned buffer)
{
    static const uint8_t bytes_of_bpp[8] = { 4, 3, 2, 0, 0, 0, 0, 0 };
    uint32_t format = words[10], fields = words[11];
    bool is_rgb = extract32(format, 17, 3) == 4;
    struct imx31_scan scan = {
        .address = words[8 + buffer],
        .width = extract32(words[3], 12, 12) + 1,
        .height = (extract32(words[3], 24, 8) |
                   extract32(words[4], 0, 4) << 8) + 1,
        .stride = extract32(format, 3, 14) + 1,
        .bytes = is_rgb ? bytes_of_bpp[format & 7] : 0,
        .offset = { extract32(fields, 3, 5), extract32(fields, 8, 5),
                    extract32(fields, 13, 5) },
        .bits = { extract32(fields, 23, 3) + 1, extract32(fields, 26, 3) + 1,
                  extract32(fields, 29, 3) + 1 },
    };

    scan.is_565 = scan.bytes == 2 && scan.offset[0] == 0 &&
        scan.offset[1] == 5 && scan.offset[2] == 11 &&
        scan.bits[0] == 5 && scan.bits[1] == 6 && scan.bits[2] == 5;
    return scan;
}

/* Returns channel i of the pixel, scaled to that many bits. */
static unsigned channel_of(const struct imx31_scan *scan, uint32_t pixel, unsigned i,
                           unsigned bits)
{
    unsigned shift = scan->bytes * 8 - scan->offset[i] - scan->bits[i];
    uint32_t value = shift < 32 ? extract32(pixel, shift, scan->bits[i]) : 0;

    return scan->bits[i] > bits ? value >> (scan->bits[i] - bits)
                                : value << (bits - scan->bits[i]);
}

static void convert_row(const struct imx31_scan *scan, const uint8_t *bytes,
                        uint16_t *out, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        const uint8_t *p = bytes + i * scan->bytes;
        uint32_t pixel = scan->bytes == 4 ? ldl_le_p(p) : lduw_le_p(p);

        if (scan->bytes == 3) {
            pixel |= p[2] << 16;
        }
        out[i] = scan->is_565 ? pixel
                              : channel_of(scan, pixel, 0, 5) << 11 |
                                channel_of(scan, pixel, 1, 6) << 5 |
                                channel_of(scan, pixel, 2, 5);
    }
}

unsigned imx31_scan_read(const struct imx31_scan *scan, uint32_t line,
                         uint16_t *pixels)
{
    uint8_t bytes[IMX31_SCAN_MAX * 4];
    unsigned count = MIN(scan->width, IMX31_SCAN_MAX);

    if (address_space_read(&address_space_memory,
                           scan->address + line * scan->stride,
                           MEMTXATTRS_UNSPECIFIED, bytes,
                           count * scan->bytes) != MEMTX_OK) {
        memset(bytes, 0, count * scan->bytes);
    }
    convert_row(scan, bytes, pixels, count);
    return count;
}

/* Returns the section of memory that the frame is fetched from. */
static MemoryRegionSection watched(const struct imx31_scan *scan)
{
    return memory_region_find(get_system_memory(), scan->address,
                              (uint64_t)scan->stride * scan->height);
}

void imx31_scan_watch(const struct imx31_scan *scan)
{
    MemoryRegionSection section = watched(scan);

    if (!section.mr) {
        return;
    }
    if (memory_region_is_ram(section.mr)) {
        if (!(memory_region_get_dirty_log_mask(section.mr) &
              1 << DIRTY_MEMORY_VGA)) {
            memory_region_set_log(section.mr, true, DIRTY_MEMORY_VGA);
        }
        memory_region_reset_dirty(section.mr, section.offset_within_region,
                                  int128_get64(section.size),
                                  DIRTY_MEMORY_VGA);
    }
    memory_region_unref(section.mr);
}

bool imx31_scan_was_written(const struct imx31_scan *scan)
{
    MemoryRegionSection section = watched(scan);
    bool written = false;

    if (!section.mr) {
        return false;
    }
    if (memory_region_is_ram(section.mr)) {
        DirtyBitmapSnapshot *snapshot =
            memory_region_snapshot_and_clear_dirty(
                section.mr, section.offset_within_region,
                int128_get64(section.size), DIRTY_MEMORY_VGA);

        written = memory_region_snapshot_get_dirty(
            section.mr, snapshot, section.offset_within_region,
            int128_get64(section.size));
        g_free(snapshot);
    }
    memory_region_unref(section.mr);
    return written;
}
