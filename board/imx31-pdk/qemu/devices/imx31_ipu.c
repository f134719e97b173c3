/*
 * The i.MX31's image processing unit (IPU), as far as it brings a picture to
 * the panel: the DMA controller's channel 14 (SDC background), the synchronous
 * display controller and display 3.
 *
 * A timer walks through the picture at the panel's rate of emulated time: it
 * latches the channel's parameters at VSYNC, fetches the lines in slices while
 * the beam passes them, and ends the frame with the channel's end-of-frame
 * interrupt. So a picture that the processor changes while it is sent shows as
 * torn. Other channels, the image converter and the camera interface only keep
 * what is written.
 *
 * Registers as in Linux' drivers/dma/ipu and mx3fb.c, and in the reference
 * manual's chapter "IPU".
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

enum {
    IPU_CONF = 0x00 / 4,
    CHA_BUF0_RDY = 0x04 / 4,
    CHA_BUF1_RDY = 0x08 / 4,
    CHA_DB_MODE_SEL = 0x0c / 4,
    CHA_CUR_BUF = 0x10 / 4,
    IMA_ADDR = 0x20 / 4,
    IMA_DATA = 0x24 / 4,
    INT_CTRL_1 = 0x28 / 4,
    INT_STAT_1 = 0x3c / 4,
    INT_STAT_3 = 0x44 / 4,
    INT_STAT_5 = 0x4c / 4,
    IDMAC_CHA_EN = 0xa8 / 4,
    SDC_COM_CONF = 0xb4 / 4,
    SDC_BG_POS = 0xc0 / 4,
    SDC_PWM_CTRL = 0xc8 / 4,
    SDC_HOR_CONF = 0xd0 / 4,
    SDC_VER_CONF = 0xd4 / 4,
    DI_DISP3_TIME_CONF = 0x15c / 4,
    DI_DISP3_B0_MAP = 0x1a8 / 4,
    REGISTERS = 0x200 / 4,
};

#define CONF_SDC_AND_DI (1 << 4 | 1 << 6)
#define COM_CONF_BG_EN (1 << 9)
#define CHANNEL 14
#define CHANNEL_BIT (1u << CHANNEL)
#define VSYNC_BIT (1u << 16) /* in INT_STAT_3 */
#define BANKS 5

/* IMA addresses of the channel parameter memory, 16 words a channel. */
#define CPM_AT 0x10000
#define CPM_WORDS (32 * 16)

/*
 * The window's position (SDC_BG_POS) at which its first pixel is that of the
 * panel: the panel's horizontal and vertical back porch.
 */
#define PANEL_LEFT 20
#define PANEL_TOP 10

#define SLICE_LINES 40
#define IDLE_NS 16000000

static const struct imx31_pins panel_pins[] = {
    { 22, 23, IMX31_PIN_FUNCTION },  /* CONTRAST, VSYNC3 */
    { 34, 35, IMX31_PIN_FUNCTION },  /* FPSHIFT, HSYNC */
    { 37, 54, IMX31_PIN_FUNCTION },  /* LD17 to LD0 */
};

static const uint32_t rgb666_map[3] = { 0x0005000f, 0x000b000f, 0x0011000f };

struct IMX31IPUState {
    SysBusDevice parent_obj;

    MemoryRegion iomem;
    qemu_irq irq;
    qemu_irq error_irq;
    QEMUTimer timer;
    IMX31CCMState *ccm;
    IMX31IomuxState *iomux;
    L4F00242T03State *panel;
    uint32_t regs[REGISTERS];
    uint32_t cpm[CPM_WORDS];

    struct imx31_scan scan; /* latched at VSYNC */
    uint32_t pictures[2]; /* the last two different addresses, newest first */
    bool is_active; /* the current frame is sent */
    bool is_started; /* a buffer has been made ready since the reset */
    uint32_t line; /* the next line of the current frame */
    int64_t begun_ns; /* when the current frame began */
    uint64_t frames;
    uint64_t torn;
    int64_t reset_ns;
    /* Times since the reset; 0 until it has happened. */
    uint64_t first_us; /* of the first picture with many colours */
    uint64_t changed_us; /* of the first changed row since this was 0 */
    const char *fault; /* the last fault that was reported */
};

static void imx31_ipu_update(IMX31IPUState *s)
{
    uint32_t pending[BANKS];

    for (unsigned i = 0; i < BANKS; i++) {
        pending[i] = s->regs[INT_STAT_1 + i] & s->regs[INT_CTRL_1 + i];
    }
    qemu_set_irq(s->irq, pending[0] || pending[1] || pending[2]);
    qemu_set_irq(s->error_irq, pending[3] || pending[4]);
}

