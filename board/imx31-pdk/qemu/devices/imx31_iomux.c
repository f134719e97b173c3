/*
 * The i.MX31's pin multiplexer, and the questions about its clock gates.
 *
 * The multiplexer has a byte for each pin (SW_MUX_CTL) and pads of ten bits
 * (SW_PAD_CTL), which only keep what is written. After a reset every pin has its
 * function. Offsets are those of Freescale's iomux-imx31.c (Linux up to 5.9).
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#include "qemu/osdep.h"
#include "imx31_pdk.h"
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
}

static void imx31_iomux_init(Object *obj)
{
    IMX31IomuxState *s = IMX31_IOMUX(obj);

    memory_region_init_io(&s->iomem, obj, &imx31_iomux_ops, s,
                          TYPE_IMX31_IOMUX, IOMUX_SIZE);
    sysbus_init_mmio(SYS_BUS_DEVICE(obj), &s->iomem);
}

static const VMStateDescription vmstate_imx31_iomux = {
    .name = TYPE_IMX31_IOMUX,
    .version_id = 1,
    .minimum_version_id = 1,
    .fields = (VMStateField[]) {
        VMSTATE_UINT8_ARRAY(bytes, IMX31IomuxState, IOMUX_USED),
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
