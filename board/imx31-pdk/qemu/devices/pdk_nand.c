/*
 * The PDK's NAND chip: 256 MiB, 2048 blocks of 64 pages of 2048 and 64 bytes,
 * behind eight data lines (as Micron's MT29F2G08).
 *
 * Its file (-drive if=mtd,format=raw) has the raw pages one after the other, and
 * each bit of it is the complement of the chip's: an empty sparse file of
 * 131072 * 2112 bytes is an erased chip.
 *
 * QEMU's own NAND model is not used because it never fails. Here an erase or a
 * program fails in the blocks of the property "worn-blocks". Setting "power-cut"
 * to N ends the machine in the middle of the N-th erase or program from then on;
 * a random half of its bits stay as they were.
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#include "qemu/osdep.h"
#include "hw/qdev-properties-system.h"
#include "hw/qdev-properties.h"
#include "imx31_pdk.h"
#include "migration/vmstate.h"
#include "qapi/error.h"
#include "qapi/qapi-types-run-state.h"
#include "qemu/bitmap.h"
#include "qemu/cutils.h"
#include "qemu/module.h"
#include "qemu/timer.h"
#include "sysemu/block-backend.h"
#include "sysemu/runstate.h"
#include "trace.h"

enum {
    COMMAND_READ = 0x00,
    COMMAND_PROGRAM = 0x10,
    COMMAND_READ_START = 0x30,
    COMMAND_ERASE = 0x60,
    COMMAND_STATUS = 0x70,
    COMMAND_INPUT = 0x80,
    COMMAND_ID = 0x90,
    COMMAND_ERASE_START = 0xd0,
    COMMAND_RESET = 0xff,
};

#define STATUS_FAILED (1 << 0)
#define STATUS_READY (1 << 6 | 1 << 5)
#define STATUS_UNPROTECTED (1 << 7)

#define ADDRESS_BYTES 5
#define COLUMN_BYTES 2
#define BLOCKS (PDK_NAND_PAGES / PDK_NAND_BLOCK_PAGES)

#define READ_NS (25 * SCALE_US)
#define PROGRAM_NS (200 * SCALE_US)
#define ERASE_NS (2 * SCALE_MS)

static const uint8_t id[] = { 0x2c, 0xda, 0x80, 0x95, 0x50 };

struct PDKNandState {
    DeviceState parent_obj;

    BlockBackend *blk;
    uint8_t page[PDK_NAND_RAW]; /* the page register */
    uint8_t address[ADDRESS_BYTES];
    uint8_t cycles; /* the bytes of the address so far */
    uint8_t command;
    uint8_t status;
    uint32_t at; /* the next byte of the page register or of id[] */
    uint32_t power_cut; /* erases and programs until the cut; 0: no cut */
    int64_t busy_ns;
    unsigned long worn[BITS_TO_LONGS(BLOCKS)];
};

static unsigned row_of(const PDKNandState *s)
{
    const uint8_t *row = s->command == COMMAND_ERASE ||
                         s->command == COMMAND_ERASE_START
        ? s->address : s->address + COLUMN_BYTES;

    return (row[0] | row[1] << 8 | row[2] << 16) % PDK_NAND_PAGES;
}

static void complement(uint8_t *bytes, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        bytes[i] = ~bytes[i];
    }
}

static bool store(PDKNandState *s, unsigned page, const uint8_t *raw)
{
    uint8_t bytes[PDK_NAND_RAW];

    memcpy(bytes, raw, sizeof(bytes));
    complement(bytes, sizeof(bytes));
    return !s->blk || blk_pwrite(s->blk, (int64_t)page * PDK_NAND_RAW,
                                 sizeof(bytes), bytes, 0) >= 0;
}

bool pdk_nand_load_page(PDKNandState *s, unsigned page, uint8_t *raw)
{
    if (page >= PDK_NAND_PAGES || !s->blk ||
        blk_pread(s->blk, (int64_t)page * PDK_NAND_RAW, PDK_NAND_RAW, raw,
                  0) < 0) {
        memset(raw, 0xff, PDK_NAND_RAW);
        return false;
    }
    complement(raw, PDK_NAND_RAW);
    return true;
}

/* Counts an operation. Ends QEMU and returns true if the power is cut in it. */
static bool power_goes(PDKNandState *s)
{
    if (s->power_cut == 0 || --s->power_cut > 0) {
        return false;
    }
    qemu_system_shutdown_request(SHUTDOWN_CAUSE_HOST_ERROR);
    return true;
}

