/*
 * The i.MX31's NAND flash controller (NFC version 1).
 *
 * Its buffer has four parts of 512 bytes and four of 16 spare bytes. The chip
 * gets the parts of a page one after the other, each with its spare bytes behind
 * it; so the byte that a maker marks bad blocks with (2048 of the page) lies in
 * the fourth part's data. With error correction on, the controller writes three
 * bytes of code into the spare bytes 6 to 8 of a part that it sends, and checks
 * and corrects the main bytes of a part that it fetches. The code itself is
 * ours (imx31_ecc.c), and the spare bytes have none: the reference manual does
 * not describe either to the bit.
 *
 * Registers as in Linux' mxc_nand.c and the reference manual's chapter "NFC".
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#include "qemu/osdep.h"
#include "hw/irq.h"
#include "hw/qdev-properties.h"
#include "imx31_pdk.h"
#include "migration/vmstate.h"
#include "qemu/module.h"
#include "qemu/timer.h"
#include "trace.h"

#define BUFFER_BYTES 0x840
#define SPARE_AT 0x800
#define REGISTERS_AT 0xe00
#define REGISTERS (0x20 / 2)

enum {
    BUFFER_ADDRESS = 0x04 / 2,
    FLASH_ADDRESS = 0x06 / 2,
    FLASH_COMMAND = 0x08 / 2,
    CONFIG = 0x0a / 2,
    ECC_STATUS = 0x0c / 2,
    WRITE_PROTECT = 0x12 / 2,
    CONFIG_1 = 0x1a / 2,
    CONFIG_2 = 0x1c / 2,
};

#define CONFIG_1_ECC_EN (1 << 3)
#define CONFIG_1_INT_MSK (1 << 4)
#define CONFIG_2_INT (1 << 15)
#define WRITE_PROTECT_UNLOCK 4

enum {
    OPERATION_COMMAND = 1 << 0,
    OPERATION_ADDRESS = 1 << 1,
    OPERATION_INPUT = 1 << 2,
    OPERATION_OUTPUT = 1 << 3,
    OPERATION_ID = 2 << 3,
    OPERATION_STATUS = 4 << 3,
    OPERATIONS = 0x3f,
};

#define COMMAND_PROGRAM 0x10
#define COMMAND_ERASE_START 0xd0
#define ID_BYTES 6

/* A cycle on the data lines: two periods of 22 MHz. */
#define CYCLE_NS 90

struct IMX31NFCState {
    SysBusDevice parent_obj;

    MemoryRegion iomem;
    qemu_irq irq;
    QEMUTimer done;
    PDKNandState *nand;
    uint8_t buffer[BUFFER_BYTES];
    uint16_t regs[REGISTERS];
};

static void imx31_nfc_update(IMX31NFCState *s)
{
    qemu_set_irq(s->irq, s->regs[CONFIG_2] & CONFIG_2_INT &&
                         !(s->regs[CONFIG_1] & CONFIG_1_INT_MSK));
}

static void imx31_nfc_done(void *opaque)
{
    IMX31NFCState *s = opaque;

    s->regs[CONFIG_2] = CONFIG_2_INT;
    imx31_nfc_update(s);
}

static uint8_t *main_part(IMX31NFCState *s)
{
    return s->buffer + (s->regs[BUFFER_ADDRESS] & 3) * IMX31_NFC_PART;
}

static uint8_t *spare_part(IMX31NFCState *s)
{
    return s->buffer + SPARE_AT +
           (s->regs[BUFFER_ADDRESS] & 3) * IMX31_NFC_SPARE;
}

static bool is_correcting(const IMX31NFCState *s)
{
    return s->regs[CONFIG_1] & CONFIG_1_ECC_EN;
}

static void send_part(IMX31NFCState *s)
{
    if (is_correcting(s)) {
        imx31_ecc_compute(main_part(s), spare_part(s) + IMX31_NFC_ECC_AT);
    }
    pdk_nand_write(s->nand, main_part(s), IMX31_NFC_PART);
    pdk_nand_write(s->nand, spare_part(s), IMX31_NFC_SPARE);
}

static void fetch_part(IMX31NFCState *s)
{
    enum imx31_ecc result = IMX31_ECC_GOOD;

    pdk_nand_read(s->nand, main_part(s), IMX31_NFC_PART);
    pdk_nand_read(s->nand, spare_part(s), IMX31_NFC_SPARE);
    if (is_correcting(s)) {
        result = imx31_ecc_correct(main_part(s),
                                   spare_part(s) + IMX31_NFC_ECC_AT);
    }
    s->regs[ECC_STATUS] = result << 2;
    trace_imx31_nfc_ecc(s->regs[BUFFER_ADDRESS] & 3, result);
}

static int64_t send_command(IMX31NFCState *s)
{
    uint8_t command = s->regs[FLASH_COMMAND];

    if ((command == COMMAND_PROGRAM || command == COMMAND_ERASE_START) &&
        s->regs[WRITE_PROTECT] != WRITE_PROTECT_UNLOCK) {
        imx31_report("NFC: the flash is write-protected, and ignores the "
                     "command 0x%02x", command);
        return CYCLE_NS;
    }
    pdk_nand_command(s->nand, command);
    return CYCLE_NS + pdk_nand_busy_ns(s->nand);
}

