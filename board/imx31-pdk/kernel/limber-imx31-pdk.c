// SPDX-License-Identifier: GPL-2.0-only OR MIT
/*
 * The panel of the i.MX31 PDK on a device-tree kernel.
 *
 * mx3fb and the IPU's driver support platform data only, and the kernel has no
 * pin controller driver for the i.MX31. So on "fsl,imx31-pdk" this file routes
 * the pins of the device tree, registers the two devices with the Epson panel's
 * timing, and enables what the device tree disables for QEMU's machine kzm, which
 * has no IPU and keeps its simple framebuffer. Addresses, pins and timing are
 * those of Freescale's board support (mach-mx31_3ds.c, up to Linux 5.9).
 */
#include <linux/clk.h>
#include <linux/dma-mapping.h>
#include <linux/init.h>
#include <linux/io.h>
#include <linux/kernel.h>
#include <linux/of.h>
#include <linux/of_address.h>
#include <linux/platform_data/video-mx3fb.h>
#include <linux/platform_device.h>
#include <linux/slab.h>
#include <linux/string.h>

#define IPU_INT_CTRL_1 0x28
#define IOMUX_MUX      0x00c
#define IOMUX_PAD      0x154

/* The cells of a range of pins in the device tree. */
enum {
	PIN_FIRST,
	PIN_LAST,
	PIN_MODE,
	PIN_PAD, /* 0 keeps the pad as it is */
	PIN_CELLS
};

static const struct fb_videomode panel_mode = {
	.name = "Epson-VGA",
	.refresh = 60,
	.xres = 480,
	.yres = 640,
	.pixclock = 41701,
	.left_margin = 20,
	.right_margin = 41,
	.upper_margin = 10,
	.lower_margin = 5,
	.hsync_len = 20,
	.vsync_len = 10,
	.sync = FB_SYNC_OE_ACT_HIGH | FB_SYNC_CLK_INVERT,
	.vmode = FB_VMODE_NONINTERLACED,
};

/* A register has four pins of one byte. */
static void __init route_pin(void __iomem *iomux, unsigned int pin, u32 mode)
{
	void __iomem *reg = iomux + IOMUX_MUX + (pin & ~3u);
	unsigned int shift = (pin & 3) * 8;

	writel((readl(reg) & ~(0xffu << shift)) | mode << shift, reg);
}

/* A register has three pads of ten bits; pad 0 is the third of the first. */
static void __init set_pad(void __iomem *iomux, unsigned int pin, u32 config)
{
	void __iomem *reg = iomux + IOMUX_PAD + (pin + 2) / 3 * 4;
	unsigned int shift = (pin + 2) % 3 * 10;

	writel((readl(reg) & ~(0x1ffu << shift)) | config << shift, reg);
}

static void __init route_range(void __iomem *iomux, const u32 *range)
{
	u32 pin;

	for (pin = range[PIN_FIRST]; pin <= range[PIN_LAST]; pin++) {
		route_pin(iomux, pin, range[PIN_MODE]);
		if (range[PIN_PAD])
			set_pad(iomux, pin, range[PIN_PAD]);
	}
}

static int __init route_pins(void)
{
	struct device_node *node =
		of_find_compatible_node(NULL, NULL, "limber,imx31-pins");
	void __iomem *iomux = of_iomap(node, 0);
	int count = of_property_count_elems_of_size(
		node, "limber,pins", PIN_CELLS * sizeof(u32));
	u32 range[PIN_CELLS];
	int i, error = iomux ? 0 : -ENOMEM;

	for (i = 0; i < count * PIN_CELLS && !error; i++) {
		error = of_property_read_u32_index(
			node, "limber,pins", i, &range[i % PIN_CELLS]);
		if (!error && i % PIN_CELLS == PIN_CELLS - 1)
			route_range(iomux, range);
	}
	if (iomux)
		iounmap(iomux);
	of_node_put(node);
	return error ? error : count < 0 ? count : 0;
}

/* limber_ipu on the command line assumes an IPU, to test the code below. */
static bool ipu_is_assumed __initdata;

static int __init assume_ipu(char *value)
{
	ipu_is_assumed = true;
	return 0;
}
early_param("limber_ipu", assume_ipu);

/* A register of an IPU keeps what is written; on kzm it reads as 0. */
static bool __init has_ipu(struct device_node *node)
{
	struct clk *clock = of_clk_get(node, 0);
	void __iomem *base;
	bool found = false;

	if (IS_ERR(clock))
		return false;
	base = of_iomap(node, 0);
	if (base && !clk_prepare_enable(clock)) {
		writel(1, base + IPU_INT_CTRL_1);
		found = readl(base + IPU_INT_CTRL_1) == 1;
		writel(0, base + IPU_INT_CTRL_1);
		clk_disable_unprepare(clock);
	}
	if (base)
		iounmap(base);
	clk_put(clock);
	return found || ipu_is_assumed;
}

