"""What limber, the console and the kernel allow on the board: limber is a user
without capabilities, the console has no shell of its own, and a model that ends
limber gives way to the built-in demo."""
import re
import subprocess

from harness import (PROMPT, TOP, booted, check, done, guest_tool, is_drawn,
                     pause, wait_until)

BUSYBOX = TOP / "build/sysroot/usr/bin/busybox"
PASSWORD = "so secret"
# A program that reads a model of these bytes reports an error.
BROKEN = {"broken.glb": "no model",
          "etc/limber.conf": "[start]\nmodel = /broken.glb\n"}


def drawn(machine, seconds=10):
    return wait_until(machine, lambda: is_drawn(machine.frame()), seconds)


machine = booted(guest_tool(), drivers=True)
check("limber shows its picture", drawn(machine) is not None)
status, said = machine.shell("cat /proc/$(pidof limber)/status")
facts = dict(re.findall(r"^(\w+):\t(.*)$", said, re.M))
user = machine.shell("grep ^limber: /etc/passwd")[1]
number = re.search(r"^limber:x:(\d+):", user, re.M)[1]
check("as a user of its own", number != "0" and
      facts["Uid"].split() == facts["Gid"].split() == [number] * 4, said)
check("without capabilities", all(
    int(facts[name], 16) == 0 for name in ("CapPrm", "CapEff", "CapAmb")), said)
check("that cannot gain rights", facts["NoNewPrivs"] == "1", said)
status, said = machine.shell("ls -l /proc/$(pidof limber)/fd")
check("with its devices open", all(
    name in said for name in ("/dev/fb0", "/dev/watchdog", "gpio", "event0")),
      said)
machine.shell("modprobe uinput; guest key ENTER &")
pause(machine, 1.5)
status, said = machine.shell("ls -l /dev/input; ls -l /proc/$(pidof limber)/fd")
check("a keyboard that is plugged in gets the user's group", re.search(
    r"crw-rw---- +1 root +input .* event1$", said, re.M), said)
check("and limber opens it", "-> /dev/input/event1" in said, said)
status, said = machine.shell("ls /dev/mem /dev/kmem /proc/sysrq-trigger")
check("the kernel gives no access to memory and has no SysRq", all(
    f"{name}: No such file" in said for name in
    ("/dev/mem", "/dev/kmem", "/proc/sysrq-trigger")), said)
machine.stop()

machine = booted(shell=False, open_shell=False)
check("without a shell on the console limber shows its picture",
      drawn(machine) is not None)
machine.console.type("\n\necho he''llo\n")
pause(machine, 2)
check("and what is typed there runs nothing",
      "hello" not in machine.log() and not re.search(PROMPT, machine.log()),
      machine.log()[-500:])
machine.stop()

secret = subprocess.run(
    ["qemu-arm", str(BUSYBOX), "mkpasswd", "-m", "sha512", "-P", "0"],
    input=PASSWORD + "\n", check=True, stdout=subprocess.PIPE,
    text=True).stdout.strip()
machine = booted({"etc/shadow": f"root:{secret}:20000:0:99999:7:::\n"},
                 shell=False, open_shell=False)
for password, opens in (("guess", False), (PASSWORD, True)):
    machine.wait(r"login: $")
    machine.mark()
    machine.console.type("root\n")
    machine.wait(r"Password: $")
    machine.mark()
    machine.console.type(password + "\n")
    found = machine.wait(r"limber:\S*# |incorrect")
    check(f"the password {password!r} {'opens' if opens else 'does not open'} "
          "the console", (found[0] != "incorrect") == opens,
          machine.log()[-500:])
machine.stop()

machine = booted(BROKEN)
said = "/broken.glb: it ended limber 2 times within a minute of its start"
check("a model that ends limber gives way to the built-in demo",
      drawn(machine, 20) is not None and said in machine.log(),
      machine.log()[-2000:])
check("after two starts", machine.log().count("broken.glb: the format") == 2,
      machine.log()[-2000:])
done()
