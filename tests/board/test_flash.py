"""The UBI image on a simulated NAND of the board's kind (the kernel's nandsim):
the kernel mounts it, and it contains the root file system."""
import re

from harness import BY_HAND, IMAGE, booted, check, done, guest_tool

# 256 MiB, 2 KiB pages, 128 KiB blocks; only what the image fills uses memory.
NAND = ("modprobe nandsim first_id_byte=0x2c second_id_byte=0xda "
        "third_id_byte=0x00 fourth_id_byte=0x15 parts=8,40,160")
MTD = 2
image = IMAGE / "rootfs.ubi"
check("the image consists of whole blocks",
      image.stat().st_size % (128 * 1024) == 0)

machine = booted(BY_HAND | guest_tool() | {"rootfs.ubi": image}, drivers=True, kind="kzm")
status, said = machine.shell(f"{NAND} && cat /proc/mtd")
check("a NAND of the board's kind", "00020000" in said, said)
status, said = machine.shell(
    f"dd if=/rootfs.ubi of=/dev/mtd{MTD} bs=2048", 120)
check("the image fits its partition", status == 0, said)
status, said = machine.shell(
    f"guest ubi {MTD} && mkdir /run/flash && "
    "mount -t ubifs -o ro ubi0:rootfs /run/flash", 120)
check("UBI finds the volume and UBIFS mounts it", status == 0, said)
status, said = machine.shell(
    "cd /run/flash && find . -type f >/run/files && cd /; "
    "while read -r f; do cmp -s /run/flash/$f /$f || echo NOT-$f; "
    "done </run/files; wc -l </run/files", 120)
differ = re.findall(r"^NOT-(\S+)$", said, re.M)
files = int(re.findall(r"^(\d+)$", said, re.M)[0])
check("and it holds what the initramfs holds",
      # The test replaced the inittab of the initramfs.
      differ == ["./etc/inittab"] and files >= 15, said)
status, said = machine.shell(
    "mount -t proc proc /run/flash/proc; chroot /run/flash /usr/bin/limber "
    "play --frames 2 --display null --demo arm")
check("limber runs from it", status == 0, said)
done()
