/*
 * The i.MX31 PDK ("3-Stack"): QEMU's i.MX31 with the parts by which Linux shows
 * pictures on the board's panel, reads its keypad and boots from its flash.
 *
 * With -kernel it starts Linux as QEMU does. Without, it starts the kernel in
 * the NAND with the command line in the property "redboot-command-line", after
 * every reset, and a machine without a kernel in the NAND stops.
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#include "qemu/osdep.h"
#include "exec/address-spaces.h"
#include "hw/arm/boot.h"
#include "hw/arm/fsl-imx31.h"
#include "hw/boards.h"
#include "hw/irq.h"
#include "hw/misc/unimp.h"
#include "hw/qdev-properties-system.h"
#include "hw/qdev-properties.h"
#include "hw/ssi/ssi.h"
#include "imx31_pdk.h"
#include "qapi/error.h"
#include "qemu/error-report.h"
#include "qemu/units.h"
#include "sysemu/blockdev.h"
#include "sysemu/reset.h"
#include "sysemu/runstate.h"

#define MACHINE_ID 1511
#define MEMORY_AT FSL_IMX31_SDRAM0_ADDR
#define TAGS_AT 0x100

#define SELECT_2 2
#define GPIO_PANEL_RESET 24
#define GPIO_PANEL_ENABLE 25
#define GPIO_POWER 3

/* RedBoot runs the core at 532 MHz, AHB and display clock at 133 MHz. */
#define CLOCK_CONTROL 0x074b0b7d
#define CLOCK_PLL (51 << 16 | 10 << 10 | 12)
#define CLOCK_DIVIDERS (0xff800000 | 7 << 16 | 3 << 11 | 5 << 8 | 1 << 6 | 3 << 3)

#define TYPE_IMX31_PDK MACHINE_TYPE_NAME("imx31-pdk")
OBJECT_DECLARE_SIMPLE_TYPE(IMX31PDKState, IMX31_PDK)

struct IMX31PDKState {
    MachineState parent_obj;

    FslIMX31State soc;
    PDKNandState *nand;
    char *command_line;
};

/* Regions of the chip without a model here: they read as zero. */
static const struct {
    const char *name;
    hwaddr at;
    uint64_t bytes;
} absent[] = {
    { "l2-cache", 0x30000000, 0x1000 },
    { "aips1", 0x43f00000, 0x100000 },
    { "spba", 0x50000000, 0x100000 },
    { "aips2", 0x53f00000, 0x100000 },
    { "rompatch", 0x60000000, 0x1000 },
    { "debug-board", 0xb6000000, 0x2000000 },
    { "external-memory", 0xb8001000, 0x4000 },
};

static struct arm_boot_info boot_info = {
    .loader_start = MEMORY_AT,
    .board_id = MACHINE_ID,
};

static qemu_irq interrupt(IMX31PDKState *s, int number)
{
    return qdev_get_gpio_in(DEVICE(&s->soc.avic), number);
}

static DeviceState *new_device(IMX31PDKState *s, const char *type,
                               const char *name)
{
    DeviceState *dev = qdev_new(type);

    object_property_add_child(OBJECT(s), name, OBJECT(dev));
    return dev;
}

static void link_to(DeviceState *dev, const char *name, void *object)
{
    object_property_set_link(OBJECT(dev), name, OBJECT(object), &error_fatal);
}

static void place(DeviceState *dev, hwaddr at)
{
    sysbus_realize_and_unref(SYS_BUS_DEVICE(dev), &error_fatal);
    sysbus_mmio_map(SYS_BUS_DEVICE(dev), 0, at);
}

static void add_keypad(IMX31PDKState *s, DeviceState *iomux)
{
    DeviceState *kpp = new_device(s, TYPE_IMX31_KPP, "kpp");

    link_to(kpp, "ccm", &s->soc.ccm);
    link_to(kpp, "iomux", iomux);
    place(kpp, 0x43fa8000);
    sysbus_connect_irq(SYS_BUS_DEVICE(kpp), 0, interrupt(s, 24));
}

