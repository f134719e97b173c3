"""The power goes while `flash.sh write` writes the NAND, and while the board runs:
afterwards `flash.sh` finishes, and the board starts."""
import contextlib
import os
import random

from harness import (FOLDER, IMAGE, Error, booted, check, done, flashed,
                     is_drawn, nand, needs_pdk, wait_until)

CUTS = 50
SEED = 31

needs_pdk()
FOLDER.mkdir(parents=True, exist_ok=True)
path = FOLDER / "nand.bin"
whole = [(IMAGE / name).read_bytes() for name in ("zImage-dtb", "rootfs.ubi")]
# A beginning of each is as good for the order of erases and programs.
short = [data[:400_000] for data in whole]


def write(chip, kernel, rootfs):
    """What the boot loader does on the command of flash.sh: a part that the flash
    holds already is left as it is, any other is erased and written."""
    for data, at, limit, trim in (
            (kernel, nand.KERNEL_AT, nand.KERNEL_BYTES, False),
            (rootfs, nand.ROOTFS_AT, nand.ROOTFS_BYTES, True)):
        try:
            if chip.read(at, len(data), limit) == data:
                continue
        except nand.Error:
            pass
        chip.erase(at, limit)
        chip.write(at, data, limit, trim)


def operations():
    """The erases and programs of a whole write."""
    path.unlink(missing_ok=True)
    chip = nand.Nand(path, cut_after=10 ** 9)
    write(chip, *short)
    chip.close()
    return 10 ** 9 - chip.cut_after


def holds(chip, kernel, rootfs):
    return (chip.read(nand.KERNEL_AT, len(kernel), nand.KERNEL_BYTES) == kernel
            and chip.read(nand.ROOTFS_AT, len(rootfs), nand.ROOTFS_BYTES)
            == rootfs)


def start():
    machine = booted(nand=path, shell=False)
    shown_s = wait_until(machine, lambda: is_drawn(machine.frame()), 15)
    said = machine.log()[-3000:]
    machine.stop()
    return shown_s, said


def ends(machine):
    """Waits until QEMU ends or the picture is there; whether it has ended."""
    while machine.process.poll() is None:
        try:
            if is_drawn(machine.frame()):
                return False
        except (Error, OSError):
            machine.process.wait(10)
    return True


total = operations()
chance = random.Random(SEED)
unfinished = []
for cut in [1, total] + sorted(chance.sample(range(2, total), CUTS - 2)):
    path.unlink()
    chip = nand.Nand(path, cut_after=cut)
    with contextlib.suppress(InterruptedError):
        write(chip, *short)
    chip.close()
    chip = nand.Nand(path)
    write(chip, *short)
    if not holds(chip, *short):
        unfinished.append(cut)
    chip.close()
check(f"after power cuts at {CUTS} of {total} erases and programs the same "
      "command finishes", not unfinished, unfinished)
path.unlink()
chip = nand.Nand(path, cut_after=3000)
with contextlib.suppress(InterruptedError):
    write(chip, *whole)
chip.close()
chip = nand.Nand(path)
write(chip, *whole)
chip.close()
shown_s, said = start()
check("and the whole image starts after one", shown_s is not None, said)

# The first start writes UBI's volume table and the table of bad blocks.
for cut in range(1, 4):
    flashed().close()
    machine = booted(nand=path, shell=False, power=False)
    machine.monitor.run("qom-set", path="/machine/nand", property="power-cut",
                        value=cut)
    machine.power_on()
    was_cut = ends(machine)
    machine.stop()
    shown_s, said = start()
    check(f"power cut at write {cut} of the first start"
          f"{'' if was_cut else ' (it has fewer)'}: the next one starts",
          shown_s is not None, said)
    if not was_cut:
        break
os.unlink(path)
done()
