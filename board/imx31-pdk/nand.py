"""The file of the emulated board's NAND chip.

A Nand is the chip as the boot loader and Linux see it through the i.MX31's
flash controller: pages of 2048 bytes in four parts, each with a code that
corrects one wrong bit (qemu/devices/imx31_ecc.c computes the same). The file has
the raw pages, 512 bytes and 16 spare bytes for each part, as the complement of
the chip's bits: an empty sparse file is an erased chip.
"""
import os
import random

PAGE, BLOCK, SIZE = 2048, 128 * 1024, 256 * 1024 * 1024
PART, SPARE, CODE_AT = 512, 16, 6
RAW_PART = PART + SPARE
RAW_PAGE = PAGE // PART * RAW_PART
RAW_BLOCK = BLOCK // PAGE * RAW_PAGE
ERASED_PART = b"\xff" * RAW_PART
COMPLEMENT = bytes(255 - i for i in range(256))

# ODD[k] is a mask of the bits of a part whose position has bit k set.
POSITION_BITS = 12
ODD = [sum(1 << i for i in range(PART * 8) if i >> k & 1)
       for k in range(POSITION_BITS)]


class Error(Exception):
    """A failure of the chip."""


def code_of(part):
    """The three bytes of code of 512 bytes."""
    bits = int.from_bytes(part, "little")
    total = bits.bit_count() & 1
    parities = 0
    for k, mask in enumerate(ODD):
        odd = (bits & mask).bit_count() & 1
        parities |= (odd << 1 | odd ^ total) << 2 * k
    return (~parities & 0xFFFFFF).to_bytes(3, "little")


def correct(part, code):
    """The part, with one wrong bit corrected; Error for more."""
    apart = (int.from_bytes(code, "little")
             ^ int.from_bytes(code_of(part), "little"))
    if apart.bit_count() <= 1:
        return part
    if (apart ^ apart >> 1) & 0x555555 != 0x555555:
        raise Error("an error in the flash that cannot be corrected")
    at = sum((apart >> 2 * k + 1 & 1) << k for k in range(POSITION_BITS))
    good = bytearray(part)
    good[at >> 3] ^= 1 << (at & 7)
    return bytes(good)


def raw_of(data):
    """The raw page of 2048 bytes."""
    raw = bytearray()
    for at in range(0, PAGE, PART):
        part = data[at:at + PART]
        spare = bytearray(b"\xff" * SPARE)
        spare[CODE_AT:CODE_AT + 3] = code_of(part)
        raw += part + spare
    return bytes(raw)


def undone(page):
    """The bits of a raw page that an erase or a program has not reached when the
    power goes in the middle of it: a random half of them."""
    return random.Random(page).getrandbits(RAW_PAGE * 8)


class Nand:
    """The chip in a file, which is made when it does not exist. cut_after is
    the number of programs and erases until its power goes, in the middle of the
    last of them: then it raises InterruptedError, and the page or the block has
    a random half of its bits as they were (undone)."""

    def __init__(self, path, cut_after=None):
        self.file = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
        self.cut_after = cut_after
        os.ftruncate(self.file, SIZE // PAGE * RAW_PAGE)

    def close(self):
        os.close(self.file)

    def is_cut(self):
        if self.cut_after is not None:
            self.cut_after -= 1
        return self.cut_after == 0

    def read_raw(self, page):
        raw = os.pread(self.file, RAW_PAGE, page * RAW_PAGE)
        return raw.translate(COMPLEMENT)

    def write_raw(self, page, raw):
        """Writes a raw page as it is, which no real chip can do."""
        os.pwrite(self.file, raw.translate(COMPLEMENT), page * RAW_PAGE)

    def program(self, page, data):
        """Programs a page: only ones can become zeros."""
        bits = int.from_bytes(raw_of(data), "big")
        cut = self.is_cut()
        if cut:
            bits |= undone(page)
        bits &= int.from_bytes(self.read_raw(page), "big")
        self.write_raw(page, bits.to_bytes(RAW_PAGE, "big"))
        if cut:
            raise InterruptedError("the power is gone")

    def erase_block(self, block):
        if not self.is_cut():
            os.pwrite(self.file, bytes(RAW_BLOCK), block * RAW_BLOCK)
            return
        first = block * BLOCK // PAGE
        for page in range(first, first + BLOCK // PAGE):
            bits = int.from_bytes(self.read_raw(page), "big") | undone(page)
            self.write_raw(page, bits.to_bytes(RAW_PAGE, "big"))
        raise InterruptedError("the power is gone")

    def is_bad(self, block):
        """The mark is the first spare byte of the block's first page."""
        return self.read_raw(block * BLOCK // PAGE)[PART] != 0xFF

    def mark_bad(self, block):
        page = block * BLOCK // PAGE
        raw = bytearray(self.read_raw(page))
        raw[PART] = 0
        self.write_raw(page, bytes(raw))

    def good_blocks(self, offset, size):
        """The good blocks of that part of the chip."""
        return [block for block in range(offset // BLOCK,
                                         (offset + size) // BLOCK)
                if not self.is_bad(block)]

    def erase(self, offset, size):
        for block in self.good_blocks(offset, size):
            self.erase_block(block)

    def pages_from(self, offset, count, limit):
        """Yields so many pages, leaving out bad blocks."""
        pages = BLOCK // PAGE
        for block in self.good_blocks(offset, limit):
            for page in range(block * pages, (block + 1) * pages):
                if count == 0:
                    return
                count -= 1
                yield page
        if count:
            raise Error("too few good blocks")

    def write(self, offset, data, limit, trim=False):
        """Writes the data, filled up to whole pages, into at most limit bytes of
        the chip; with trim pages of ones stay erased."""
        data += b"\xff" * (-len(data) % PAGE)
        pages = self.pages_from(offset, len(data) // PAGE, limit)
        for at, page in zip(range(0, len(data), PAGE), pages):
            part = data[at:at + PAGE]
            if not trim or part.count(0xFF) != PAGE:
                self.program(page, part)

    def read(self, offset, size, limit):
        """Reads and corrects so many bytes."""
        out = bytearray()
        for page in self.pages_from(offset, -(-size // PAGE), limit):
            raw = self.read_raw(page)
            for at in range(0, RAW_PAGE, RAW_PART):
                part = raw[at:at + RAW_PART]
                out += part[:PART] if part == ERASED_PART else correct(
                    part[:PART], part[PART + CODE_AT:PART + CODE_AT + 3])
        return bytes(out[:size])

    def flip(self, page, *bits):
        """Inverts bits of the raw page, by their position."""
        raw = bytearray(self.read_raw(page))
        for bit in bits:
            raw[bit >> 3] ^= 1 << (bit & 7)
        self.write_raw(page, bytes(raw))


# The partitions to which flash.sh writes (flash/files.sh).
KERNEL_AT, KERNEL_BYTES = 0x100000, 0x500000
ROOTFS_AT, ROOTFS_BYTES = 0x600000, 0x1400000


def flashed(path, image):
    """The chip as `flash.sh write` leaves it, in a file."""
    if os.path.exists(path):
        os.unlink(path)
    chip = Nand(path)
    chip.write(KERNEL_AT, (image / "zImage-dtb").read_bytes(), KERNEL_BYTES)
    chip.write(ROOTFS_AT, (image / "rootfs.ubi").read_bytes(), ROOTFS_BYTES,
               trim=True)
    return chip
