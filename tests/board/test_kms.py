"""KMS shows the same pictures when the kernel has no framebuffer device."""
from harness import (BY_HAND, booted, check, difference, done, host_picture,
                     pause, save, start_limber, stop_limber)

UNBIND = "/sys/bus/platform/drivers/simple-framebuffer/unbind"

machine = booted(BY_HAND, drivers=True, kind="kzm")
status, said = machine.shell(f"echo 87e00000.framebuffer >{UNBIND}; "
                             "modprobe simpledrm; ls /dev/dri")
check("simpledrm has the screen", "card0" in said, said)

# The arm does not move, so a picture can be taken at any time.
start_limber(machine, "--demo arm --script /dev/null --math fixed --display kms")
pause(machine, 1)
frame = machine.frame()
said = stop_limber(machine)
save(frame, "arm.png")
apart = difference(frame, host_picture(
    "--demo", "arm", "--math", "fixed", "--script", "/dev/null", "--time", "1"))
check("the picture in its dumb buffers is the host's, to the byte",
      apart == 0, f"{apart} pixels differ\n{said}")

machine.shell("modprobe vkms")
status, said = machine.shell(
    "limber play --demo arm --display kms:/dev/dri/card1 --frames 5 "
    "--clock fixed:25")
check("limber runs on a second screen of another size", status == 0, said)
done()
