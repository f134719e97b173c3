/*
 * The Epson L4F00242T03: the PDK's panel of 480x640 pixels and its serial
 * commands, words of nine bits whose first tells parameters from commands.
 *
 * It shows pictures when both supplies are on (1.8 V and 2.8 V), its reset has
 * been low and is high since, its data are enabled, and it was told the pixel
 * format, to leave its sleep, and at least 60 ms later to switch the display on.
 * Commands as in Linux' l4f00242t03.c.
 *
 * What it shows is in a memory of its own ("glass"), which the machine maps
 * where the processor does not reach: rows of RGB565.
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#include "qemu/osdep.h"
#include "exec/address-spaces.h"
#include "hw/irq.h"
#include "hw/qdev-properties.h"
#include "hw/ssi/ssi.h"
#include "imx31_pdk.h"
#include "migration/vmstate.h"
#include "qapi/error.h"
#include "qemu/module.h"
#include "qemu/timer.h"
#include "trace.h"
#include "ui/console.h"

#define GLASS_BYTES (L4F_WIDTH * L4F_HEIGHT * 2)
#define WORD_BITS 9
#define PARAMETER 0x100
#define CONSOLE_COLOURS 12
#define SAMPLE_STEP 999
#define WAKE_NS (60 * SCALE_MS)

#define PIN_ENABLE 27
#define PIN_RESET 28

enum {
    SLEEP_IN = 0x10,
    SLEEP_OUT = 0x11,
    DISPLAY_OFF = 0x28,
    DISPLAY_ON = 0x29,
    PIXEL_FORMAT = 0x3a,
    FORMAT_18_BITS = 0x60,
};

/* The inputs of the device. */
enum {
    LINE_RESET,
    LINE_ENABLE,
    LINES,
};

struct L4F00242T03State {
    SSIPeripheral parent_obj;

    MC13783State *power;
    IMX31IomuxState *iomux;
    QemuConsole *console;
    MemoryRegion glass;
    uint16_t *pixels;
    uint8_t line[LINES];
    uint8_t command;
    bool was_reset;
    bool has_format;
    bool is_awake;
    bool is_on;
    int64_t awake_ns;
    bool is_changed; /* since the console was drawn last */
};

static void forget(L4F00242T03State *s)
{
    s->has_format = s->is_awake = s->is_on = false;
    s->command = 0;
}

static bool is_powered(const L4F00242T03State *s)
{
    return mc13783_millivolts(s->power, MC13783_VGEN) == 1800 &&
           mc13783_millivolts(s->power, MC13783_VMMC1) == 2800;
}

/* The level of an input; it is low if its pin is not routed as a GPIO. */
static bool level_of(const L4F00242T03State *s, unsigned line)
{
    unsigned pin = line == LINE_RESET ? PIN_RESET : PIN_ENABLE;

    return s->line[line] && imx31_iomux_routes(s->iomux, pin, IMX31_PIN_GPIO);
}

/* Without power or in reset the panel forgets its commands. */
static void check_state(L4F00242T03State *s)
{
    if (!is_powered(s)) {
        forget(s);
        s->was_reset = false;
    } else if (!level_of(s, LINE_RESET)) {
        forget(s);
        s->was_reset = true;
    }
}

const char *l4f00242t03_fault(L4F00242T03State *s)
{
    check_state(s);
    if (mc13783_millivolts(s->power, MC13783_VGEN) != 1800) {
        return "the panel's supply VGEN does not give 1.8 V";
    }
    if (mc13783_millivolts(s->power, MC13783_VMMC1) != 2800) {
        return "the panel's supply VMMC1 does not give 2.8 V";
    }
    if (!level_of(s, LINE_RESET)) {
        return "the panel is in reset (GPIO3_24, pin LCS1)";
    }
    if (!level_of(s, LINE_ENABLE)) {
        return "the panel's data are not enabled (GPIO3_25, pin SER_RS)";
    }
    if (!s->was_reset) {
        return "the panel was not reset after its supplies came on";
    }
    if (!s->has_format) {
        return "the panel was not told its pixel format (command 0x3a)";
    }
    if (!s->is_awake) {
        return "the panel sleeps (command 0x11 wakes it)";
    }
    return s->is_on ? NULL : "the panel's display is off (command 0x29)";
}

bool l4f00242t03_show(L4F00242T03State *s, int x, int y,
                      const uint16_t *pixels, int count)
{
    int skip = x < 0 ? -x : 0;
    int stop = MIN(count, L4F_WIDTH - x);
    uint16_t *glass;
    size_t bytes;

    if (y < 0 || y >= L4F_HEIGHT || skip >= stop) {
        return false;
    }
    glass = s->pixels + y * L4F_WIDTH + x + skip;
    bytes = (stop - skip) * sizeof(*pixels);
    if (!memcmp(glass, pixels + skip, bytes)) {
        return false;
    }
    memcpy(glass, pixels + skip, bytes);
    s->is_changed = true;
    return true;
}

bool l4f00242t03_is_drawn(const L4F00242T03State *s)
{
    uint16_t colours[CONSOLE_COLOURS];
    unsigned count = 0, i;

    for (unsigned at = 0; at < L4F_WIDTH * L4F_HEIGHT; at += SAMPLE_STEP) {
        for (i = 0; i < count && colours[i] != s->pixels[at]; i++) {
        }
        if (i == CONSOLE_COLOURS) {
            return true;
        }
        if (i == count) {
            colours[count++] = s->pixels[at];
        }
    }
    return false;
}

void l4f00242t03_darken(L4F00242T03State *s)
{
    memset(s->pixels, 0, GLASS_BYTES);
    s->is_changed = true;
}

