"""Collects ARM programs in a folder, with the libraries that they need and limber's
models."""
import pathlib
import re
import shutil
import subprocess
import sys

PREFIX = "arm-linux-gnueabi-"
LIBRARIES = "usr/lib/arm-linux-gnueabi"
# Mesa is not among them, because its drivers alone are larger than all the rest.
OPENED = ("libv4lconvert.so.0",)


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE,
                          text=True).stdout


def needed(program):
    out = run(PREFIX + "readelf", "-d", str(program))
    return re.findall(r"\(NEEDED\).*\[(.+)\]", out)


class Programs:
    """The folder root, whose subfolders exist; libraries go to its lib."""

    def __init__(self, sysroot, root):
        self.sysroot = sysroot
        self.root = root
        self.libraries = set()

    def file(self, source, name, mode):
        shutil.copyfile(source, self.root / name)
        (self.root / name).chmod(mode)

    def program(self, source, name):
        """Copies a program or library, stripped, and what it needs (DT_NEEDED)."""
        run(PREFIX + "strip", "-o", str(self.root / name), str(source))
        (self.root / name).chmod(0o755)
        for library in needed(source):
            self.library(library)

    def library(self, name):
        if name in self.libraries:
            return
        self.libraries.add(name)
        source = self.sysroot / LIBRARIES / name
        if not source.exists():
            sys.exit(f"limber: {source} is missing: make build/sysroot.stamp")
        self.program(source, "lib/" + name)

    def limber(self, program, name):
        """Copies limber and the libraries that it opens at run time."""
        self.program(program, name)
        for library in OPENED:
            self.library(library)

    def models(self, assets, host_limber, folder):
        """Copies limber's models. The limber of this machine makes their levels of
        detail, which would take the board half a second at every start."""
        kinds = ("*.glb", "*.ini", "*.character")
        for asset in sorted(a for kind in kinds for a in assets.glob(kind)):
            self.file(asset, f"{folder}/{asset.name}", 0o644)
            if asset.suffix == ".glb":
                levels = self.root / folder / (asset.stem + ".levels")
                run(host_limber, "levels", asset, "-o", levels)
                levels.chmod(0o644)