/* The duration of one line, from the registers and the display clock. */
static int64_t line_ns(IMX31IPUState *s)
{
    uint64_t clocks = extract32(s->regs[SDC_HOR_CONF], 16, 10) + 1;
    uint64_t divider = MAX(s->regs[DI_DISP3_TIME_CONF] & 0xfff, 16);

    return clocks * divider * NANOSECONDS_PER_SECOND /
           (16 * imx31_hsp_hz(s->ccm));
}

static uint32_t frame_lines(const IMX31IPUState *s)
{
    return extract32(s->regs[SDC_VER_CONF], 16, 10) + 1;
}

static uint32_t first_line(const IMX31IPUState *s)
{
    return extract32(s->regs[SDC_BG_POS], 0, 10);
}

static void latch(IMX31IPUState *s)
{
    unsigned current = s->regs[CHA_CUR_BUF] >> CHANNEL & 1;

    s->scan = imx31_scan_of(s->cpm + 16 * CHANNEL, current);
    if (s->scan.address != s->pictures[0]) {
        s->pictures[1] = s->pictures[0];
        s->pictures[0] = s->scan.address;
    }
}

/* What keeps the panel from showing the picture, as a clause, or NULL. */
static const char *find_fault(IMX31IPUState *s)
{
    const uint32_t *map = s->regs + DI_DISP3_B0_MAP;

    if (!imx31_clock_runs(s->ccm, IMX31_GATE_IPU)) {
        return "the IPU's clock is off (bits 22 and 23 of CGR1)";
    }
    if (imx31_iomux_missing(s->iomux, panel_pins, ARRAY_SIZE(panel_pins)) >= 0) {
        return "a pin of the panel's data or synchronization is not routed "
               "to the IPU";
    }
    if (memcmp(map, rgb666_map, sizeof(rgb666_map))) {
        return "display 3 does not send RGB666, which the panel's 18 wires "
               "carry";
    }
    if (!s->scan.bytes) {
        return "channel 14 has a pixel format that is not modelled";
    }
    if (!(s->regs[SDC_PWM_CTRL] >> 16 & 0xff)) {
        return "the backlight is off (SDC_PWM_CTRL)";
    }
    return l4f00242t03_fault(s->panel);
}

static bool is_on(const IMX31IPUState *s)
{
    return (s->regs[IPU_CONF] & CONF_SDC_AND_DI) == CONF_SDC_AND_DI &&
           s->regs[SDC_COM_CONF] & COM_CONF_BG_EN &&
           s->regs[IDMAC_CHA_EN] & CHANNEL_BIT && s->is_started &&
           imx31_clock_runs(s->ccm, IMX31_GATE_IPU);
}

static void report_fault(IMX31IPUState *s, const char *fault)
{
    if (fault && fault != s->fault) {
        imx31_report("no picture: %s", fault);
    } else if (!fault && s->fault) {
        imx31_report("the panel shows the picture");
    }
    s->fault = fault;
}

static uint64_t time_us(const IMX31IPUState *s)
{
    return (qemu_clock_get_ns(QEMU_CLOCK_VIRTUAL) - s->reset_ns) / SCALE_US;
}

static void fetch_line(IMX31IPUState *s, uint32_t line)
{
    uint16_t pixels[IMX31_SCAN_MAX];
    unsigned count = imx31_scan_read(&s->scan, line, pixels);
    int left = (int)extract32(s->regs[SDC_BG_POS], 16, 10) - PANEL_LEFT;
    int top = (int)first_line(s) - PANEL_TOP;

    if (l4f00242t03_show(s->panel, left, top + (int)line, pixels, count) &&
        !s->changed_us) {
        s->changed_us = time_us(s);
    }
}

static void begin_frame(IMX31IPUState *s)
{
    s->begun_ns = qemu_clock_get_ns(QEMU_CLOCK_VIRTUAL);
    s->line = 0;
    s->is_active = is_on(s);
    if (s->is_active) {
        latch(s);
        imx31_scan_watch(&s->scan);
        s->regs[INT_STAT_3] |= VSYNC_BIT;
    }
    report_fault(s, s->is_active || s->is_started ? find_fault(s) : NULL);
    if (!s->is_active || s->fault) {
        l4f00242t03_darken(s->panel);
    }
    trace_imx31_ipu_frame(s->frames, s->scan.address, s->is_active);
}

