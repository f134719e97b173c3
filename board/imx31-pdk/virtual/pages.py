"""The open pages and their messages.

Each page has one WebSocket. A text message is JSON with a "type". A binary
message is a part of the screen: two 16-bit little-endian numbers, the first row
and the number of rows, then these rows in RGB565. A page answers it with
"shown" and gets the next one only then, so a slow page gets fewer pictures, but
never old ones.
"""
import asyncio
import ipaddress
import json
import pathlib
import struct
import urllib.parse

from aiohttp import WSMsgType, web

from board import ROW_BYTES
from overlay import LINES

PAGE = pathlib.Path(__file__).resolve().parent / "page"
FILES = {"index.html": "text/html", "style.css": "text/css",
         "page.js": "text/javascript", "keypad.js": "text/javascript",
         "console.js": "text/javascript", "screen.js": "text/javascript",
         "icon.svg": "image/svg+xml"}
HEADERS = {
    "Content-Security-Policy": "default-src 'self'; frame-ancestors 'none'",
    "X-Content-Type-Options": "nosniff",
    "Cache-Control": "no-store",
}
LONGEST_MESSAGE = 4096


def is_local(host):
    """Whether a Host header names this machine. Any port is allowed, because a
    tunnel's may differ. This refuses DNS rebinding: a name of another machine
    that resolves to this one."""
    try:
        name = urllib.parse.urlsplit(f"//{host}").hostname or ""
        return name == "localhost" or ipaddress.ip_address(name).is_loopback
    except ValueError:
        return False


@web.middleware
async def only_local(request, handler):
    host = request.headers.get("Host", "")
    origin = request.headers.get("Origin")
    if not is_local(host):
        raise web.HTTPForbidden(text="limber: only for this machine\n")
    if origin is not None and origin != f"http://{host}":
        raise web.HTTPForbidden(text="limber: only for its own page\n")
    response = await handler(request)
    if not response.prepared:
        response.headers.update(HEADERS)
    return response


class Page:
    """One open page."""

    def __init__(self, socket):
        self.socket = socket
        self.queue = asyncio.Queue()
        self.dirty = None
        self.is_ready = True
        self.is_visible = True

    def tell(self, **message):
        self.queue.put_nowait(message)

    def mark(self, first, rows):
        end = first + rows
        if self.dirty:
            first, end = min(first, self.dirty[0]), max(end, self.dirty[1])
        self.dirty = (first, end)

    def wake(self):
        """Wakes send(), because there is something to send."""
        self.queue.put_nowait(None)

    async def send(self, board):
        """Sends messages and pictures until the socket closes."""
        while True:
            message = await self.queue.get()
            if message is not None:
                await self.socket.send_str(json.dumps(message))
            elif self.dirty and self.is_ready and self.is_visible:
                first, end = self.dirty
                self.dirty = None
                self.is_ready = False
                await self.socket.send_bytes(
                    struct.pack("<HH", first, end - first) +
                    board.frame[first * ROW_BYTES:end * ROW_BYTES])


class Pages:
    """All open pages. It is the board's listener."""

    def __init__(self):
        self.board = None
        self.open = set()

    def app(self):
        app = web.Application(middlewares=[only_local])
        app.router.add_get("/", self.get_file)
        app.router.add_get("/socket", self.get_socket)
        app.router.add_get("/{name}", self.get_file)
        return app

    async def get_file(self, request):
        name = request.match_info.get("name", "index.html")
        if name not in FILES:
            raise web.HTTPNotFound(text="limber: no such page\n")
        return web.Response(body=(PAGE / name).read_bytes(),
                            content_type=FILES[name], charset="utf-8")

    async def get_socket(self, request):
        if "Origin" not in request.headers:
            raise web.HTTPForbidden(text="limber: only for its own page\n")
        socket = web.WebSocketResponse(max_msg_size=LONGEST_MESSAGE,
                                       heartbeat=20, compress=False)
        await socket.prepare(request)
        page = Page(socket)
        page.tell(**self.state_message())
        page.tell(type="log", text=self.board.log, fresh=True)
        page.mark(0, len(self.board.frame) // ROW_BYTES)
        page.wake()
        self.open.add(page)
        sender = asyncio.create_task(page.send(self.board))
        jobs = set()
        try:
            async for message in socket:
                if message.type == WSMsgType.TEXT:
                    self.take(page, message.data, jobs)
        finally:
            self.open.discard(page)
            sender.cancel()
            for name in LINES:
                await self.board.release(name, page)
        return socket

    def take(self, page, data, jobs):
        """Handles a message of a page; ignores an invalid one."""
        try:
            said = json.loads(data)
            kind = said["type"]
            job = self.job(page, kind, said)
        except (ValueError, KeyError, TypeError, RecursionError):
            return
        if job:
            task = asyncio.create_task(job)
            jobs.add(task)
            task.add_done_callback(jobs.discard)

    def job(self, page, kind, said):
        if kind == "shown":
            page.is_ready = True
            page.wake()
        elif kind == "visible":
            page.is_visible = said["on"] is True
            page.wake()
            self.board.hurry.set()
        elif kind == "camera":
            self.board.camera(said["on"] is True)
        elif kind == "type":
            self.board.type(str(said["text"]))
        elif kind == "power":
            return self.board.power(said["on"] is True)
        elif kind == "reset":
            return self.board.reset()
        elif kind == "button" and said["name"] in LINES:
            if said["down"] is True:
                return self.board.press(said["name"], page)
            return self.board.release(said["name"], page)
        return None

    async def close(self):
        for page in list(self.open):
            await page.socket.close(code=1001, message=b"the server ends")

    # The board's listener.

    def state_message(self):
        board = self.board
        return {"type": "state", "phase": board.phase, "why": board.why,
                "camera": board.camera_wanted, "camera_seen": board.camera_seen,
                "held": board.held(), "pages": len(self.open)}

    def state(self):
        for page in self.open:
            page.tell(**self.state_message())

    def log(self, text):
        """Sends output of the console; None clears the pages' consoles."""
        for page in self.open:
            page.tell(type="log", text=text or "", fresh=text is None)

    def picture(self, first, rows):
        for page in self.open:
            page.mark(first, rows)
            page.wake()

    def is_watched(self):
        return any(page.is_visible for page in self.open)
