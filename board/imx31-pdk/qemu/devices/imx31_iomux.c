/*
 * The i.MX31's pin multiplexer, and what other devices ask about pins and clocks.
 *
 * The multiplexer has a byte for each pin (SW_MUX_CTL) and pads of ten bits
 * (SW_PAD_CTL), which only keep what is written. After a reset every pin has its
 * function. Offsets are those of Freescale's iomux-imx31.c (Linux up to 5.9).
 *
 * The inputs "button" are the board's pins KEY_ROW4 to 7 and KEY_COL4 to 7. A
 * level there reaches the GPIO controller only while its pin is routed to it.
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#include "qemu/osdep.h"
#include "imx31_pdk.h"
#include "hw/irq.h"
#include "migration/vmstate.h"
#include "qemu/log.h"
#include "qemu/module.h"

#define IOMUX_SIZE 0x1000
#define IOMUX_USED 0x400
#define IOMUX_MUX 0x00c
#define IOMUX_PAD 0x154

struct IMX31IomuxState {
    SysBusDevice parent_obj;

    MemoryRegion iomem;
    uint8_t bytes[IOMUX_USED];
    qemu_irq button[IMX31_BUTTONS]; /* to the GPIO controller */
    uint8_t pressed; /* a bit for each button */
};

/* The pins of the buttons in the multiplexer. */
static const struct {
    unsigned pin;
    const char *name;
} buttons[IMX31_BUTTONS] = {
    { 95, "KEY_ROW4" }, { 94, "KEY_ROW5" }, { 93, "KEY_ROW6" },
    { 92, "KEY_ROW7" }, { 87, "KEY_COL4" }, { 86, "KEY_COL5" },
    { 85, "KEY_COL6" }, { 84, "KEY_COL7" },
};

void imx31_report(const char *format, ...)
{
    g_autofree char *text = NULL;
    va_list arguments;

    va_start(arguments, format);
    text = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    qemu_log_mask(LOG_GUEST_ERROR, "imx31-pdk: %s\n", text);
}

bool imx31_clock_runs(const IMX31CCMState *ccm, unsigned gate)
{
    return ccm->reg[IMX31_CCM_CGR0_REG + gate / 16] >> gate % 16 * 2 & 3;
}

MemTxResult imx31_clock_access(const IMX31CCMState *ccm, unsigned gate,
                               const char *name, hwaddr offset)
{
    if (imx31_clock_runs(ccm, gate)) {
        return MEMTX_OK;
    }
    imx31_report("%s: access to 0x%03" HWADDR_PRIx " while its clock is off "
                 "(bits %u and %u of CGR%u)", name, offset, gate % 16 * 2,
                 gate % 16 * 2 + 1, gate / 16);
    return MEMTX_ERROR;
}

uint64_t imx31_hsp_hz(const IMX31CCMState *ccm)
{
    uint32_t pll = ccm->reg[IMX31_CCM_MPCTL_REG];
    uint32_t divider = EXTRACT(ccm->reg[IMX31_CCM_PDR0_REG], HSP) + 1;
    uint32_t whole = MAX(extract32(pll, 10, 4), 5);
    int32_t numerator = sextract32(pll, 0, 10);
    uint32_t denominator = extract32(pll, 16, 10) + 1;
    uint32_t before = extract32(pll, 26, 4) + 1;
    uint64_t reference_hz = 26000000;

    return 2 * reference_hz * (whole * denominator + numerator) /
           (denominator * before * divider);
}

bool imx31_iomux_routes(const IMX31IomuxState *iomux, unsigned pin,
                        unsigned mode)
{
    return iomux->bytes[IOMUX_MUX + pin] == mode;
}

int imx31_iomux_missing(const IMX31IomuxState *iomux,
                        const struct imx31_pins *pins, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        for (unsigned pin = pins[i].first; pin <= pins[i].last; pin++) {
            if (!imx31_iomux_routes(iomux, pin, pins[i].mode)) {
                return pin;
            }
        }
    }
    return -1;
}

