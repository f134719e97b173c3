"""The power goes while `flash.sh write` writes the NAND, and while the board runs:
afterwards `flash.sh` finishes, and the board starts. CUTS is the number of moments
(make power-cuts takes 50)."""
import concurrent.futures
import os
import random
import shutil
import time

from harness import (FOLDER, IMAGE, Error, booted, check, done,
                     first_picture_s, flash_write, flashed, nand, needs_pdk)

CUTS = int(os.environ.get("CUTS", 8))
SEED = 31
LOADERS = ("uboot", "redboot")
# This one of the finished chips starts: RedBoot's, cut in the root file system.
STARTED = 6
# flash.sh and the boot loader wait for each other most of the time.
AT_ONCE = 4
PARTS = ((nand.KERNEL_AT, nand.KERNEL_BYTES, "zImage-dtb"),
         (nand.ROOTFS_AT, nand.ROOTFS_BYTES, "rootfs.ubi"))


def trims(loader, at):
    """Whether the boot loader leaves out pages of ones there."""
    return loader == "uboot" and at == nand.ROOTFS_AT


def pages_of(loader, at, data):
    """The number of pages that it programs."""
    pages = [data[i:i + nand.PAGE] for i in range(0, len(data), nand.PAGE)]
    return sum(not trims(loader, at) or page.count(0xFF) != len(page)
               for page in pages)


def moments():
    """Yields a boot loader and the number of the operation at which the power
    goes: at the first and the last erase and program of each part and at some
    between, in turn."""
    chance = random.Random(SEED)
    for number in range(CUTS):
        loader = LOADERS[number // 4 % 2]
        first, phases = 1, []
        for at, size, name in PARTS:
            data = (IMAGE / name).read_bytes()
            for count in (size // nand.BLOCK, pages_of(loader, at, data)):
                phases.append(range(first, first + count))
                first += count
        phase = phases[number % 4]
        if number < 8:
            yield loader, phase[len(phase) // 2]
        elif number < 16:
            yield loader, phase[0]
        elif number < 24:
            yield loader, phase[-1]
        else:
            yield loader, chance.choice(phase)


def whole(loader):
    """A file with the chip as flash.sh leaves it after an uncut write."""
    made = FOLDER / f"{loader}.bin"
    made.unlink(missing_ok=True)
    status, said = flash_write(loader, made)
    check(f"flash.sh writes the image by {loader}", status == 0, said)
    return made


def used():
    """A file with a chip whose partitions are full of other data."""
    made = FOLDER / "used.bin"
    made.unlink(missing_ok=True)
    chip = nand.Nand(made)
    for at, size, _ in PARTS:
        chip.write(at, random.Random(at).randbytes(size), size)
    chip.close()
    return made


def same(path, other):
    """Whether the partitions of two chips are equal, with all spare bytes."""
    first = nand.KERNEL_AT // nand.PAGE * nand.RAW_PAGE
    size = (nand.ROOTFS_AT + nand.ROOTFS_BYTES) // nand.PAGE * nand.RAW_PAGE
    with open(path, "rb") as one, open(other, "rb") as two:
        return one.read(size)[first:] == two.read(size)[first:]


def cut_and_finish(number, loader, cut, before, after):
    """Cuts the power at that operation of flash.sh write, of every second pair
    of moments on a chip that is full, and starts flash.sh again. Returns what is
    wrong, or None."""
    path = FOLDER / f"cut-{number}.bin"
    path.unlink(missing_ok=True)
    if number // 2 % 2:
        shutil.copyfile(before, path)
    status, said = flash_write(loader, path, f"cut={cut}")
    if status != 1 or "the serial line has gone" not in said:
        return f"{loader}: operation {cut} is not cut: {said}"
    status, said = flash_write(loader, path)
    good = status == 0 and same(path, after[loader])
    for name in (path, f"{path}.fis", f"{path}.console"):
        if os.path.exists(name) and (number, name) != (STARTED, path):
            os.unlink(name)
    return None if good else f"{loader}: after operation {cut}: {said}"


def start(path):
    machine = booted(nand=path, shell=False)
    shown_s = first_picture_s(machine, 15)
    said = machine.log()[-3000:]
    machine.stop()
    return shown_s, said


def ends(machine):
    """Waits until QEMU ends or the picture is there; whether it has ended."""
    while machine.process.poll() is None:
        try:
            if machine.first_picture_s():
                return False
            time.sleep(0.02)
        except (Error, OSError):
            machine.process.wait(10)
    return True


needs_pdk()
FOLDER.mkdir(parents=True, exist_ok=True)
full = used()
with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
    uncut = dict(zip(LOADERS, pool.map(whole, LOADERS)))
    results = [pool.submit(cut_and_finish, number, *moment, full, uncut)
               for number, moment in enumerate(moments())]
wrong = [result.result() for result in results if result.result()]
check(f"the power goes at {CUTS} moments while flash.sh writes, and flash.sh, "
      "started again, finishes it", not wrong, "\n".join(wrong))
shown_s, said = start(FOLDER / f"cut-{STARTED}.bin")
check("and the board starts", shown_s is not None, said)

path = FOLDER / "nand.bin"
# The first start writes UBI's volume table and the table of bad blocks.
for cut in range(1, 4):
    flashed().close()
    machine = booted(nand=path, shell=False, power=False)
    machine.monitor.run("qom-set", path="/machine/nand", property="power-cut",
                        value=cut)
    machine.power_on()
    was_cut = ends(machine)
    machine.stop()
    shown_s, said = start(path)
    check(f"power cut at write {cut} of the first start"
          f"{'' if was_cut else ' (it has fewer)'}: the next one starts",
          shown_s is not None, said)
    if not was_cut:
        break
os.unlink(path)
done()