static void end_frame(IMX31IPUState *s)
{
    unsigned current = s->regs[CHA_CUR_BUF] >> CHANNEL & 1;

    s->frames++;
    s->torn += imx31_scan_was_written(&s->scan);
    if (!s->first_us && !s->fault && l4f00242t03_is_drawn(s->panel)) {
        s->first_us = time_us(s);
    }
    s->regs[current ? CHA_BUF1_RDY : CHA_BUF0_RDY] &= ~CHANNEL_BIT;
    if (s->regs[CHA_DB_MODE_SEL] & CHANNEL_BIT &&
        s->regs[current ? CHA_BUF0_RDY : CHA_BUF1_RDY] & CHANNEL_BIT) {
        s->regs[CHA_CUR_BUF] ^= CHANNEL_BIT;
    }
    s->regs[INT_STAT_1] |= CHANNEL_BIT;
}

/*
 * Called by the timer when the beam has passed the next slice of lines, or when a
 * new frame begins.
 */
static void imx31_ipu_beam(void *opaque)
{
    IMX31IPUState *s = opaque;
    uint32_t stop;

    if (!s->is_active || s->line >= s->scan.height) {
        begin_frame(s);
    } else {
        stop = MIN(s->line + SLICE_LINES, s->scan.height);
        for (; s->line < stop; s->line++) {
            if (!s->fault) {
                fetch_line(s, s->line);
            }
        }
        if (s->line == s->scan.height) {
            end_frame(s);
        }
    }
    imx31_ipu_update(s);
    if (!s->is_active) {
        timer_mod(&s->timer, s->begun_ns + IDLE_NS);
    } else if (s->line < s->scan.height) {
        stop = first_line(s) + MIN(s->line + SLICE_LINES, s->scan.height);
        timer_mod(&s->timer, s->begun_ns + stop * line_ns(s));
    } else {
        timer_mod(&s->timer, s->begun_ns + line_ns(s) *
                  MAX(frame_lines(s), first_line(s) + s->scan.height + 1));
    }
}

static MemTxResult imx31_ipu_read(void *opaque, hwaddr offset, uint64_t *value,
                                  unsigned size, MemTxAttrs attrs)
{
    IMX31IPUState *s = opaque;
    unsigned number = offset / 4;

    *value = 0;
    if (number == IMA_DATA) {
        uint32_t at = s->regs[IMA_ADDR] - CPM_AT;

        *value = at < CPM_WORDS ? s->cpm[at] : 0;
    } else if (number < REGISTERS) {
        *value = s->regs[number];
    }
    return imx31_clock_access(s->ccm, IMX31_GATE_IPU, "IPU", offset);
}

static void write_memory(IMX31IPUState *s, uint32_t value)
{
    uint32_t at = s->regs[IMA_ADDR] - CPM_AT;

    if (at < CPM_WORDS) {
        s->cpm[at] = value;
    }
    s->regs[IMA_ADDR]++;
}

static void write_register(IMX31IPUState *s, unsigned number, uint32_t value)
{
    switch (number) {
    case CHA_BUF0_RDY:
    case CHA_BUF1_RDY:
        s->regs[number] |= value;
        s->is_started |= value & CHANNEL_BIT;
        break;
    case CHA_CUR_BUF:
    case INT_STAT_1 ... INT_STAT_5:
        s->regs[number] &= ~value;
        break;
    case IMA_DATA:
        write_memory(s, value);
        break;
    default:
        s->regs[number] = value;
    }
}

static MemTxResult imx31_ipu_write(void *opaque, hwaddr offset, uint64_t value,
                                   unsigned size, MemTxAttrs attrs)
{
    IMX31IPUState *s = opaque;
    MemTxResult result = imx31_clock_access(s->ccm, IMX31_GATE_IPU, "IPU",
                                            offset);

    trace_imx31_ipu_write(offset, value);
    if (result == MEMTX_OK && offset / 4 < REGISTERS) {
        write_register(s, offset / 4, value);
        imx31_ipu_update(s);
    }
    return result;
}

static const MemoryRegionOps imx31_ipu_ops = {
    .read_with_attrs = imx31_ipu_read,
    .write_with_attrs = imx31_ipu_write,
    .endianness = DEVICE_LITTLE_ENDIAN,
    .valid = { .min_access_size = 4, .max_access_size = 4 },
};

static void imx31_ipu_reset(DeviceState *dev)
{
    IMX31IPUState *s = IMX31_IPU(dev);

    memset(s->regs, 0, sizeof(s->regs));
    memset(s->cpm, 0, sizeof(s->cpm));
    memset(&s->scan, 0, sizeof(s->scan));
    memset(s->pictures, 0, sizeof(s->pictures));
    s->is_active = s->is_started = false;
    s->line = 0;
    s->frames = s->torn = s->first_us = s->changed_us = 0;
    s->reset_ns = qemu_clock_get_ns(QEMU_CLOCK_VIRTUAL);
    s->fault = NULL;
    timer_mod(&s->timer, qemu_clock_get_ns(QEMU_CLOCK_VIRTUAL) + IDLE_NS);
    imx31_ipu_update(s);
}

