/*
 * What the devices of the i.MX31 PDK share: the type of each, and the questions
 * that one device asks another. Every function here is called with QEMU's lock
 * held, from a device's callbacks.
 *
 * SPDX-License-Identifier: GPL-2.0-or-later
 */
#ifndef HW_ARM_IMX31_PDK_H
#define HW_ARM_IMX31_PDK_H

#include "exec/memory.h"
#include "hw/misc/imx31_ccm.h"
#include "hw/sysbus.h"
#include "qom/object.h"

#define TYPE_IMX31_IOMUX "imx31-iomux"
#define TYPE_IMX31_IPU "imx31-ipu"
#define TYPE_IMX31_KPP "imx31-kpp"
#define TYPE_IMX31_NFC "imx31-nfc"
#define TYPE_IMX31_CSPI "imx31-cspi"
#define TYPE_PDK_NAND "pdk-nand"
#define TYPE_MC13783 "mc13783"
#define TYPE_L4F00242T03 "l4f00242t03"

OBJECT_DECLARE_SIMPLE_TYPE(IMX31IomuxState, IMX31_IOMUX)
OBJECT_DECLARE_SIMPLE_TYPE(IMX31IPUState, IMX31_IPU)
OBJECT_DECLARE_SIMPLE_TYPE(IMX31KPPState, IMX31_KPP)
OBJECT_DECLARE_SIMPLE_TYPE(IMX31NFCState, IMX31_NFC)
OBJECT_DECLARE_SIMPLE_TYPE(IMX31CSPIState, IMX31_CSPI)
OBJECT_DECLARE_SIMPLE_TYPE(PDKNandState, PDK_NAND)
OBJECT_DECLARE_SIMPLE_TYPE(MC13783State, MC13783)
OBJECT_DECLARE_SIMPLE_TYPE(L4F00242T03State, L4F00242T03)

/*
 * Says what the guest does wrong with the board, as one line of the log that
 * -D names (-d guest_errors). The text begins with the device.
 */
void imx31_report(const char *format, ...) G_GNUC_PRINTF(1, 2);

/* The gates of the clock controller: 16 in each of CGR0, CGR1 and CGR2. */
enum {
    IMX31_GATE_KPP = 16 + 10,
    IMX31_GATE_IPU = 16 + 11,
    IMX31_GATE_CSPI1 = 32 + 1,
    IMX31_GATE_CSPI2 = 32 + 2,
};

/* Whether the clock behind a gate runs. */
bool imx31_clock_runs(const IMX31CCMState *ccm, unsigned gate);

/*
 * The result of an access to a device behind the gate: MEMTX_OK, or, when its
 * clock is off, MEMTX_ERROR, which the processor takes as an external abort and
 * which is reported with the device's name and the offset.
 */
MemTxResult imx31_clock_access(const IMX31CCMState *ccm, unsigned gate,
                               const char *name, hwaddr offset);

/* The display clock (HSP), in Hz, from the registers of the clock controller. */
uint64_t imx31_hsp_hz(const IMX31CCMState *ccm);

/* Modes of a pin in the multiplexer. */
enum {
    IMX31_PIN_GPIO = 0x01,
    IMX31_PIN_FUNCTION = 0x12,
    IMX31_PIN_ALTERNATE_1 = 0x24,
};

/*
 * Buttons at the pins KEY_ROW4 to 7 and KEY_COL4 to 7. The multiplexer's inputs
 * "button" are these pins, its outputs lines 18 to 25 of GPIO2.
 */
enum {
    IMX31_BUTTONS = 8,
    IMX31_BUTTON_LINE = 18,
};

/* A range of pins that a device needs in one mode. */
struct imx31_pins {
    uint16_t first;
    uint16_t last;
    uint8_t mode;
};

/* Whether the pin (its number in the multiplexer, below 328) has this mode. */
bool imx31_iomux_routes(const IMX31IomuxState *iomux, unsigned pin,
                        unsigned mode);

/* The first pin of the ranges without its mode, or -1 when all are routed. */
int imx31_iomux_missing(const IMX31IomuxState *iomux,
                        const struct imx31_pins *pins, unsigned count);

/* How the IPU reads a picture from memory. */
struct imx31_scan {
    uint32_t address;
    uint32_t width;
    uint32_t height;
    uint32_t stride; /* bytes from row to row */
    uint32_t bytes; /* of a pixel; 0 for a format that is not modelled */
    bool is_565;
    uint8_t offset[3]; /* of red, green and blue from the highest bit */
    uint8_t bits[3]; /* of red, green and blue */
};

enum {
    IMX31_SCAN_MAX = 4096, /* no more pixels of a row are read */
};

