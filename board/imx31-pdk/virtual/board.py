"""The emulated board of the server.

One thread sends requests to QEMU, one after the other; everything else runs in
the event loop. The board calls listener.state(), listener.log(text) and
listener.picture(first_row, rows) when something changes.
"""
import asyncio
import codecs
import concurrent.futures
import contextlib
import pathlib
import time

import overlay
from overlay import LINES, emulation, links

ROW_BYTES = emulation.WIDTH * 2
# The time between two readings of the screen, while it changes and at rest.
LOOK_S, REST_S = 1 / 30, 1 / 6
# The time between two checks of QEMU while no page is visible.
UNSEEN_S = 0.5
# A press lasts until one of these holds: so many seconds have passed, and the board
# has drawn so many pictures since. On a busy host QEMU may stand still for longer than
# a click, and would not notice it. One picture may have been drawn before the press; a
# board that shows no second one may have nothing new to show.
PRESS_NOTICED = ((0.1, 2), (1.5, 0))
# The same for a key: the keypad's driver must see it in four scans in a row, and
# a picture of the panel may be read twice while it is sent.
KEY_NOTICED = ((0.15, 5), (0.6, 2), (1.5, 0))
# The time between two presses of a button.
PAUSE_S = 0.05
# The time between two attempts to end a QEMU that is being started.
AGAIN_S = 0.05
LOG_KEPT = 100_000
# The last messages of a kernel that has stopped, and what they mean.
LAST_WORDS = {
    "Kernel panic": "its kernel has panicked, the console says why",
    "reboot: System halted": "its system has been halted",
    "reboot: Power down": "its system has been shut down",
}


def changed_rows(old, new, step=16):
    """Returns the first row and the number of rows from the first to the last
    block of rows that differ, or (0, 0)."""
    old, new = memoryview(old), memoryview(new)
    block = step * ROW_BYTES
    starts = [at for at in range(0, len(new), block)
              if old[at:at + block] != new[at:at + block]]
    if not starts:
        return 0, 0
    first = starts[0] // ROW_BYTES
    return first, starts[-1] // ROW_BYTES + step - first


def is_drawn(frame):
    """Whether the screen shows more than the few colours of an empty one."""
    return len({frame[at:at + 2] for at in range(0, len(frame), 1998)}) > 12