static void imx31_ipu_init(Object *obj)
{
    IMX31IPUState *s = IMX31_IPU(obj);

    memory_region_init_io(&s->iomem, obj, &imx31_ipu_ops, s, TYPE_IMX31_IPU,
                          0x4000);
    sysbus_init_mmio(SYS_BUS_DEVICE(obj), &s->iomem);
    sysbus_init_irq(SYS_BUS_DEVICE(obj), &s->irq);
    sysbus_init_irq(SYS_BUS_DEVICE(obj), &s->error_irq);
    timer_init_ns(&s->timer, QEMU_CLOCK_VIRTUAL, imx31_ipu_beam, s);
    /* Properties for tests; README.md explains them. */
    object_property_add_uint32_ptr(obj, "picture0", &s->pictures[0],
                                   OBJ_PROP_FLAG_READ);
    object_property_add_uint32_ptr(obj, "picture1", &s->pictures[1],
                                   OBJ_PROP_FLAG_READ);
    object_property_add_uint64_ptr(obj, "frames", &s->frames,
                                   OBJ_PROP_FLAG_READ);
    object_property_add_uint64_ptr(obj, "torn", &s->torn, OBJ_PROP_FLAG_READ);
    object_property_add_uint64_ptr(obj, "first-us", &s->first_us,
                                   OBJ_PROP_FLAG_READ);
    object_property_add_uint64_ptr(obj, "changed-us", &s->changed_us,
                                   OBJ_PROP_FLAG_READWRITE);
}

static int imx31_ipu_post_load(void *opaque, int version)
{
    IMX31IPUState *s = opaque;

    latch(s);
    s->fault = NULL;
    return 0;
}

static const VMStateDescription vmstate_imx31_ipu = {
    .name = TYPE_IMX31_IPU,
    .version_id = 1,
    .minimum_version_id = 1,
    .post_load = imx31_ipu_post_load,
    .fields = (VMStateField[]) {
        VMSTATE_TIMER(timer, IMX31IPUState),
        VMSTATE_UINT32_ARRAY(regs, IMX31IPUState, REGISTERS),
        VMSTATE_UINT32_ARRAY(cpm, IMX31IPUState, CPM_WORDS),
        VMSTATE_UINT32_ARRAY(pictures, IMX31IPUState, 2),
        VMSTATE_BOOL(is_active, IMX31IPUState),
        VMSTATE_BOOL(is_started, IMX31IPUState),
        VMSTATE_UINT32(line, IMX31IPUState),
        VMSTATE_INT64(begun_ns, IMX31IPUState),
        VMSTATE_UINT64(frames, IMX31IPUState),
        VMSTATE_UINT64(torn, IMX31IPUState),
        VMSTATE_INT64(reset_ns, IMX31IPUState),
        VMSTATE_UINT64(first_us, IMX31IPUState),
        VMSTATE_UINT64(changed_us, IMX31IPUState),
        VMSTATE_END_OF_LIST()
    },
};

static Property imx31_ipu_properties[] = {
    DEFINE_PROP_LINK("ccm", IMX31IPUState, ccm, TYPE_IMX31_CCM,
                     IMX31CCMState *),
    DEFINE_PROP_LINK("iomux", IMX31IPUState, iomux, TYPE_IMX31_IOMUX,
                     IMX31IomuxState *),
    DEFINE_PROP_LINK("panel", IMX31IPUState, panel, TYPE_L4F00242T03,
                     L4F00242T03State *),
    DEFINE_PROP_END_OF_LIST(),
};

static void imx31_ipu_class_init(ObjectClass *klass, void *data)
{
    DeviceClass *dc = DEVICE_CLASS(klass);

    dc->reset = imx31_ipu_reset;
    dc->vmsd = &vmstate_imx31_ipu;
    dc->desc = "i.MX31 image processing unit";
    device_class_set_props(dc, imx31_ipu_properties);
}

static const TypeInfo imx31_ipu_info = {
    .name = TYPE_IMX31_IPU,
    .parent = TYPE_SYS_BUS_DEVICE,
    .instance_size = sizeof(IMX31IPUState),
    .instance_init = imx31_ipu_init,
    .class_init = imx31_ipu_class_init,
};

static void imx31_ipu_register_types(void)
{
    type_register_static(&imx31_ipu_info);
}

type_init(imx31_ipu_register_types)
