/*
 * The i.MX31's configurable serial interface (CSPI) as a master.
 *
 * The words in its FIFO are exchanged as soon as XCH is set; the chip select is
 * active from the first to the last of them. The devices of the bus hear
 * nothing while a pin of the bus is not routed to it. DMA and slave mode are
 * not modelled. Registers as in Linux' spi-imx.c and the reference manual's
 * chapter "CSPI".
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#include "qemu/osdep.h"
#include "hw/irq.h"
#include "hw/qdev-properties.h"
#include "hw/ssi/ssi.h"
#include "imx31_pdk.h"
#include "migration/vmstate.h"
#include "qapi/error.h"
#include "qemu/fifo32.h"
#include "qemu/module.h"
#include "trace.h"

enum {
    RXDATA = 0x00 / 4,
    TXDATA = 0x04 / 4,
    CONTROL = 0x08 / 4,
    INTERRUPTS = 0x0c / 4,
    STATUS = 0x14 / 4,
    REGISTERS = 0x20 / 4,
};

#define CONTROL_ENABLE (1 << 0)
#define CONTROL_MASTER (1 << 1)
#define CONTROL_XCH (1 << 2)
#define CONTROL_SSPOL (1 << 7)

#define STATUS_TE (1 << 0)
#define STATUS_TH (1 << 1)
#define STATUS_TF (1 << 2)
#define STATUS_RR (1 << 3)
#define STATUS_RH (1 << 4)
#define STATUS_RF (1 << 5)
#define STATUS_TC (1 << 8)

#define FIFO_WORDS 8
#define SELECTS 4
#define BUSES 2

struct IMX31CSPIState {
    SysBusDevice parent_obj;

    MemoryRegion iomem;
    qemu_irq irq;
    qemu_irq select[SELECTS];
    SSIBus *bus;
    IMX31CCMState *ccm;
    IMX31IomuxState *iomux;
    uint8_t number; /* 1 or 2 */
    uint32_t regs[REGISTERS];
    Fifo32 tx;
    Fifo32 rx;
};

/*
 * The pins that the board's devices on each bus use; CSPI1 has one range, which
 * is listed twice.
 */
static const struct imx31_pins bus_pins[BUSES][2] = {
    {
        { 111, 112, IMX31_PIN_ALTERNATE_1 }, /* RI_DCE1, DSR_DCE1 */
        { 111, 112, IMX31_PIN_ALTERNATE_1 },
    },
    {
        { 119, 120, IMX31_PIN_FUNCTION }, /* SCLK, SS2 */
        { 123, 124, IMX31_PIN_FUNCTION }, /* MISO, MOSI */
    },
};

static const char *const names[BUSES] = { "CSPI1", "CSPI2" };

static unsigned gate_of(const IMX31CSPIState *s)
{
    return s->number == 1 ? IMX31_GATE_CSPI1 : IMX31_GATE_CSPI2;
}

static uint32_t status_of(IMX31CSPIState *s)
{
    uint32_t used_tx = fifo32_num_used(&s->tx);
    uint32_t used_rx = fifo32_num_used(&s->rx);

    return (s->regs[STATUS] & STATUS_TC) |
           (used_tx == 0 ? STATUS_TE : 0) |
           (used_tx <= FIFO_WORDS / 2 ? STATUS_TH : 0) |
           (used_tx == FIFO_WORDS ? STATUS_TF : 0) |
           (used_rx > 0 ? STATUS_RR : 0) |
           (used_rx >= FIFO_WORDS / 2 ? STATUS_RH : 0) |
           (used_rx == FIFO_WORDS ? STATUS_RF : 0);
}

static void imx31_cspi_update(IMX31CSPIState *s)
{
    qemu_set_irq(s->irq, (status_of(s) & s->regs[INTERRUPTS]) != 0);
}

static bool is_connected(IMX31CSPIState *s)
{
    int pin = imx31_iomux_missing(s->iomux, bus_pins[s->number - 1], 2);

    if (pin >= 0) {
        imx31_report("%s: its pin %d is not routed to it", names[s->number - 1],
                     pin);
    }
    return pin < 0;
}

static void exchange(IMX31CSPIState *s)
{
    unsigned bits = extract32(s->regs[CONTROL], 8, 5) + 1;
    unsigned select = extract32(s->regs[CONTROL], 24, 2);
    int active = (s->regs[CONTROL] & CONTROL_SSPOL) != 0;
    uint32_t mask = bits < 32 ? (1u << bits) - 1 : UINT32_MAX;
    bool connected = is_connected(s);

    trace_imx31_cspi_exchange(select, fifo32_num_used(&s->tx));
    if (connected) {
        qemu_set_irq(s->select[select], active);
    }
    while (!fifo32_is_empty(&s->tx)) {
        uint32_t word = fifo32_pop(&s->tx) & mask;
        uint32_t answer = connected ? ssi_transfer(s->bus, word) : 0;

        if (!fifo32_is_full(&s->rx)) {
            fifo32_push(&s->rx, answer & mask);
        }
    }
    if (connected) {
        qemu_set_irq(s->select[select], !active);
    }
    s->regs[CONTROL] &= ~CONTROL_XCH;
    s->regs[STATUS] |= STATUS_TC;
}