/* Sets the bits of a page that an operation changes: all, or a random half. */
static void choose_bits(unsigned page, bool half, uint8_t *mask)
{
    GRand *chance = g_rand_new_with_seed(page);

    for (unsigned i = 0; i < PDK_NAND_RAW; i++) {
        mask[i] = half ? g_rand_int(chance) : 0xff;
    }
    g_rand_free(chance);
}

static void program(PDKNandState *s)
{
    unsigned page = row_of(s);
    bool failed = test_bit(page / PDK_NAND_BLOCK_PAGES, s->worn);
    uint8_t raw[PDK_NAND_RAW], mask[PDK_NAND_RAW];

    choose_bits(page, power_goes(s) || failed, mask);
    pdk_nand_load_page(s, page, raw);
    for (unsigned i = 0; i < PDK_NAND_RAW; i++) {
        raw[i] &= s->page[i] | ~mask[i];
    }
    failed |= !store(s, page, raw);
    s->status = failed ? STATUS_FAILED : 0;
    s->busy_ns = PROGRAM_NS;
    trace_pdk_nand_program(page, failed);
}

/* A random half of the bits of a block's pages become ones. */
static void erase_half(PDKNandState *s, unsigned first)
{
    uint8_t raw[PDK_NAND_RAW], mask[PDK_NAND_RAW];

    for (unsigned page = first; page < first + PDK_NAND_BLOCK_PAGES; page++) {
        choose_bits(page, true, mask);
        pdk_nand_load_page(s, page, raw);
        for (unsigned i = 0; i < PDK_NAND_RAW; i++) {
            raw[i] |= mask[i];
        }
        store(s, page, raw);
    }
}

static void erase(PDKNandState *s)
{
    unsigned block = row_of(s) / PDK_NAND_BLOCK_PAGES;
    bool failed = test_bit(block, s->worn);

    if (power_goes(s)) {
        erase_half(s, block * PDK_NAND_BLOCK_PAGES);
    } else if (!failed && s->blk) {
        failed = blk_pwrite_zeroes(
            s->blk, (int64_t)block * PDK_NAND_BLOCK_PAGES * PDK_NAND_RAW,
            PDK_NAND_BLOCK_PAGES * PDK_NAND_RAW, BDRV_REQ_MAY_UNMAP) < 0;
    }
    s->status = failed ? STATUS_FAILED : 0;
    s->busy_ns = ERASE_NS;
    trace_pdk_nand_erase(block, failed);
}

void pdk_nand_command(PDKNandState *s, uint8_t command)
{
    s->busy_ns = 0;
    switch (command) {
    case COMMAND_READ_START:
        pdk_nand_load_page(s, row_of(s), s->page);
        s->at = s->address[0] | s->address[1] << 8;
        s->busy_ns = READ_NS;
        break;
    case COMMAND_PROGRAM:
        program(s);
        break;
    case COMMAND_ERASE_START:
        s->command = command;
        erase(s);
        break;
    case COMMAND_STATUS:
        break;
    case COMMAND_RESET:
        s->status = 0;
        s->cycles = 0;
        break;
    case COMMAND_INPUT:
        memset(s->page, 0xff, sizeof(s->page));
        /* fall through */
    default:
        s->cycles = 0;
        s->at = 0;
    }
    s->command = command;
}

void pdk_nand_address(PDKNandState *s, uint8_t byte)
{
    /* The driver sends an address after the program command; it means nothing. */
    if (s->command == COMMAND_PROGRAM) {
        return;
    }
    if (s->cycles < ADDRESS_BYTES) {
        s->address[s->cycles++] = byte;
    }
    if (s->command == COMMAND_INPUT && s->cycles == COLUMN_BYTES) {
        s->at = s->address[0] | s->address[1] << 8;
    }
}

void pdk_nand_read(PDKNandState *s, uint8_t *bytes, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        if (s->command == COMMAND_STATUS) {
            bytes[i] = s->status | STATUS_READY | STATUS_UNPROTECTED;
        } else if (s->command == COMMAND_ID) {
            bytes[i] = s->at < sizeof(id) ? id[s->at++] : 0;
        } else {
            bytes[i] = s->at < sizeof(s->page) ? s->page[s->at++] : 0xff;
        }
    }
}

void pdk_nand_write(PDKNandState *s, const uint8_t *bytes, unsigned count)
{
    if (s->command != COMMAND_INPUT) {
        return;
    }
    for (unsigned i = 0; i < count && s->at < sizeof(s->page); i++) {
        s->page[s->at++] = bytes[i];
    }
}