static void add_flash(IMX31PDKState *s)
{
    DeviceState *nand = new_device(s, TYPE_PDK_NAND, "nand");
    DeviceState *nfc = new_device(s, TYPE_IMX31_NFC, "nfc");
    DriveInfo *drive = drive_get(IF_MTD, 0, 0);

    if (drive) {
        qdev_prop_set_drive_err(nand, "drive", blk_by_legacy_dinfo(drive),
                                &error_fatal);
    }
    qdev_realize_and_unref(nand, NULL, &error_fatal);
    s->nand = PDK_NAND(nand);
    link_to(nfc, "nand", nand);
    place(nfc, FSL_IMX31_NAND_ADDR);
    sysbus_connect_irq(SYS_BUS_DEVICE(nfc), 0, interrupt(s, 33));
}

static DeviceState *add_bus(IMX31PDKState *s, DeviceState *iomux, int number,
                            hwaddr at, int irq)
{
    g_autofree char *name = g_strdup_printf("cspi%d", number);
    DeviceState *dev = new_device(s, TYPE_IMX31_CSPI, name);

    qdev_prop_set_uint8(dev, "number", number);
    link_to(dev, "ccm", &s->soc.ccm);
    link_to(dev, "iomux", iomux);
    place(dev, at);
    sysbus_connect_irq(SYS_BUS_DEVICE(dev), 0, interrupt(s, irq));
    return dev;
}

/* Connects a device to SS2 of the bus. */
static void add_to_bus(DeviceState *dev, DeviceState *bus)
{
    ssi_realize_and_unref(dev, (SSIBus *)qdev_get_child_bus(bus, "spi"),
                          &error_fatal);
    qdev_connect_gpio_out_named(bus, "select", SELECT_2,
                                qdev_get_gpio_in_named(dev, SSI_GPIO_CS, 0));
}

static void add_picture(IMX31PDKState *s, DeviceState *iomux)
{
    DeviceState *power_bus = add_bus(s, iomux, 2, 0x50010000, 13);
    DeviceState *panel_bus = add_bus(s, iomux, 1, 0x43fa4000, 14);
    DeviceState *power = new_device(s, TYPE_MC13783, "power");
    DeviceState *panel = new_device(s, TYPE_L4F00242T03, "panel");
    DeviceState *ipu = new_device(s, TYPE_IMX31_IPU, "ipu");
    DeviceState *gpio3 = DEVICE(&s->soc.gpio[2]);

    add_to_bus(power, power_bus);
    qdev_connect_gpio_out(power, 0, qdev_get_gpio_in(
        DEVICE(&s->soc.gpio[0]), GPIO_POWER));
    link_to(panel, "power", power);
    link_to(panel, "iomux", iomux);
    add_to_bus(panel, panel_bus);
    qdev_connect_gpio_out(gpio3, GPIO_PANEL_RESET, qdev_get_gpio_in(panel, 0));
    qdev_connect_gpio_out(gpio3, GPIO_PANEL_ENABLE, qdev_get_gpio_in(panel, 1));
    link_to(ipu, "ccm", &s->soc.ccm);
    link_to(ipu, "iomux", iomux);
    link_to(ipu, "panel", panel);
    place(ipu, 0x53fc0000);
    sysbus_connect_irq(SYS_BUS_DEVICE(ipu), 0, interrupt(s, 42));
    sysbus_connect_irq(SYS_BUS_DEVICE(ipu), 1, interrupt(s, 41));
}

