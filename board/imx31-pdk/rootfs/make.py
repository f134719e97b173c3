#!/usr/bin/env python3
"""make.py SYSROOT LIMBER HOST-LIMBER ASSETS DIR: collects the board's root file system.

It writes the tree to DIR/root, for the flash image, and to DIR/list a list of
it for the kernel's gen_init_cpio, which can make device nodes and owners
without being root. Libraries come from the sysroot (programs.py). The environment's
CONSOLE_PASSWORD lets root log in on the console.
"""
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parents[2] / "toolchain/package"))
from programs import Programs, run  # noqa: E402

FOLDERS = ("bin", "dev", "etc", "lib", "proc", "run", "sbin", "sys", "usr",
           "usr/bin", "usr/lib", "usr/sbin", "usr/share", "usr/share/limber")


class Tree(Programs):
    def __init__(self, sysroot, root):
        super().__init__(sysroot, root)
        for folder in FOLDERS:
            (root / folder).mkdir(parents=True)

    def link(self, name, target):
        os.symlink(target, self.root / name)

    def busybox(self):
        source = self.sysroot / "usr/bin/busybox"
        self.file(source, "bin/busybox", 0o755)
        for applet in run("qemu-arm", str(source), "--list").split():
            if applet != "busybox":
                self.link("bin/" + applet, "busybox")
        self.link("sbin/init", "../bin/busybox")
        # The kernel starts /init of an initramfs.
        self.link("init", "sbin/init")

    def password(self, password):
        """Lets root log in on the console."""
        shadow = self.root / "etc/shadow"
        secret = subprocess.run(
            ["qemu-arm", str(self.sysroot / "usr/bin/busybox"), "mkpasswd",
             "-m", "sha512", "-P", "0"], input=password + "\n", check=True,
            stdout=subprocess.PIPE, text=True).stdout.strip()
        shadow.write_text(shadow.read_text().replace(
            "root:!:", f"root:{secret}:", 1))


def collect(sysroot, limber, host_limber, assets, root):
    tree = Tree(sysroot, root)
    tree.busybox()
    tree.limber(limber, "usr/bin/limber")
    tree.models(assets, host_limber, "usr/share/limber")
    for path in sorted(HERE.glob("etc/*")) + sorted(HERE.glob("usr/sbin/*")):
        mode = 0o755 if os.access(path, os.X_OK) else 0o644
        if path.name == "shadow":
            mode = 0o600
        tree.file(path, str(path.relative_to(HERE)), mode)
    settings = HERE.parent / "limber.conf"
    if settings.exists():
        tree.file(settings, "etc/limber.conf", 0o644)
    tree.link("tmp", "run/tmp")
    tree.link("var", "run")
    os.symlink("/proc/mounts", root / "etc/mtab")
    if password := os.environ.get("CONSOLE_PASSWORD"):
        tree.password(password)
    for path in (root, *root.rglob("*")):
        if path.is_dir() and not path.is_symlink():
            path.chmod(0o755)  # whatever the umask
        os.utime(path, (0, 0), follow_symlinks=False)


def listed(root):
    """Returns sorted lines for gen_init_cpio."""
    lines = ["nod /dev/console 0600 0 0 c 5 1"]
    for folder, folders, files in os.walk(root):
        folders.sort()
        for name in sorted(folders + files):
            path = pathlib.Path(folder) / name
            inside = "/" + str(path.relative_to(root))
            if path.is_symlink():
                lines.append(f"slink {inside} {os.readlink(path)} 0777 0 0")
            elif path.is_dir():
                lines.append(f"dir {inside} 0755 0 0")
            else:
                mode = path.stat().st_mode & 0o777
                lines.append(f"file {inside} {path} {mode:04o} 0 0")
    # Sorted by path, a folder comes before its content.
    return sorted(lines, key=lambda line: line.split()[1])


def main():
    if len(sys.argv) != 6:
        sys.exit(__doc__.splitlines()[0])
    sysroot, limber, host_limber, assets, out = map(pathlib.Path, sys.argv[1:])
    shutil.rmtree(out, ignore_errors=True)
    collect(sysroot, limber, host_limber, assets, out / "root")
    (out / "list").write_text("\n".join(listed(out / "root")) + "\n")


if __name__ == "__main__":
    main()
