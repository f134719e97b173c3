"""What the virtual board has in addition to the image: a camera that can be
switched, and a button F10.

The board's camera is a chip on I2C, which no emulation has: here it is the
kernel's test camera, switched through the second serial line
(guest/camera-switch). F10 is a key of the keypad's matrix, which QEMU's machine
kzm does not have: there it is a GPIO line.
"""
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
BOARD = HERE.parent
sys.path.insert(0, str(BOARD))
import emulation  # noqa: E402
import links  # noqa: E402

# The GPIO line of each button; F10 has the one after those of limber.conf.
LINES = {**links.BUTTONS, "F10": 26}

SETTINGS = f"""
[camera]
camera = /dev/video0,320x240
camera-use = screen
[buttons]
F10 = gpio 53fd0000.gpio {LINES["F10"]} active-high
"""
SERVICES = "ttymxc1::respawn:/usr/sbin/camera-switch\n"
SERIAL = ("-chardev", "socket,id=camera,path=camera.sock,server=on,wait=off",
          "-serial", "chardev:camera")


def run(*command, **how):
    try:
        return subprocess.run(command, check=True, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, **how).stdout
    except FileNotFoundError:
        raise emulation.Error(f"{command[0]} is missing: "
                              "toolchain/install.sh board") from None
    except subprocess.CalledProcessError as error:
        said = error.stderr.decode(errors="replace").strip()
        raise emulation.Error(f"{command[0]} fails: {said}") from None


def make_archive(folder):
    """Makes an initramfs archive of the files that replace the image's."""
    tree = folder / "overlay"
    files = {
        "etc/inittab": (BOARD / "rootfs/etc/inittab").read_text() + SERVICES,
        "etc/limber.conf": (BOARD / "limber.conf").read_text() + SETTINGS,
        "usr/sbin/camera-switch": (HERE / "guest/camera-switch").read_text(),
    }
    names = []
    for name, text in files.items():
        path = tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(0o755 if "bin/" in name else 0o644)
        names.append(name)
    archive = folder / "overlay.cpio"
    archive.write_bytes(run("cpio", "-o", "-H", "newc", "-R", "0:0", "--quiet",
                            cwd=tree, input="\n".join(names).encode()))
    return archive


def make_tree(image, folder):
    """Makes the device tree, with the second serial line enabled."""
    tree = folder / "virtual.dtb"
    tree.write_bytes((image / "imx31-pdk-limber.dtb").read_bytes())
    node = run("fdtget", str(tree), "/aliases", "serial1").decode().strip()
    run("fdtput", "-t", "s", str(tree), node, "status", "okay")
    return tree
