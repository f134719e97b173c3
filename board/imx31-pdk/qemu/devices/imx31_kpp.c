/*
 * The i.MX31's keypad port (KPP): a matrix of 8 rows and 8 columns.
 *
 * Pressed keys connect a row with a column. A column that is driven low pulls
 * the rows of its pressed keys low, and these pull further columns low that are
 * open-drain: three keys at the corners of a rectangle show a fourth ("ghost").
 * A row or column takes part only when its pin is routed to the port.
 *
 * The property "keys" names the pressed keys as "ROW,COLUMN ROW,COLUMN ...".
 * Registers as in Linux' imx_keypad.c and the reference manual's chapter "KPP".
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#include "qemu/osdep.h"
#include "imx31_pdk.h"
#include "hw/irq.h"
#include "hw/qdev-properties.h"
#include "migration/vmstate.h"
#include "qapi/error.h"
#include "qemu/cutils.h"
#include "qemu/module.h"
#include "trace.h"

#define KPCR 0x00
#define KPSR 0x02
#define KDDR 0x04
#define KPDR 0x06

#define KPSR_KPKD (1 << 0)
#define KPSR_KPKR (1 << 1)
#define KPSR_KDSC (1 << 2)
#define KPSR_KRSS (1 << 3)
#define KPSR_KDIE (1 << 8)
#define KPSR_KRIE (1 << 9)
#define KPSR_KEPT (KPSR_KDIE | KPSR_KRIE | 1 << 10)

#define LINES 8
#define PIN_ROW_0 99
#define PIN_COLUMN_0 91

struct IMX31KPPState {
    SysBusDevice parent_obj;

    MemoryRegion iomem;
    qemu_irq irq;
    IMX31CCMState *ccm;
    IMX31IomuxState *iomux;
    uint16_t control;
    uint16_t status;
    uint16_t direction;
    uint16_t data;
    uint8_t pressed[LINES]; /* columns of each row */
    bool press_seen; /* the depress chain has found a key and was not cleared */
    bool release_armed; /* the release chain was set */
};

static bool is_routed(const IMX31KPPState *s, unsigned pin)
{
    return imx31_iomux_routes(s->iomux, pin, IMX31_PIN_FUNCTION);
}

/* Gets the columns that the port drives low and those that it does not drive. */
static void drive_columns(const IMX31KPPState *s, uint8_t *low, uint8_t *floats)
{
    *low = *floats = 0;
    for (unsigned i = 0; i < LINES; i++) {
        uint16_t bit = 1 << (8 + i);

        if (!is_routed(s, PIN_COLUMN_0 - i)) {
            continue;
        }
        if (!(s->direction & bit)) {
            *floats |= 1 << i;
        } else if (!(s->data & bit)) {
            *low |= 1 << i;
        } else if (s->control & bit) {
            *floats |= 1 << i;
        }
    }
}

/*
 * Returns the rows that are low. A low row pulls floating columns low, and these
 * pull further rows low, until nothing changes any more.
 */
static uint8_t low_rows(const IMX31KPPState *s)
{
    uint8_t low, floats, rows = 0, before;

    drive_columns(s, &low, &floats);
    do {
        before = rows;
        for (unsigned row = 0; row < LINES; row++) {
            if ((s->pressed[row] & low) && is_routed(s, PIN_ROW_0 - row)) {
                rows |= 1 << row;
                low |= s->pressed[row] & floats;
            }
        }
    } while (rows != before);
    return rows;
}

static void imx31_kpp_update(IMX31KPPState *s)
{
    bool low = low_rows(s) & s->control & 0xff;

    if (low && !s->press_seen) {
        s->press_seen = true;
        s->status |= KPSR_KPKD;
    } else if (!low) {
        s->press_seen = false;
        if (s->release_armed) {
            s->release_armed = false;
            s->status |= KPSR_KPKR;
        }
    }
    qemu_set_irq(s->irq,
                 (s->status & KPSR_KPKD && s->status & KPSR_KDIE) ||
                 (s->status & KPSR_KPKR && s->status & KPSR_KRIE));
}

static MemTxResult imx31_kpp_read(void *opaque, hwaddr offset, uint64_t *value,
                                  unsigned size, MemTxAttrs attrs)
{
    IMX31KPPState *s = opaque;
    uint8_t inputs = ~s->direction;

    switch (offset) {
    case KPCR:
        *value = s->control;
        break;
    case KPSR:
        *value = s->status;
        break;
    case KDDR:
        *value = s->direction;
        break;
    case KPDR:
        *value = (s->data & ~inputs) | (inputs & ~low_rows(s) & 0xff);
        break;
    default:
        *value = 0;
    }
    return imx31_clock_access(s->ccm, IMX31_GATE_KPP, "KPP", offset);
}

static void write_status(IMX31KPPState *s, uint16_t value)
{
    s->status &= ~(value & (KPSR_KPKD | KPSR_KPKR));
    s->status = (s->status & ~KPSR_KEPT) | (value & KPSR_KEPT);
    if (value & KPSR_KDSC) {
        s->press_seen = false;
    }
    if (value & KPSR_KRSS) {
        s->release_armed = true;
    }
}