/*
 * Decodes the 16 words that the channel parameter memory has for a channel; the
 * picture's address is that of buffer 0 or 1.
 */
struct imx31_scan imx31_scan_of(const uint32_t *words, unsigned buffer);

/*
 * Reads a line into pixels[IMX31_SCAN_MAX] as RGB565. Returns the number of
 * pixels.
 */
unsigned imx31_scan_read(const struct imx31_scan *scan, uint32_t line,
                         uint16_t *pixels);

/*
 * The first begins to watch the picture's memory. The second tells whether it
 * was written since then, and begins again.
 */
void imx31_scan_watch(const struct imx31_scan *scan);
bool imx31_scan_was_written(const struct imx31_scan *scan);

/* The power chip's regulators that the board uses for its panel. */
enum mc13783_regulator {
    MC13783_VGEN,
    MC13783_VMMC1,
};

/* The regulator's output in millivolts, 0 when it is off. */
unsigned mc13783_millivolts(const MC13783State *chip,
                            enum mc13783_regulator regulator);

/*
 * The panel: 480x640 pixels of RGB565. What it shows can be read from outside at
 * this address, which the processor cannot reach.
 */
#define PDK_GLASS_AT 0x100000000ull

enum {
    L4F_WIDTH = 480,
    L4F_HEIGHT = 640,
};

/*
 * Why the panel shows nothing whatever it receives, as a clause for a report,
 * or NULL when it shows pictures.
 */
const char *l4f00242t03_fault(L4F00242T03State *panel);

/*
 * Shows a row of pixels, from the panel's pixel (x, y) on; those outside of the
 * panel are left out. Returns whether any has changed.
 */
bool l4f00242t03_show(L4F00242T03State *panel, int x, int y,
                      const uint16_t *pixels, int count);

/* Whether the panel shows more colours than a text console does. */
bool l4f00242t03_is_drawn(const L4F00242T03State *panel);

/* Makes the whole panel dark. */
void l4f00242t03_darken(L4F00242T03State *panel);

/* The NAND chip: 131072 pages of 2048 and 64 bytes, 64 pages a block. */
enum {
    PDK_NAND_PAGE = 2048,
    PDK_NAND_SPARE = 64,
    PDK_NAND_RAW = PDK_NAND_PAGE + PDK_NAND_SPARE,
    PDK_NAND_BLOCK_PAGES = 64,
    PDK_NAND_PAGES = 131072,
};

/* One bus cycle, with a command or with a byte of the address. */
void pdk_nand_command(PDKNandState *nand, uint8_t command);
void pdk_nand_address(PDKNandState *nand, uint8_t byte);

/* Data cycles: count bytes from the chip or to it. */
void pdk_nand_read(PDKNandState *nand, uint8_t *bytes, unsigned count);
void pdk_nand_write(PDKNandState *nand, const uint8_t *bytes, unsigned count);

/* How long the chip stays busy after the command, in nanoseconds. */
int64_t pdk_nand_busy_ns(const PDKNandState *nand);

/*
 * Reads a raw page of PDK_NAND_RAW bytes. Returns false, with all bytes 0xff, if
 * there is no such page, no file, or the file cannot be read.
 */
bool pdk_nand_load_page(PDKNandState *nand, unsigned page, uint8_t *raw);

/* The controller stores a page in parts of 512 bytes, each with 16 spare. */
enum {
    IMX31_NFC_PART = 512,
    IMX31_NFC_SPARE = 16,
    IMX31_NFC_PARTS = 4,
    IMX31_NFC_ECC_AT = 6,
};

enum imx31_ecc {
    IMX31_ECC_GOOD,
    IMX31_ECC_CORRECTED,
    IMX31_ECC_FAILED,
};

/*
 * Computes the three bytes of a part's code. For each of the 12 bits of a
 * position, which is 0 to 4095, the code has two parities: of the data bits
 * whose position has that bit set, and of the others. It is stored complemented,
 * so that an erased part has an erased code.
 */
void imx31_ecc_compute(const uint8_t *part, uint8_t *code);

/* Checks a part against its code, and corrects one wrong bit of the part. */
enum imx31_ecc imx31_ecc_correct(uint8_t *part, const uint8_t *code);

/*
 * Does what RedBoot does with "fis load kernel; exec -c COMMAND_LINE": loads the
 * kernel, with the device tree behind it, from the flash's partition at 1 MiB
 * to 1 MiB of the memory, skipping blocks that are marked bad and correcting
 * errors, and puts the tags with the command line at 0x100 of the memory.
 * Returns the kernel's address, or 0 after a message on standard error.
 */
hwaddr redboot_load_kernel(PDKNandState *nand, hwaddr memory,
                           uint64_t memory_bytes, const char *command_line);

#endif