/* Carries out an operation; returns how long it takes in nanoseconds. */
static int64_t operate(IMX31NFCState *s, unsigned operation)
{
    switch (operation) {
    case OPERATION_COMMAND:
        return send_command(s);
    case OPERATION_ADDRESS:
        pdk_nand_address(s->nand, s->regs[FLASH_ADDRESS]);
        return CYCLE_NS;
    case OPERATION_INPUT:
        send_part(s);
        return (IMX31_NFC_PART + IMX31_NFC_SPARE) * CYCLE_NS;
    case OPERATION_OUTPUT:
        fetch_part(s);
        return (IMX31_NFC_PART + IMX31_NFC_SPARE) * CYCLE_NS;
    case OPERATION_ID:
        pdk_nand_read(s->nand, main_part(s), ID_BYTES);
        return ID_BYTES * CYCLE_NS;
    case OPERATION_STATUS:
        pdk_nand_read(s->nand, main_part(s), 1);
        return CYCLE_NS;
    default:
        imx31_report("NFC: operation 0x%02x does not exist", operation);
        return CYCLE_NS;
    }
}

static void write_config_2(IMX31NFCState *s, uint16_t value)
{
    unsigned operation = value & OPERATIONS;

    s->regs[CONFIG_2] = value;
    if (operation) {
        trace_imx31_nfc_operation(operation, operation == OPERATION_ADDRESS
                                  ? s->regs[FLASH_ADDRESS]
                                  : s->regs[FLASH_COMMAND]);
        timer_mod(&s->done, qemu_clock_get_ns(QEMU_CLOCK_VIRTUAL) +
                  operate(s, operation));
    }
}

static uint64_t imx31_nfc_read(void *opaque, hwaddr offset, unsigned size)
{
    IMX31NFCState *s = opaque;

    if (offset + size <= BUFFER_BYTES) {
        return ldn_le_p(s->buffer + offset, size);
    }
    if (offset < REGISTERS_AT || offset - REGISTERS_AT >= REGISTERS * 2 ||
        size != 2) {
        return 0;
    }
    return s->regs[(offset - REGISTERS_AT) / 2];
}

static void imx31_nfc_write(void *opaque, hwaddr offset, uint64_t value,
                            unsigned size)
{
    IMX31NFCState *s = opaque;
    unsigned number = (offset - REGISTERS_AT) / 2;

    if (offset + size <= BUFFER_BYTES) {
        stn_le_p(s->buffer + offset, size, value);
        return;
    }
    if (offset < REGISTERS_AT || number >= REGISTERS || size != 2) {
        imx31_report("NFC: no register at 0x%03" HWADDR_PRIx, offset);
        return;
    }
    if (number == CONFIG_2) {
        write_config_2(s, value);
    } else if (number != ECC_STATUS) {
        s->regs[number] = value;
    }
    imx31_nfc_update(s);
}

static const MemoryRegionOps imx31_nfc_ops = {
    .read = imx31_nfc_read,
    .write = imx31_nfc_write,
    .endianness = DEVICE_LITTLE_ENDIAN,
    .valid = { .min_access_size = 1, .max_access_size = 4 },
};

static void imx31_nfc_reset(DeviceState *dev)
{
    IMX31NFCState *s = IMX31_NFC(dev);

    memset(s->buffer, 0xff, sizeof(s->buffer));
    memset(s->regs, 0, sizeof(s->regs));
    s->regs[CONFIG] = 3;
    s->regs[WRITE_PROTECT] = 2;
    s->regs[CONFIG_1] = CONFIG_1_ECC_EN;
    timer_del(&s->done);
    imx31_nfc_update(s);
}

static void imx31_nfc_init(Object *obj)
{
    IMX31NFCState *s = IMX31_NFC(obj);

    memory_region_init_io(&s->iomem, obj, &imx31_nfc_ops, s, TYPE_IMX31_NFC,
                          0x1000);
    sysbus_init_mmio(SYS_BUS_DEVICE(obj), &s->iomem);
    sysbus_init_irq(SYS_BUS_DEVICE(obj), &s->irq);
    timer_init_ns(&s->done, QEMU_CLOCK_VIRTUAL, imx31_nfc_done, s);
}

static const VMStateDescription vmstate_imx31_nfc = {
    .name = TYPE_IMX31_NFC,
    .version_id = 1,
    .minimum_version_id = 1,
    .fields = (VMStateField[]) {
        VMSTATE_TIMER(done, IMX31NFCState),
        VMSTATE_UINT8_ARRAY(buffer, IMX31NFCState, BUFFER_BYTES),
        VMSTATE_UINT16_ARRAY(regs, IMX31NFCState, REGISTERS),
        VMSTATE_END_OF_LIST()
    },
};

static Property imx31_nfc_properties[] = {
    DEFINE_PROP_LINK("nand", IMX31NFCState, nand, TYPE_PDK_NAND,
                     PDKNandState *),
    DEFINE_PROP_END_OF_LIST(),
};

static void imx31_nfc_class_init(ObjectClass *klass, void *data)
{
    DeviceClass *dc = DEVICE_CLASS(klass);

    dc->reset = imx31_nfc_reset;
    dc->vmsd = &vmstate_imx31_nfc;
    dc->desc = "i.MX31 NAND flash controller";
    device_class_set_props(dc, imx31_nfc_properties);
}

static const TypeInfo imx31_nfc_info = {
    .name = TYPE_IMX31_NFC,
    .parent = TYPE_SYS_BUS_DEVICE,
    .instance_size = sizeof(IMX31NFCState),
    .instance_init = imx31_nfc_init,
    .class_init = imx31_nfc_class_init,
};

static void imx31_nfc_register_types(void)
{
    type_register_static(&imx31_nfc_info);
}

type_init(imx31_nfc_register_types)