static MemTxResult imx31_kpp_write(void *opaque, hwaddr offset, uint64_t value,
                                   unsigned size, MemTxAttrs attrs)
{
    IMX31KPPState *s = opaque;
    MemTxResult result = imx31_clock_access(s->ccm, IMX31_GATE_KPP, "KPP",
                                            offset);

    if (result != MEMTX_OK) {
        return result;
    }
    trace_imx31_kpp_write(offset, value);
    switch (offset) {
    case KPCR:
        s->control = value;
        break;
    case KPSR:
        write_status(s, value);
        break;
    case KDDR:
        s->direction = value;
        break;
    case KPDR:
        s->data = value;
        break;
    }
    imx31_kpp_update(s);
    return MEMTX_OK;
}

static const MemoryRegionOps imx31_kpp_ops = {
    .read_with_attrs = imx31_kpp_read,
    .write_with_attrs = imx31_kpp_write,
    .endianness = DEVICE_LITTLE_ENDIAN,
    .valid = { .min_access_size = 2, .max_access_size = 2 },
};

static char *imx31_kpp_get_keys(Object *obj, Error **errp)
{
    IMX31KPPState *s = IMX31_KPP(obj);
    GString *text = g_string_new(NULL);

    for (unsigned row = 0; row < LINES; row++) {
        for (unsigned column = 0; column < LINES; column++) {
            if (s->pressed[row] >> column & 1) {
                g_string_append_printf(text, "%s%u,%u", text->len ? " " : "",
                                       row, column);
            }
        }
    }
    return g_string_free(text, false);
}

static bool parse_key(const char *word, uint8_t *pressed)
{
    if (strlen(word) != 3 || word[1] != ',' || word[0] < '0' ||
        word[0] >= '0' + LINES || word[2] < '0' || word[2] >= '0' + LINES) {
        return false;
    }
    pressed[word[0] - '0'] |= 1 << (word[2] - '0');
    return true;
}

static void imx31_kpp_set_keys(Object *obj, const char *value, Error **errp)
{
    IMX31KPPState *s = IMX31_KPP(obj);
    g_auto(GStrv) words = g_strsplit(value, " ", -1);
    uint8_t pressed[LINES] = { 0 };

    for (char **word = words; *word; word++) {
        if (**word && !parse_key(*word, pressed)) {
            error_setg(errp, "key %s: give ROW,COLUMN, both from 0 to 7",
                       *word);
            return;
        }
    }
    trace_imx31_kpp_keys(value);
    memcpy(s->pressed, pressed, sizeof(pressed));
    imx31_kpp_update(s);
}

static void imx31_kpp_reset(DeviceState *dev)
{
    IMX31KPPState *s = IMX31_KPP(dev);

    s->control = s->status = s->direction = s->data = 0;
    s->press_seen = s->release_armed = false;
    imx31_kpp_update(s);
}

static void imx31_kpp_init(Object *obj)
{
    IMX31KPPState *s = IMX31_KPP(obj);

    memory_region_init_io(&s->iomem, obj, &imx31_kpp_ops, s, TYPE_IMX31_KPP,
                          0x4000);
    sysbus_init_mmio(SYS_BUS_DEVICE(obj), &s->iomem);
    sysbus_init_irq(SYS_BUS_DEVICE(obj), &s->irq);
    object_property_add_str(obj, "keys", imx31_kpp_get_keys,
                            imx31_kpp_set_keys);
}

static const VMStateDescription vmstate_imx31_kpp = {
    .name = TYPE_IMX31_KPP,
    .version_id = 1,
    .minimum_version_id = 1,
    .fields = (VMStateField[]) {
        VMSTATE_UINT16(control, IMX31KPPState),
        VMSTATE_UINT16(status, IMX31KPPState),
        VMSTATE_UINT16(direction, IMX31KPPState),
        VMSTATE_UINT16(data, IMX31KPPState),
        VMSTATE_UINT8_ARRAY(pressed, IMX31KPPState, LINES),
        VMSTATE_BOOL(press_seen, IMX31KPPState),
        VMSTATE_BOOL(release_armed, IMX31KPPState),
        VMSTATE_END_OF_LIST()
    },
};

static Property imx31_kpp_properties[] = {
    DEFINE_PROP_LINK("ccm", IMX31KPPState, ccm, TYPE_IMX31_CCM,
                     IMX31CCMState *),
    DEFINE_PROP_LINK("iomux", IMX31KPPState, iomux, TYPE_IMX31_IOMUX,
                     IMX31IomuxState *),
    DEFINE_PROP_END_OF_LIST(),
};

static void imx31_kpp_class_init(ObjectClass *klass, void *data)
{
    DeviceClass *dc = DEVICE_CLASS(klass);

    dc->reset = imx31_kpp_reset;
    dc->vmsd = &vmstate_imx31_kpp;
    dc->desc = "i.MX31 keypad port";
    device_class_set_props(dc, imx31_kpp_properties);
}

static const TypeInfo imx31_kpp_info = {
    .name = TYPE_IMX31_KPP,
    .parent = TYPE_SYS_BUS_DEVICE,
    .instance_size = sizeof(IMX31KPPState),
    .instance_init = imx31_kpp_init,
    .class_init = imx31_kpp_class_init,
};

static void imx31_kpp_register_types(void)
{
    type_register_static(&imx31_kpp_info);
}

type_init(imx31_kpp_register_types)
