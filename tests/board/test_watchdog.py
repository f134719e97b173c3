"""When limber hangs, the watchdog resets the board, which boots again."""
from harness import (PROMPT, booted, check, done, is_drawn, limber_pid, note,
                     pause, wait_until)

machine = booted(arguments="console=ttymxc0,115200 panic=5 imx2_wdt.timeout=3")
wait_until(machine, lambda: is_drawn(machine.frame()), 10)
machine.mark()
pause(machine, 5)
check("a limber that draws keeps the board running",
      "Booting Linux" not in machine.log()[machine.seen:])

pid = limber_pid(machine)
machine.mark()
machine.console.type(f"kill -STOP {pid}\n")
machine.wait("Booting Linux")
check("a limber that hangs has the watchdog reset the board", True)
machine.wires.start_timer()
machine.clear()
again_s = wait_until(machine, lambda: is_drawn(machine.frame()), 10)
check("and its picture is back", again_s is not None, machine.log()[-2000:])
note(f"picture {again_s or 0:.2f} s after the kernel's start")
machine.wait(PROMPT)
check("with another limber", limber_pid(machine) is not None)
done()