static bool is_heard(const IMX31IomuxState *s, unsigned number)
{
    return imx31_iomux_routes(s, buttons[number].pin, IMX31_PIN_GPIO);
}

static void update_buttons(IMX31IomuxState *s)
{
    for (unsigned i = 0; i < IMX31_BUTTONS; i++) {
        qemu_set_irq(s->button[i], s->pressed >> i & 1 && is_heard(s, i));
    }
}

static void set_button(void *opaque, int number, int level)
{
    IMX31IomuxState *s = opaque;

    s->pressed = deposit32(s->pressed, number, 1, level != 0);
    if (level && !is_heard(s, number)) {
        imx31_report("IOMUX: the button at the pin %s is not heard: the pin "
                     "is not routed to the GPIO controller",
                     buttons[number].name);
    }
    update_buttons(s);
}

static uint64_t imx31_iomux_read(void *opaque, hwaddr offset, unsigned size)
{
    IMX31IomuxState *s = opaque;

    return offset < IOMUX_USED ? ldl_le_p(s->bytes + offset) : 0;
}

static void imx31_iomux_write(void *opaque, hwaddr offset, uint64_t value,
                              unsigned size)
{
    IMX31IomuxState *s = opaque;

    if (offset >= IOMUX_USED) {
        imx31_report("IOMUX: no register at 0x%03" HWADDR_PRIx, offset);
        return;
    }
    stl_le_p(s->bytes + offset, value);
    update_buttons(s);
}

static const MemoryRegionOps imx31_iomux_ops = {
    .read = imx31_iomux_read,
    .write = imx31_iomux_write,
    .endianness = DEVICE_LITTLE_ENDIAN,
    .valid = { .min_access_size = 4, .max_access_size = 4 },
};

static void imx31_iomux_reset(DeviceState *dev)
{
    IMX31IomuxState *s = IMX31_IOMUX(dev);

    memset(s->bytes, 0, sizeof(s->bytes));
    memset(s->bytes + IOMUX_MUX, IMX31_PIN_FUNCTION, IOMUX_PAD - IOMUX_MUX);
    update_buttons(s);
}

static void imx31_iomux_init(Object *obj)
{
    IMX31IomuxState *s = IMX31_IOMUX(obj);

    memory_region_init_io(&s->iomem, obj, &imx31_iomux_ops, s,
                          TYPE_IMX31_IOMUX, IOMUX_SIZE);
    sysbus_init_mmio(SYS_BUS_DEVICE(obj), &s->iomem);
    qdev_init_gpio_in_named(DEVICE(obj), set_button, "button", IMX31_BUTTONS);
    qdev_init_gpio_out(DEVICE(obj), s->button, IMX31_BUTTONS);
}

static const VMStateDescription vmstate_imx31_iomux = {
    .name = TYPE_IMX31_IOMUX,
    .version_id = 2,
    .minimum_version_id = 2,
    .fields = (VMStateField[]) {
        VMSTATE_UINT8_ARRAY(bytes, IMX31IomuxState, IOMUX_USED),
        VMSTATE_UINT8(pressed, IMX31IomuxState),
        VMSTATE_END_OF_LIST()
    },
};

static void imx31_iomux_class_init(ObjectClass *klass, void *data)
{
    DeviceClass *dc = DEVICE_CLASS(klass);

    dc->reset = imx31_iomux_reset;
    dc->vmsd = &vmstate_imx31_iomux;
    dc->desc = "i.MX31 pin multiplexer";
}

static const TypeInfo imx31_iomux_info = {
    .name = TYPE_IMX31_IOMUX,
    .parent = TYPE_SYS_BUS_DEVICE,
    .instance_size = sizeof(IMX31IomuxState),
    .instance_init = imx31_iomux_init,
    .class_init = imx31_iomux_class_init,
};

static void imx31_iomux_register_types(void)
{
    type_register_static(&imx31_iomux_info);
}

type_init(imx31_iomux_register_types)