static void imx31_pdk_init(MachineState *machine)
{
    IMX31PDKState *s = IMX31_PDK(machine);
    DeviceState *iomux;

    if (machine->ram_size > FSL_IMX31_SDRAM0_SIZE) {
        error_report("the board has at most %d MiB of memory",
                     (int)(FSL_IMX31_SDRAM0_SIZE / MiB));
        exit(EXIT_FAILURE);
    }
    object_initialize_child(OBJECT(machine), "soc", &s->soc, TYPE_FSL_IMX31);
    qdev_realize(DEVICE(&s->soc), NULL, &error_fatal);
    memory_region_add_subregion(get_system_memory(), MEMORY_AT, machine->ram);
    for (int i = 0; i < ARRAY_SIZE(absent); i++) {
        create_unimplemented_device(absent[i].name, absent[i].at,
                                    absent[i].bytes);
    }
    iomux = new_device(s, TYPE_IMX31_IOMUX, "iomux");
    place(iomux, 0x43fac000);
    for (int i = 0; i < IMX31_BUTTONS; i++) {
        qdev_connect_gpio_out(iomux, i, qdev_get_gpio_in(
            DEVICE(&s->soc.gpio[1]), IMX31_BUTTON_LINE + i));
    }
    add_keypad(s, iomux);
    add_flash(s);
    add_picture(s, iomux);
    if (machine->kernel_filename) {
        boot_info.ram_size = machine->ram_size;
        arm_load_kernel(&s->soc.cpu, machine, &boot_info);
    }
}

static void start_from_flash(IMX31PDKState *s)
{
    MachineState *machine = MACHINE(s);
    ARMCPU *cpu = &s->soc.cpu;
    hwaddr entry = redboot_load_kernel(
        s->nand, MEMORY_AT, machine->ram_size,
        s->command_line ? s->command_line : "");

    cpu_reset(CPU(cpu));
    if (!entry) {
        qemu_system_shutdown_request(SHUTDOWN_CAUSE_HOST_ERROR);
        return;
    }
    cpu->env.regs[0] = 0;
    cpu->env.regs[1] = MACHINE_ID;
    cpu->env.regs[2] = MEMORY_AT + TAGS_AT;
    cpu_set_pc(CPU(cpu), entry);
}

static void imx31_pdk_reset(MachineState *machine, ShutdownCause reason)
{
    IMX31PDKState *s = IMX31_PDK(machine);

    qemu_devices_reset(reason);
    device_cold_reset(DEVICE(s->nand));
    s->soc.ccm.reg[IMX31_CCM_CCMR_REG] = CLOCK_CONTROL;
    s->soc.ccm.reg[IMX31_CCM_MPCTL_REG] = CLOCK_PLL;
    s->soc.ccm.reg[IMX31_CCM_PDR0_REG] = CLOCK_DIVIDERS;
    if (!machine->kernel_filename) {
        start_from_flash(s);
    }
}

static char *get_command_line(Object *obj, Error **errp)
{
    return g_strdup(IMX31_PDK(obj)->command_line);
}

static void set_command_line(Object *obj, const char *value, Error **errp)
{
    IMX31PDKState *s = IMX31_PDK(obj);

    g_free(s->command_line);
    s->command_line = g_strdup(value);
}

static void imx31_pdk_class_init(ObjectClass *klass, void *data)
{
    MachineClass *mc = MACHINE_CLASS(klass);

    mc->desc = "Freescale i.MX31 PDK (ARM1136)";
    mc->init = imx31_pdk_init;
    mc->reset = imx31_pdk_reset;
    mc->default_ram_size = 128 * MiB;
    mc->default_ram_id = "pdk.ram";
    mc->block_default_type = IF_MTD;
    object_class_property_add_str(klass, "redboot-command-line",
                                  get_command_line, set_command_line);
    object_class_property_set_description(klass, "redboot-command-line",
        "the kernel's command line when it starts from the NAND");
}

static const TypeInfo imx31_pdk_info = {
    .name = TYPE_IMX31_PDK,
    .parent = TYPE_MACHINE,
    .instance_size = sizeof(IMX31PDKState),
    .class_init = imx31_pdk_class_init,
};

static void imx31_pdk_register_types(void)
{
    type_register_static(&imx31_pdk_info);
}

type_init(imx31_pdk_register_types)
