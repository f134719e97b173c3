"""What the kernel sets up on a board with an IPU, as far as the emulated chip
shows it: pins, the panel's framebuffer, its serial bus, the flash controller."""
from harness import BY_HAND, PROMPT, booted, check, done

machine = booted(BY_HAND, shell=False,
                 arguments="console=ttymxc0,115200 panic=5 limber_ipu "
                 "ubi.mtd=rootfs")
machine.wait(PROMPT)
log = machine.log()
check("mx3fb has the panel's mode", "using mode Epson-VGA" in log, log[-3000:])
status, said = machine.shell("cat /sys/class/graphics/fb*/name "
                             "/sys/class/graphics/fb*/virtual_size")
check("it is the only framebuffer, with two pictures to flip",
      said.count("DISP3 BG") == 1 and "480,1280" in said
      and "simple" not in said, said)
status, said = machine.shell("cat /sys/bus/spi/devices/*/modalias")
check("panel and power chip are on their buses",
      "spi:l4f00242t03" in said and "spi:mc13783" in said, said)
check("the drivers of keypad and flash look for them",
      "43fa8000.kpp" in log and "nand:" in log, log[-3000:])
check("nothing else is wrong", not any(
    word in log for word in ("Oops", "BUG", "limber: the panel")), log[-3000:])
done()
