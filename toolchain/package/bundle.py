#!/usr/bin/env python3
"""bundle.py SYSROOT LIMBER HOST-LIMBER OUT: packs limber for other boards.

OUT/limber-VERSION-armv6.tar.gz holds limber, its models and all libraries that it
needs. It runs on any board with an ARMv6 core or a later one, VFP and Linux 3.2,
whatever libraries the board has. The same input gives the same bytes. HOST-LIMBER is
the program for this machine.
"""
import gzip
import pathlib
import re
import sys
import tarfile
import tempfile

from programs import Programs, run

TOP = pathlib.Path(__file__).resolve().parents[2]
# The Debian packages of all libraries, linked in or copied, for their licences.
PACKAGES = ("libc6", "libjpeg62-turbo", "libv4lconvert0t64", "libjansson4",
            "libpng16-16t64", "zlib1g", "libgif7", "libgpiod3", "libdrm2",
            "libinih1")
START = """#!/bin/sh
# Starts limber with the libraries of this folder.
here=$(dirname "$(readlink -f "$0")")
exec "$here/lib/ld-linux.so.3" --library-path "$here/lib" "$here/bin/limber" "$@"
"""


def collect(sysroot, limber, host_limber, root):
    for folder in ("bin", "lib", "share/limber", "share/doc"):
        (root / folder).mkdir(parents=True)
    tree = Programs(sysroot, root)
    tree.limber(limber, "bin/limber")
    tree.models(TOP / "assets", host_limber, "share/limber")
    for package in PACKAGES:
        tree.file(sysroot / "usr/share/doc" / package / "copyright",
                  f"share/doc/{package}.txt", 0o644)
    tree.file(TOP / "LICENSE", "share/doc/limber.txt", 0o644)
    (root / "limber").write_text(START)
    (root / "limber").chmod(0o755)


def without_owner(member):
    member.uid = member.gid = member.mtime = 0
    member.uname = member.gname = ""
    if member.isdir():
        member.mode = 0o755  # whatever the umask
    return member


def pack(root, path):
    with open(path, "wb") as file, \
            gzip.GzipFile("", "wb", fileobj=file, mtime=0) as packed, \
            tarfile.open(mode="w", fileobj=packed, format=tarfile.GNU_FORMAT) as tar:
        tar.add(root, root.name, filter=without_owner)


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__.splitlines()[0])
    sysroot, limber, host_limber, out = map(pathlib.Path, sys.argv[1:])
    version = re.match(r"limber (\S+)", run(host_limber, "--version"))[1]
    out.mkdir(parents=True, exist_ok=True)
    path = out / f"limber-{version}-armv6.tar.gz"
    with tempfile.TemporaryDirectory(dir=out) as folder:
        root = pathlib.Path(folder) / "limber"
        collect(sysroot, limber, host_limber, root)
        pack(root, path)
    print(f"  BUNDLE  {path}")


if __name__ == "__main__":
    main()