static int __init set_property(
	struct device_node *node, const char *name, const char *value)
{
	struct property *property;
	int error;

	if (!node)
		return -ENODEV;
	property = kzalloc(sizeof(*property), GFP_KERNEL);
	if (!property)
		return -ENOMEM;
	property->name = (char *)name;
	property->value = (void *)value;
	property->length = strlen(value) + 1;
	error = of_update_property(node, property);
	if (error)
		kfree(property);
	return error;
}

/*
 * Enables the flash if the system starts from it; a system that was loaded into
 * memory leaves it alone. Reading the marks of all blocks takes a second, so the
 * driver keeps a table of the bad blocks in the last four blocks.
 */
static int __init enable_flash(struct device_node *nand)
{
	int error;

	if (!strstr(boot_command_line, "ubi.mtd="))
		return 0;
	error = set_property(nand, "status", "okay");
	return error ? error : set_property(nand, "nand-on-flash-bbt", "");
}

/* Enables the buses, the keypad and, if it is used, the flash; disables the
 * simple framebuffer. */
static int __init enable_board(void)
{
	struct device_node *nand =
		of_find_compatible_node(NULL, NULL, "fsl,imx31-nand");
	struct device_node *nodes[] = {
		of_find_node_by_path("spi0"),
		of_find_node_by_path("spi1"),
		of_find_compatible_node(NULL, NULL, "fsl,imx31-kpp"),
		of_get_compatible_child(of_chosen, "simple-framebuffer"),
	};
	unsigned int i, last = ARRAY_SIZE(nodes) - 1;
	int error = 0;

	for (i = 0; i <= last; i++) {
		if (!error)
			error = set_property(nodes[i], "status",
				i == last ? "disabled" : "okay");
		of_node_put(nodes[i]);
	}
	if (!error)
		error = enable_flash(nand);
	of_node_put(nand);
	return error;
}

static int __init register_picture(struct device_node *node, u32 base)
{
	const struct resource ipu_registers[] = {
		DEFINE_RES_MEM(base, 0x60),
		DEFINE_RES_MEM(base + 0x88, 0x2c),
	};
	const struct resource screen_registers[] = {
		DEFINE_RES_MEM(base + 0xb4, 0x10c),
	};
	struct platform_device_info info = {
		.fwnode = of_fwnode_handle(node),
		.of_node_reused = true,
		.name = "ipu-core",
		.id = PLATFORM_DEVID_NONE,
		.res = ipu_registers,
		.num_res = ARRAY_SIZE(ipu_registers),
		.dma_mask = DMA_BIT_MASK(32),
	};
	struct mx3fb_platform_data panel = {
		.name = panel_mode.name,
		.mode = &panel_mode,
		.num_modes = 1,
		.disp_data_fmt = IPU_DISP_DATA_MAPPING_RGB666,
	};
	struct platform_device *ipu = platform_device_register_full(&info);

	if (IS_ERR(ipu))
		return PTR_ERR(ipu);
	panel.dma_dev = &ipu->dev;
	info.name = "mx3_sdc_fb";
	info.res = screen_registers;
	info.num_res = ARRAY_SIZE(screen_registers);
	info.data = &panel;
	info.size_data = sizeof(panel);
	return PTR_ERR_OR_ZERO(platform_device_register_full(&info));
}

/* Runs before the device tree's devices and the IPU's driver are set up. */
static int __init limber_imx31_pdk_init(void)
{
	struct device_node *node;
	struct resource registers;
	int error;

	if (!of_machine_is_compatible("fsl,imx31-pdk"))
		return 0;
	node = of_find_compatible_node(NULL, NULL, "limber,imx31-ipu");
	if (!node || of_address_to_resource(node, 0, &registers)) {
		pr_err("limber: no limber,imx31-ipu in the device tree: no panel\n");
		of_node_put(node);
		return 0;
	}
	if (!has_ipu(node)) {
		pr_info("limber: no IPU here: the simple framebuffer is the screen\n");
		of_node_put(node);
		return 0;
	}
	error = route_pins();
	if (!error)
		error = enable_board();
	if (!error)
		error = register_picture(node, registers.start);
	if (error)
		pr_err("limber: the panel cannot be set up: %d\n", error);
	of_node_put(node);
	return 0;
}
arch_initcall(limber_imx31_pdk_init);