int64_t pdk_nand_busy_ns(const PDKNandState *s)
{
    return s->busy_ns;
}

static char *pdk_nand_get_worn(Object *obj, Error **errp)
{
    PDKNandState *s = PDK_NAND(obj);
    GString *text = g_string_new(NULL);

    for (unsigned i = 0; i < BLOCKS; i++) {
        if (test_bit(i, s->worn)) {
            g_string_append_printf(text, "%s%u", text->len ? " " : "", i);
        }
    }
    return g_string_free(text, false);
}

static void pdk_nand_set_worn(Object *obj, const char *value, Error **errp)
{
    PDKNandState *s = PDK_NAND(obj);
    g_auto(GStrv) words = g_strsplit(value, " ", -1);
    unsigned long worn[BITS_TO_LONGS(BLOCKS)] = { 0 };
    unsigned block;

    for (char **word = words; *word; word++) {
        if (!**word) {
            continue;
        }
        if (qemu_strtoui(*word, NULL, 10, &block) || block >= BLOCKS) {
            error_setg(errp, "block %s: give numbers from 0 to %u", *word,
                       BLOCKS - 1);
            return;
        }
        set_bit(block, worn);
    }
    memcpy(s->worn, worn, sizeof(worn));
}

static void pdk_nand_realize(DeviceState *dev, Error **errp)
{
    PDKNandState *s = PDK_NAND(dev);
    int64_t wanted = (int64_t)PDK_NAND_PAGES * PDK_NAND_RAW;

    if (!s->blk) {
        return;
    }
    if (blk_getlength(s->blk) < wanted) {
        error_setg(errp, "the NAND's file needs %" PRId64 " bytes", wanted);
        return;
    }
    blk_set_perm(s->blk, BLK_PERM_CONSISTENT_READ | BLK_PERM_WRITE,
                 BLK_PERM_ALL, errp);
}

static void pdk_nand_reset(DeviceState *dev)
{
    PDKNandState *s = PDK_NAND(dev);

    s->command = COMMAND_RESET;
    s->status = 0;
    s->cycles = 0;
    s->at = 0;
    s->busy_ns = 0;
}

static void pdk_nand_init(Object *obj)
{
    PDKNandState *s = PDK_NAND(obj);

    object_property_add_str(obj, "worn-blocks", pdk_nand_get_worn,
                            pdk_nand_set_worn);
    object_property_add_uint32_ptr(obj, "power-cut", &s->power_cut,
                                   OBJ_PROP_FLAG_READWRITE);
}

static const VMStateDescription vmstate_pdk_nand = {
    .name = TYPE_PDK_NAND,
    .version_id = 1,
    .minimum_version_id = 1,
    .fields = (VMStateField[]) {
        VMSTATE_UINT8_ARRAY(page, PDKNandState, PDK_NAND_RAW),
        VMSTATE_UINT8_ARRAY(address, PDKNandState, ADDRESS_BYTES),
        VMSTATE_UINT8(cycles, PDKNandState),
        VMSTATE_UINT8(command, PDKNandState),
        VMSTATE_UINT8(status, PDKNandState),
        VMSTATE_UINT32(at, PDKNandState),
        VMSTATE_UINT32(power_cut, PDKNandState),
        VMSTATE_INT64(busy_ns, PDKNandState),
        VMSTATE_END_OF_LIST()
    },
};

static Property pdk_nand_properties[] = {
    DEFINE_PROP_DRIVE("drive", PDKNandState, blk),
    DEFINE_PROP_END_OF_LIST(),
};

static void pdk_nand_class_init(ObjectClass *klass, void *data)
{
    DeviceClass *dc = DEVICE_CLASS(klass);

    dc->realize = pdk_nand_realize;
    dc->reset = pdk_nand_reset;
    dc->vmsd = &vmstate_pdk_nand;
    dc->desc = "NAND chip of the i.MX31 PDK";
    dc->user_creatable = false;
    device_class_set_props(dc, pdk_nand_properties);
}

static const TypeInfo pdk_nand_info = {
    .name = TYPE_PDK_NAND,
    .parent = TYPE_DEVICE,
    .instance_size = sizeof(PDKNandState),
    .instance_init = pdk_nand_init,
    .class_init = pdk_nand_class_init,
};

static void pdk_nand_register_types(void)
{
    type_register_static(&pdk_nand_info);
}

type_init(pdk_nand_register_types)
