"""The image in the NAND: `flash.sh write` through both boot loaders' dialogues,
and the start from the flash through mxc_nand, UBI and UBIFS to the picture, with
bad blocks, wrong bits and blocks that wear out."""
import re

from harness import (FOLDER, PROMPT, Error, booted, check, done,
                     first_picture_s, flash_write, flashed, nand, needs_pdk,
                     note, save)

# Linux's first start from a chip looks for bad blocks in all of it and writes a
# table of them, which later starts find.
FIRST_S, LATER_S = 3.0, 1.5
FIRST_ROOTFS_BLOCK = nand.ROOTFS_AT // nand.BLOCK
BAD_BLOCKS = [8, 9, *range(FIRST_ROOTFS_BLOCK + 1, FIRST_ROOTFS_BLOCK + 40, 5)]
# Free blocks, which UBI erases ten seconds after the first start.
WORN_BLOCKS = [180, 181]

needs_pdk()


def start(path):
    """Boots from the NAND; the time of the first picture, or None."""
    machine = booted(nand=path, shell=False)
    return machine, first_picture_s(machine, 15)


def ecc(machine):
    """The corrected and the failed reads of the root file system's partition."""
    said = machine.shell("cd /sys/class/mtd/mtd2; cat corrected_bits "
                         "ecc_failures; cd /")[1]
    return [int(number) for number in re.findall(r"^(\d+)$", said, re.M)]


FOLDER.mkdir(parents=True, exist_ok=True)
path = FOLDER / "nand.bin"
for loader in ("uboot", "redboot"):
    path.unlink(missing_ok=True)
    status, said = flash_write(loader, path)
    check(f"flash.sh writes the image by {loader}", status == 0, said)
    machine, shown_s = start(path)
    check(f"and it starts from the flash, with a picture on the panel within "
          f"{FIRST_S:.0f} s", shown_s is not None and shown_s <= FIRST_S,
          f"{shown_s} s\n" + machine.log()[-3000:])
    note(f"first picture {shown_s or 0:.2f} s after the kernel's start")
    machine.stop()

machine, shown_s = start(path)
machine.wait(PROMPT)
note(f"the next start, which finds the table of bad blocks, takes "
     f"{shown_s or 0:.2f} s")
check(f"the next start shows its first picture within {LATER_S} s",
      shown_s is not None and shown_s <= LATER_S, f"{shown_s} s")
status, said = machine.shell("mount; cat /proc/mtd")
check("the root file system is UBIFS on the NAND",
      "ubi0:rootfs on / type ubifs (ro" in said and "mxc_nand" in machine.log(),
      said)
check("no read needed a correction", ecc(machine) == [0, 0], ecc(machine))
machine.stop()

chip = flashed()
chip.close()
chip_path = FOLDER / "nand.bin"
chip_path.unlink()
chip = nand.Nand(chip_path)
for block in BAD_BLOCKS:
    chip.mark_bad(block)
chip.close()
status, said = flash_write("uboot", chip_path)
machine, shown_s = start(chip_path)
check(f"with {len(BAD_BLOCKS)} bad blocks it is written and starts",
      status == 0 and shown_s is not None, said + machine.log()[-3000:])
check("UBI leaves the bad ones out",
      f"bad PEBs: {len(BAD_BLOCKS) - 2}" in machine.log(),
      machine.log()[-3000:])
machine.stop()

flashed().close()
machine = booted(nand=path, shell=False, power=False)
machine.monitor.run("qom-set", path="/machine/nand", property="worn-blocks",
                    value=" ".join(map(str, WORN_BLOCKS)))
machine.power_on()
shown_s = first_picture_s(machine, 15)
check("with blocks that cannot be erased any more it starts",
      shown_s is not None, machine.log()[-3000:])
for block in WORN_BLOCKS:
    machine.wait(f"mark PEB {block - FIRST_ROOTFS_BLOCK} as bad")
machine.wait(f"{40 - len(WORN_BLOCKS)} PEBs left in the reserve")
check("UBI marks them and replaces them from its reserve", True)
machine.stop()
machine, shown_s = start(path)
check("and the next start knows them", shown_s is not None and
      f"bad PEBs: {len(WORN_BLOCKS)}" in machine.log(), machine.log()[-3000:])
machine.stop()

chip = flashed()
written = [page for page in range(
    nand.KERNEL_AT // nand.PAGE,
    (nand.ROOTFS_AT + nand.BLOCK * 60) // nand.PAGE)
    if chip.read_raw(page).count(0xFF) != nand.RAW_PAGE]
for page in written:
    chip.flip(page, page * 37 % (nand.PART * 8) + page % 4 * nand.RAW_PART * 8)
chip.close()
machine, shown_s = start(path)
check(f"with a wrong bit in each of {len(written)} pages it starts",
      shown_s is not None, machine.log()[-3000:])
save(machine.frame(), "flipped.png")
machine.wait(PROMPT)
corrected, failed = ecc(machine)
check("each is corrected", corrected > 100 and failed == 0,
      f"{corrected} corrected, {failed} failed")
machine.stop()

chip = flashed()
last = max(page for page in written if page < nand.ROOTFS_AT // nand.PAGE)
chip.flip(last, 100, 200)
chip.close()
try:
    booted(nand=path, shell=False)
    said = "it starts"
except Error as error:
    said = str(error)
check("two wrong bits in the kernel: the boot loader says so and stops",
      "the kernel in the flash is damaged" in said, said)

# The first page of a block has only UBI's headers, about which it would complain
# for half a minute.
chip = flashed()
for page in written:
    if page >= nand.ROOTFS_AT // nand.PAGE + 3 * nand.BLOCK // nand.PAGE and (
            page % (nand.BLOCK // nand.PAGE)):
        chip.flip(page, 8 * nand.RAW_PART + 100, 8 * nand.RAW_PART + 300)
chip.close()
machine = booted(nand=path, shell=False)
found = machine.wait("Kernel panic|VFS: Cannot open root")
check("two wrong bits in every page of the file system: the kernel says so and "
      "stops", bool(found) and "ECC" in machine.log(),
      machine.log()[-3000:])
machine.stop()
done()