static MemTxResult imx31_cspi_read(void *opaque, hwaddr offset, uint64_t *value,
                                   unsigned size, MemTxAttrs attrs)
{
    IMX31CSPIState *s = opaque;
    unsigned number = offset / 4;

    *value = 0;
    if (number == RXDATA) {
        *value = fifo32_is_empty(&s->rx) ? 0 : fifo32_pop(&s->rx);
        imx31_cspi_update(s);
    } else if (number == STATUS) {
        *value = status_of(s);
    } else if (number < REGISTERS) {
        *value = s->regs[number];
    }
    return imx31_clock_access(s->ccm, gate_of(s), names[s->number - 1], offset);
}

static void write_control(IMX31CSPIState *s, uint32_t value)
{
    s->regs[CONTROL] = value;
    if (!(value & CONTROL_ENABLE)) {
        fifo32_reset(&s->tx);
        fifo32_reset(&s->rx);
    } else if (value & CONTROL_MASTER && value & CONTROL_XCH) {
        exchange(s);
    }
}

static MemTxResult imx31_cspi_write(void *opaque, hwaddr offset, uint64_t value,
                                    unsigned size, MemTxAttrs attrs)
{
    IMX31CSPIState *s = opaque;
    unsigned number = offset / 4;
    MemTxResult result = imx31_clock_access(s->ccm, gate_of(s),
                                            names[s->number - 1], offset);

    if (result != MEMTX_OK) {
        return result;
    }
    if (number == TXDATA) {
        if (!fifo32_is_full(&s->tx)) {
            fifo32_push(&s->tx, value);
        }
    } else if (number == CONTROL) {
        write_control(s, value);
    } else if (number == STATUS) {
        s->regs[STATUS] &= ~(value & STATUS_TC);
    } else if (number < REGISTERS && number != RXDATA) {
        s->regs[number] = value;
    }
    imx31_cspi_update(s);
    return MEMTX_OK;
}

static const MemoryRegionOps imx31_cspi_ops = {
    .read_with_attrs = imx31_cspi_read,
    .write_with_attrs = imx31_cspi_write,
    .endianness = DEVICE_LITTLE_ENDIAN,
    .valid = { .min_access_size = 4, .max_access_size = 4 },
};

static void imx31_cspi_reset(DeviceState *dev)
{
    IMX31CSPIState *s = IMX31_CSPI(dev);

    memset(s->regs, 0, sizeof(s->regs));
    fifo32_reset(&s->tx);
    fifo32_reset(&s->rx);
    imx31_cspi_update(s);
}

static void imx31_cspi_realize(DeviceState *dev, Error **errp)
{
    IMX31CSPIState *s = IMX31_CSPI(dev);

    if (s->number < 1 || s->number > BUSES) {
        error_setg(errp, "CSPI%u: only 1 and 2 exist here", s->number);
    }
}

static void imx31_cspi_init(Object *obj)
{
    IMX31CSPIState *s = IMX31_CSPI(obj);

    memory_region_init_io(&s->iomem, obj, &imx31_cspi_ops, s, TYPE_IMX31_CSPI,
                          0x4000);
    sysbus_init_mmio(SYS_BUS_DEVICE(obj), &s->iomem);
    sysbus_init_irq(SYS_BUS_DEVICE(obj), &s->irq);
    qdev_init_gpio_out_named(DEVICE(obj), s->select, "select", SELECTS);
    s->bus = ssi_create_bus(DEVICE(obj), "spi");
    fifo32_create(&s->tx, FIFO_WORDS);
    fifo32_create(&s->rx, FIFO_WORDS);
}

static const VMStateDescription vmstate_imx31_cspi = {
    .name = TYPE_IMX31_CSPI,
    .version_id = 1,
    .minimum_version_id = 1,
    .fields = (VMStateField[]) {
        VMSTATE_UINT32_ARRAY(regs, IMX31CSPIState, REGISTERS),
        VMSTATE_FIFO32(tx, IMX31CSPIState),
        VMSTATE_FIFO32(rx, IMX31CSPIState),
        VMSTATE_END_OF_LIST()
    },
};

static Property imx31_cspi_properties[] = {
    DEFINE_PROP_UINT8("number", IMX31CSPIState, number, 0),
    DEFINE_PROP_LINK("ccm", IMX31CSPIState, ccm, TYPE_IMX31_CCM,
                     IMX31CCMState *),
    DEFINE_PROP_LINK("iomux", IMX31CSPIState, iomux, TYPE_IMX31_IOMUX,
                     IMX31IomuxState *),
    DEFINE_PROP_END_OF_LIST(),
};

static void imx31_cspi_class_init(ObjectClass *klass, void *data)
{
    DeviceClass *dc = DEVICE_CLASS(klass);

    dc->realize = imx31_cspi_realize;
    dc->reset = imx31_cspi_reset;
    dc->vmsd = &vmstate_imx31_cspi;
    dc->desc = "i.MX31 serial interface";
    device_class_set_props(dc, imx31_cspi_properties);
}

static const TypeInfo imx31_cspi_info = {
    .name = TYPE_IMX31_CSPI,
    .parent = TYPE_SYS_BUS_DEVICE,
    .instance_size = sizeof(IMX31CSPIState),
    .instance_init = imx31_cspi_init,
    .class_init = imx31_cspi_class_init,
};

static void imx31_cspi_register_types(void)
{
    type_register_static(&imx31_cspi_info);
}

type_init(imx31_cspi_register_types)