static void take_command(L4F00242T03State *s, uint8_t command)
{
    int64_t now_ns = qemu_clock_get_ns(QEMU_CLOCK_VIRTUAL);

    s->command = command;
    switch (command) {
    case SLEEP_OUT:
        s->is_awake = true;
        s->awake_ns = now_ns;
        break;
    case SLEEP_IN:
        s->is_awake = s->is_on = false;
        break;
    case DISPLAY_ON:
        if (!s->is_awake || now_ns - s->awake_ns < WAKE_NS) {
            imx31_report("the panel was switched on less than 60 ms after it "
                         "was told to wake up");
        } else {
            s->is_on = true;
        }
        break;
    case DISPLAY_OFF:
        s->is_on = false;
        break;
    }
}

static uint32_t l4f00242t03_transfer(SSIPeripheral *dev, uint32_t word)
{
    L4F00242T03State *s = L4F00242T03(dev);

    trace_l4f00242t03_word(word);
    check_state(s);
    if (!is_powered(s) || !level_of(s, LINE_RESET) || !s->was_reset) {
        imx31_report("the panel does not hear the command 0x%03x: it has no "
                     "power or was not reset", word);
    } else if (word >> WORD_BITS) {
        imx31_report("the panel got a word of more than nine bits: 0x%x", word);
    } else if (!(word & PARAMETER)) {
        take_command(s, word);
    } else if (s->command == PIXEL_FORMAT) {
        s->has_format = (word & 0xff) == FORMAT_18_BITS;
    }
    return 0;
}

static void l4f00242t03_line(void *opaque, int line, int level)
{
    L4F00242T03State *s = opaque;

    s->line[line] = level;
    check_state(s);
}

static void l4f00242t03_draw(void *opaque)
{
    L4F00242T03State *s = opaque;

    if (s->is_changed) {
        s->is_changed = false;
        dpy_gfx_update_full(s->console);
    }
}

static void l4f00242t03_invalidate(void *opaque)
{
    L4F00242T03State *s = opaque;

    s->is_changed = true;
}

static const GraphicHwOps l4f00242t03_console_ops = {
    .gfx_update = l4f00242t03_draw,
    .invalidate = l4f00242t03_invalidate,
};

static void l4f00242t03_realize(SSIPeripheral *dev, Error **errp)
{
    ERRP_GUARD();
    L4F00242T03State *s = L4F00242T03(dev);

    memory_region_init_ram(&s->glass, OBJECT(dev), "panel.glass", GLASS_BYTES,
                           errp);
    if (*errp) {
        return;
    }
    s->pixels = memory_region_get_ram_ptr(&s->glass);
    s->console = graphic_console_init(DEVICE(dev), 0, &l4f00242t03_console_ops,
                                      s);
    dpy_gfx_replace_surface(s->console, qemu_create_displaysurface_from(
        L4F_WIDTH, L4F_HEIGHT, PIXMAN_r5g6b5, L4F_WIDTH * 2,
        (uint8_t *)s->pixels));
    memory_region_add_subregion(get_system_memory(), PDK_GLASS_AT, &s->glass);
    qdev_init_gpio_in(DEVICE(dev), l4f00242t03_line, LINES);
}

static void l4f00242t03_reset(DeviceState *dev)
{
    L4F00242T03State *s = L4F00242T03(dev);

    forget(s);
    s->was_reset = false;
    l4f00242t03_darken(s);
}

static const VMStateDescription vmstate_l4f00242t03 = {
    .name = TYPE_L4F00242T03,
    .version_id = 1,
    .minimum_version_id = 1,
    .fields = (VMStateField[]) {
        VMSTATE_SSI_PERIPHERAL(parent_obj, L4F00242T03State),
        VMSTATE_UINT8_ARRAY(line, L4F00242T03State, LINES),
        VMSTATE_UINT8(command, L4F00242T03State),
        VMSTATE_BOOL(was_reset, L4F00242T03State),
        VMSTATE_BOOL(has_format, L4F00242T03State),
        VMSTATE_BOOL(is_awake, L4F00242T03State),
        VMSTATE_BOOL(is_on, L4F00242T03State),
        VMSTATE_INT64(awake_ns, L4F00242T03State),
        VMSTATE_END_OF_LIST()
    },
};

static Property l4f00242t03_properties[] = {
    DEFINE_PROP_LINK("power", L4F00242T03State, power, TYPE_MC13783,
                     MC13783State *),
    DEFINE_PROP_LINK("iomux", L4F00242T03State, iomux, TYPE_IMX31_IOMUX,
                     IMX31IomuxState *),
    DEFINE_PROP_END_OF_LIST(),
};

static void l4f00242t03_class_init(ObjectClass *klass, void *data)
{
    DeviceClass *dc = DEVICE_CLASS(klass);
    SSIPeripheralClass *k = SSI_PERIPHERAL_CLASS(klass);

    k->realize = l4f00242t03_realize;
    k->transfer = l4f00242t03_transfer;
    k->cs_polarity = SSI_CS_LOW;
    dc->reset = l4f00242t03_reset;
    dc->vmsd = &vmstate_l4f00242t03;
    dc->desc = "Epson L4F00242T03 panel";
    device_class_set_props(dc, l4f00242t03_properties);
}

static const TypeInfo l4f00242t03_info = {
    .name = TYPE_L4F00242T03,
    .parent = TYPE_SSI_PERIPHERAL,
    .instance_size = sizeof(L4F00242T03State),
    .class_init = l4f00242t03_class_init,
};

static void l4f00242t03_register_types(void)
{
    type_register_static(&l4f00242t03_info);
}

type_init(l4f00242t03_register_types)
