/*
 * Freescale's MC13783: the PDK's power chip, with 64 registers of 24 bits behind
 * a serial interface. A transfer has four bytes: 0x80 for a write, the register's
 * number times two, and its value from the highest byte on.
 *
 * Modelled are the registers, the interrupts with their masks, the power button
 * ONOFD1 and the two regulators that supply the panel. Numbers and bits as in
 * Linux' mc13xxx-core.c and mc13783-regulator.c.
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#include "qemu/osdep.h"
#include "hw/irq.h"
#include "hw/ssi/ssi.h"
#include "imx31_pdk.h"
#include "migration/vmstate.h"
#include "qemu/module.h"
#include "trace.h"

enum {
    IRQ_STATUS_0 = 0,
    IRQ_MASK_0 = 1,
    IRQ_STATUS_1 = 3,
    IRQ_MASK_1 = 4,
    IRQ_SENSE_1 = 5,
    REVISION = 7,
    REGULATOR_SETTING_0 = 30,
    REGULATOR_SETTING_1 = 31,
    REGULATOR_MODE_0 = 32,
    REGULATOR_MODE_1 = 33,
    REGISTERS = 64,
};

#define VALUE_MASK 0xffffff
/* Chip 2 (MC13783), revision 3.1. */
#define REVISION_VALUE (2 << 6 | 3 << 3 | 1)
#define MODE_0_VGEN (1 << 12)
#define MODE_1_VMMC1 (1 << 18)
#define VOLTAGE_AT 6
#define IRQ_1_ONOFD1 (1 << 3)

struct MC13783State {
    SSIPeripheral parent_obj;

    qemu_irq irq;
    uint32_t regs[REGISTERS];
    uint32_t value; /* the bytes of the transfer after the first */
    uint8_t first; /* the first byte of the transfer */
    uint8_t bytes; /* how many bytes the transfer has had so far */
    bool button;
};

static const uint16_t vgen_mv[8] = {
    1200, 1300, 1500, 1800, 1100, 2000, 2775, 2400,
};

static const uint16_t vmmc_mv[8] = {
    1600, 1800, 2000, 2600, 2700, 2800, 2900, 3000,
};

unsigned mc13783_millivolts(const MC13783State *s,
                            enum mc13783_regulator regulator)
{
    if (regulator == MC13783_VGEN) {
        return s->regs[REGULATOR_MODE_0] & MODE_0_VGEN
            ? vgen_mv[s->regs[REGULATOR_SETTING_0] >> VOLTAGE_AT & 7] : 0;
    }
    return s->regs[REGULATOR_MODE_1] & MODE_1_VMMC1
        ? vmmc_mv[s->regs[REGULATOR_SETTING_1] >> VOLTAGE_AT & 7] : 0;
}

static void mc13783_update(MC13783State *s)
{
    qemu_set_irq(s->irq,
                 (s->regs[IRQ_STATUS_0] & ~s->regs[IRQ_MASK_0]) ||
                 (s->regs[IRQ_STATUS_1] & ~s->regs[IRQ_MASK_1]));
}

static void write_register(MC13783State *s, unsigned number, uint32_t value)
{
    trace_mc13783_write(number, value);
    switch (number) {
    case IRQ_STATUS_0:
    case IRQ_STATUS_1:
        s->regs[number] &= ~value;
        break;
    case IRQ_SENSE_1:
    case REVISION:
        break;
    default:
        s->regs[number] = value & VALUE_MASK;
    }
    mc13783_update(s);
}

static uint32_t mc13783_transfer(SSIPeripheral *dev, uint32_t word)
{
    MC13783State *s = MC13783(dev);
    unsigned number = s->first >> 1 & (REGISTERS - 1);
    uint32_t answer;

    if (s->bytes == 0) {
        s->first = word;
        s->bytes = 1;
        s->value = 0;
        return 0;
    }
    answer = s->regs[number] >> (8 * (3 - MIN(s->bytes, 3))) & 0xff;
    s->value = s->value << 8 | (word & 0xff);
    if (s->bytes++ == 3 && s->first & 0x80) {
        write_register(s, number, s->value);
    }
    return answer;
}

/* A transfer begins when the chip is selected. */
static int mc13783_select(SSIPeripheral *dev, bool select)
{
    MC13783State *s = MC13783(dev);

    s->bytes = 0;
    return 0;
}

static bool mc13783_get_button(Object *obj, Error **errp)
{
    return MC13783(obj)->button;
}

/* The button pulls its line low; both edges interrupt. */
static void mc13783_set_button(Object *obj, bool value, Error **errp)
{
    MC13783State *s = MC13783(obj);

    if (value != s->button) {
        s->button = value;
        s->regs[IRQ_SENSE_1] = value ? 0 : IRQ_1_ONOFD1;
        s->regs[IRQ_STATUS_1] |= IRQ_1_ONOFD1;
        mc13783_update(s);
    }
}

static void mc13783_reset(DeviceState *dev)
{
    MC13783State *s = MC13783(dev);

    memset(s->regs, 0, sizeof(s->regs));
    s->regs[IRQ_MASK_0] = s->regs[IRQ_MASK_1] = VALUE_MASK;
    s->regs[IRQ_SENSE_1] = s->button ? 0 : IRQ_1_ONOFD1;
    s->regs[REVISION] = REVISION_VALUE;
    s->bytes = 0;
    mc13783_update(s);
}

static void mc13783_realize(SSIPeripheral *dev, Error **errp)
{
    MC13783State *s = MC13783(dev);

    qdev_init_gpio_out(DEVICE(dev), &s->irq, 1);
}

static void mc13783_init(Object *obj)
{
    object_property_add_bool(obj, "power-button", mc13783_get_button,
                             mc13783_set_button);
}

static const VMStateDescription vmstate_mc13783 = {
    .name = TYPE_MC13783,
    .version_id = 1,
    .minimum_version_id = 1,
    .fields = (VMStateField[]) {
        VMSTATE_SSI_PERIPHERAL(parent_obj, MC13783State),
        VMSTATE_UINT32_ARRAY(regs, MC13783State, REGISTERS),
        VMSTATE_UINT32(value, MC13783State),
        VMSTATE_UINT8(first, MC13783State),
        VMSTATE_UINT8(bytes, MC13783State),
        VMSTATE_BOOL(button, MC13783State),
        VMSTATE_END_OF_LIST()
    },
};

static void mc13783_class_init(ObjectClass *klass, void *data)
{
    DeviceClass *dc = DEVICE_CLASS(klass);
    SSIPeripheralClass *k = SSI_PERIPHERAL_CLASS(klass);

    k->realize = mc13783_realize;
    k->transfer = mc13783_transfer;
    k->set_cs = mc13783_select;
    k->cs_polarity = SSI_CS_HIGH;
    dc->reset = mc13783_reset;
    dc->vmsd = &vmstate_mc13783;
    dc->desc = "Freescale MC13783 power chip";
}

static const TypeInfo mc13783_info = {
    .name = TYPE_MC13783,
    .parent = TYPE_SSI_PERIPHERAL,
    .instance_size = sizeof(MC13783State),
    .instance_init = mc13783_init,
    .class_init = mc13783_class_init,
};

static void mc13783_register_types(void)
{
    type_register_static(&mc13783_info);
}

type_init(mc13783_register_types)