class Board:
    """phase is off, starting, booting, running, halted or ended; why is the
    reason for the last two."""

    def __init__(self, image, state, listener):
        self.image = pathlib.Path(image)
        self.folder = pathlib.Path(state)
        self.listener = listener
        self.machine = emulation.Machine(self.folder)
        self.worker = concurrent.futures.ThreadPoolExecutor(1)
        self.switching = asyncio.Lock()
        self.phase, self.why = "off", ""
        self.camera_wanted = self.camera_seen = False
        self.camera_line = None
        self.console_line = None
        self.log = ""
        self.frame = bytes(emulation.FRAME_BYTES)
        self.tasks = []
        self.pressed = {name: {} for name in LINES}
        self.turns = {name: asyncio.Lock() for name in LINES}
        self.drawn = 0
        self.hurry = asyncio.Event()

    async def ask(self, function, *arguments):
        """Runs a function in the thread that sends requests to QEMU."""
        loop = asyncio.get_running_loop()
        return await loop.run_in_executor(self.worker, function, *arguments)

    def enter(self, phase, why=""):
        if (self.phase, self.why) != (phase, why):
            self.phase, self.why = phase, why
            self.listener.state()

    @property
    def is_on(self):
        return self.phase in ("booting", "running", "halted")

    # Power.

    async def power(self, on):
        if not on:
            await self.interrupt()
        async with self.switching:
            if on and not self.is_on:
                await self.start()
            elif not on:
                await self.stop("off")

    async def start(self):
        self.enter("starting")
        self.log = ""
        self.listener.log(None)
        try:
            await self.ask(self.launch)
            await self.open_lines()
            await self.ask(self.machine.power_on)
        except (emulation.Error, OSError) as error:
            await self.stop("ended", str(error))
            return
        self.enter("booting")
        self.tasks.append(asyncio.create_task(self.watch()))

    def launch(self):
        stale = self.machine.pid()
        if stale:
            # A former server has left this QEMU: we hold the folder's lock.
            emulation.Machine(self.folder).stop()
        for name in ("zImage", "imx31-pdk-limber.dtb", "initramfs.cpio.lz4",
                     "test-drivers.cpio.lz4"):
            if not (self.image / name).exists():
                raise emulation.Error(
                    f"{self.image / name} is missing: make image")
        self.machine = emulation.Machine(self.folder)
        (self.folder / "camera.sock").unlink(missing_ok=True)
        self.machine.start(
            self.image, (self.image / "test-drivers.cpio.lz4",
                         overlay.make_archive(self.folder)),
            tree=overlay.make_tree(self.image, self.folder),
            power=False, more=overlay.SERIAL)

    async def open_lines(self):
        console, self.console_line = await asyncio.open_unix_connection(
            sock=links.connect(self.folder, "console.sock"))
        camera, self.camera_line = await asyncio.open_unix_connection(
            sock=links.connect(self.folder, "camera.sock"))
        self.tasks += [asyncio.create_task(self.read_console(console)),
                       asyncio.create_task(self.read_camera(camera))]

    def disconnect(self):
        """Cancels the tasks and closes the lines of this QEMU."""
        this = asyncio.current_task()
        for task in self.tasks:
            if task is not this:
                task.cancel()
        self.tasks = []
        for line in (self.console_line, self.camera_line):
            if line:
                line.close()
        self.console_line = self.camera_line = None
        self.camera_seen = False

    async def interrupt(self):
        """Ends QEMU, so that no task goes on waiting for an answer, until
        start() and reset() have noticed: start() may launch it meanwhile."""
        while True:
            self.disconnect()
            await self.end_qemu()
            if not self.switching.locked():
                return
            await asyncio.sleep(AGAIN_S)

    async def end_qemu(self):
        """Ends QEMU from another thread than that of ask(), which may be
        waiting for an answer. stop() reports a failure."""
        with contextlib.suppress(emulation.Error, OSError):
            await asyncio.to_thread(self.machine.end)

    async def stop(self, phase, why=""):
        self.disconnect()
        await self.end_qemu()
        try:
            await self.ask(self.machine.stop)
        except (emulation.Error, OSError) as error:
            phase, why = "ended", str(error)
        self.show(bytes(emulation.FRAME_BYTES))
        self.enter(phase, why)

    async def reset(self):
        async with self.switching:
            if not self.is_on:
                await self.start()
                return
            try:
                await self.ask(self.push_reset)
            except (emulation.Error, OSError):
                return  # watch() reports it
            self.say("\n-- reset --\n")
            self.begin_again()

    def push_reset(self):
        # The board is stopped while its screen is cleared.
        self.machine.monitor.run("stop")
        self.machine.monitor.run("system_reset")
        self.machine.clear()
        self.machine.monitor.run("cont")

    def begin_again(self):
        """Called after a reset, by the switch or by the board itself."""
        self.camera_seen = False
        self.show(bytes(emulation.FRAME_BYTES))
        self.enter("booting")
        self.listener.state()

    async def end(self):
        await self.power(False)
        self.worker.shutdown()

    # Picture.

    def show(self, frame):
        first, rows = changed_rows(self.frame, frame)
        if rows:
            self.frame = frame
            self.drawn += 1
            self.listener.picture(first, rows)
        return rows > 0

    async def watch(self):
        """Reads the screen while a page is visible, and checks QEMU."""
        pause = LOOK_S
        while True:
            begun = time.monotonic()
            self.hurry.clear()
            try:
                if self.listener.is_watched() or self.phase == "booting":
                    changed = await self.look()
                    pause = LOOK_S if changed else min(pause * 1.3, REST_S)
                else:
                    await self.ask(self.machine.monitor.run, "query-status")
                    pause = UNSEEN_S
                self.handle_events()
            except Exception as error:  # pylint: disable=broad-except
                # The page must learn of every failure.
                await self.report_end(error)
                return
            left = pause - (time.monotonic() - begun)
            with contextlib.suppress(TimeoutError):
                # A press sets hurry, and the screen is read at once.
                async with asyncio.timeout(max(left, 0.005)):
                    await self.hurry.wait()
                pause = LOOK_S

    async def look(self):
        frame = await self.ask(self.machine.frame)
        if self.phase == "booting" and is_drawn(frame):
            self.enter("running")
        return self.show(frame)

    def handle_events(self):
        events = self.machine.monitor.events
        for event in events:
            if event["event"] == "RESET" and event["data"].get("guest"):
                self.say("\n-- the board has reset itself --\n")
                self.begin_again()
        events.clear()

    async def report_end(self, error):
        said = ""
        with contextlib.suppress(OSError):
            said = (self.folder / "qemu.log").read_text(errors="replace")
        lines = said.strip().splitlines()
        async with self.switching:
            await self.stop("ended", str(error) +
                            (f": {lines[-1]}" if lines else ""))

    # Buttons: a key of the keypad is pressed, or on the machine kzm a GPIO line
    # is high, while any page holds it. The presses of a button
    # are carried out one after the other, so that two quick clicks count.

    async def press(self, name, who):
        async with self.turns[name]:
            held = self.pressed[name]
            held[who] = (time.monotonic(), self.drawn)
            if len(held) == 1:
                await self.level(name, True)

    async def release(self, name, who):
        async with self.turns[name]:
            held = self.pressed[name]
            if who not in held:
                return
            while len(held) == 1 and not self.is_noticed(*held[who]):
                await asyncio.sleep(0.02)
            del held[who]
            if not held:
                await self.level(name, False)
                await asyncio.sleep(PAUSE_S)

    def is_noticed(self, pressed_s, drawn):
        """Whether the board had enough time to notice the press."""
        lasted_s = time.monotonic() - pressed_s
        drawn = self.drawn - drawn
        noticed = KEY_NOTICED if self.machine.kind.keys else PRESS_NOTICED
        return any(lasted_s >= seconds and drawn >= pictures
                   for seconds, pictures in noticed)

    def held(self):
        return [name for name in LINES if self.pressed[name]]

    async def level(self, name, high):
        self.listener.state()
        if self.is_on:
            with contextlib.suppress(emulation.Error, OSError):
                if self.machine.kind.keys:
                    await self.ask(self.machine.key, name, high)
                else:
                    pin = self.machine.kind.button_pin(LINES[name])
                    await self.ask(self.machine.wires.run,
                                   f"set_irq_in {pin} {int(high)}")
            self.hurry.set()

    # Serial lines. QEMU stops the board while nobody reads them.

    def say(self, text):
        self.log = (self.log + text)[-LOG_KEPT:]
        self.listener.log(text)

    async def read_console(self, line):
        # A character may arrive in two parts.
        decoder = codecs.getincrementaldecoder("utf-8")(errors="replace")
        tail = ""
        while data := await line.read(65536):
            text = decoder.decode(data)
            self.say(text)
            tail = tail[-200:] + text
            for words, why in LAST_WORDS.items():
                if words in tail:
                    tail = ""
                    self.enter("halted", why)

    def type(self, text):
        if self.console_line:
            self.console_line.write(text.encode())

    async def read_camera(self, line):
        while data := await line.readline():
            words = data.decode(errors="replace").split()
            if words[-1:] == ["ready"]:
                self.send_camera()
            elif words[:1] == ["camera"]:
                self.camera_seen = words[-1] == "on"
                self.listener.state()

    def camera(self, on):
        self.camera_wanted = on
        self.send_camera()
        self.listener.state()

    def send_camera(self):
        if self.camera_line:
            self.camera_line.write(b"on\n" if self.camera_wanted else b"off\n")
