"""The Debian package for armel: dpkg installs it, and limber runs from there."""
import pathlib
import shutil
import subprocess

from harness import FOLDER, IMAGE, TOP, check, done

SYSROOT = TOP / "build/sysroot"
root = FOLDER / "root"
admin = FOLDER / "admin"
shutil.rmtree(FOLDER, ignore_errors=True)
for folder in (root, admin / "info", admin / "updates", admin / "triggers"):
    folder.mkdir(parents=True)
for name in ("status", "available"):
    (admin / name).write_text("")

packages = list(IMAGE.glob("limber_*_armel.deb"))
check("there is one package", len(packages) == 1, packages)
# The libraries are the board's; the host's package database lacks them.
run = subprocess.run(
    ["dpkg", "--force-not-root", "--force-depends", "--force-architecture",
     "--force-script-chrootless", "--log=/dev/null", f"--admindir={admin}",
     f"--instdir={root}", "-i", str(packages[0])],
    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
check("dpkg installs it", run.returncode == 0, run.stdout)
field = subprocess.run(["dpkg-deb", "-f", packages[0], "Depends"], check=True,
                       stdout=subprocess.PIPE, text=True).stdout
check("it names what it needs", "libc6 (>= 2.41)" in field and
      "libjpeg62-turbo" in field, field)
for path in ("usr/bin/limber", "usr/share/limber/walker.glb",
             "usr/share/doc/limber/copyright"):
    check(f"it brings {path}", (root / path).is_file())
picture = FOLDER / "arm.png"
run = subprocess.run(
    ["qemu-arm", "-cpu", "arm1136", "-L", str(SYSROOT),
     str(root / "usr/bin/limber"), "render", "--config", "none", "--demo",
     "arm", "--size", "48x64", "--frames", "1", "-o", str(picture)],
    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
check("limber runs and finds its models",
      run.returncode == 0 and pathlib.Path(picture).is_file(), run.stdout)
done()
