#!/usr/bin/env python3
"""settle_ubifs.py IMAGE: makes a UBIFS image of mkfs.ubifs the same for the same
files, whenever it was made: all times of inodes become 0, and the UUID becomes a
digest of the rest. Each changed node gets a new checksum (the kernel's
fs/ubifs/ubifs-media.h describes the nodes).
"""
import hashlib
import pathlib
import struct
import sys
import uuid
import zlib

MAGIC = struct.pack("<I", 0x06101831)
HEADER = struct.Struct("<IIQIBBxx")  # magic, CRC, number, length, type, group
INODE, SUPERBLOCK = 0, 6
ALIGNMENT = 8
# Offset and size in an inode node: the seconds of its three times, 8 bytes each,
# and their nanoseconds, 4 bytes each.
INODE_TIMES = ((56, 24), (80, 12))
UUID_AT = 108


def nodes(image):
    """(offset, length, type) of each node; padding is not one."""
    at = image.find(MAGIC)
    while at >= 0:
        _, crc, _, length, kind, _ = HEADER.unpack_from(image, at)
        if crc != checksum(image[at + 8:at + length]):
            sys.exit(f"limber: the node at byte {at} has a wrong checksum")
        yield at, length, kind
        at = image.find(MAGIC, at + -(-length // ALIGNMENT) * ALIGNMENT)


def checksum(data):
    return zlib.crc32(data) ^ 0xffffffff


def replace(image, node, changes):
    """Writes each (offset in the node, bytes), and then the node's checksum."""
    at, length = node
    for offset, data in changes:
        image[at + offset:at + offset + len(data)] = data
    struct.pack_into("<I", image, at + 4, checksum(image[at + 8:at + length]))


def settle(image):
    found = list(nodes(image))
    superblocks = [node for *node, kind in found if kind == SUPERBLOCK]
    for *node, kind in found:
        if kind == INODE:
            replace(image, node, ((at, bytes(n)) for at, n in INODE_TIMES))
    for node in superblocks:
        replace(image, node, [(UUID_AT, bytes(16))])
    digest = hashlib.sha256(image).digest()[:16]
    for node in superblocks:
        replace(image, node, [(UUID_AT, uuid.UUID(bytes=digest, version=4).bytes)])


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.splitlines()[0])
    path = pathlib.Path(sys.argv[1])
    image = bytearray(path.read_bytes())
    settle(image)
    path.write_bytes(image)


if __name__ == "__main__":
    main()
