// The virtual PDK's page in a real browser, with the real server and the emulated
// board. Prints TAP and keeps screenshots in build/check-virtual-pdk.

const fs = require("fs");
const http = require("http");
const path = require("path");
const { Server, openBrowser, isRunning, statusText, sleep, until, TOP } =
	require("./server.js");

const FOLDER = path.join(TOP, "build/check-virtual-pdk");
const PATIENCE_MS = Number(process.env.PATIENCE_S ?? 400) * 1000;
// Where the demo walker shows the chosen feature and the camera's use.
const FEATURE = [12, 592, 180, 36];
const CAMERA_USE = [12, 544, 180, 36];

let count = 0;
let failed = 0;

function check(name, good, why = "") {
	count++;
	console.log(`${good ? "ok" : "not ok"} ${count} - ${name}`);
	if (!good) {
		failed++;
		for (const line of String(why).split("\n").slice(-30)) {
			console.log(`# ${line}`);
		}
	}
}

// Returns a part of the screen as text that can be compared.
const region = (page, [x, y, width, height]) =>
	page.evaluate(([x, y, width, height]) =>
		document.getElementById("screen").getContext("2d")
			.getImageData(x, y, width, height).data.join(), [x, y, width, height]);

// The fraction of the screen in the test camera's yellow, green and magenta.
const colourBars = (page) => page.evaluate(() => {
	const { data } = document.getElementById("screen").getContext("2d")
		.getImageData(0, 0, 480, 640);
	const seen = { yellow: 0, green: 0, magenta: 0 };
	for (let at = 0; at < data.length; at += 4) {
		const bits = [0, 1, 2].map((i) => data[at + i] > 150 ? 1 :
			data[at + i] < 40 ? 0 : 9).join("");
		const name = { "110": "yellow", "010": "green", "101": "magenta" }[bits];
		if (name) {
			seen[name]++;
		}
	}
	return Math.min(...Object.values(seen)) * 4 / data.length;
});

const logText = (page) => page.textContent("#log");
const isDown = (page, name) =>
	page.locator(`[data-button="${name}"][data-down]`).count();

// Checks that an action changes a part of the screen that was still before.
async function checkChange(name, page, part, act) {
	let before = "";
	const still = await until(async () => {
		const last = before;
		before = await region(page, part);
		return last === before;
	}, 20000, 800);
	await act();
	const changed = await until(async () => await region(page, part) !== before);
	check(name, still && changed, still ? "it stays the same" : "it never stood still");
	if (!still || !changed) {
		await page.screenshot({ path: path.join(FOLDER, `not-${count}.png`) });
	}
}

// Returns the HTTP status of a request with these headers.
function ask(url, headers, file = "") {
	return new Promise((done) => {
		http.get(url + file, { headers }, (answer) => {
			answer.resume();
			done(answer.statusCode);
		}).on("upgrade", (answer, socket) => {
			socket.destroy();
			done(101);
		}).on("error", (error) => done(error.message));
	});
}

async function testPicture(page) {
	check("the board boots, and its page says so", await isRunning(page),
		`${await logText(page)}\n${await statusText(page)}`);
	const colours = await page.evaluate(() => new Set(new Uint32Array(
		document.getElementById("screen").getContext("2d")
			.getImageData(0, 0, 480, 640).data.buffer)).size);
	check("the screen has a picture", colours > 200, colours);
	check("pictures a second are shown", await until(async () =>
		/^[\d.]+ pictures\/s$/.test(await page.textContent("#rate"))));
	check("the console's log has what limber says", await until(async () =>
		/walker: skeletal/.test(await logText(page))), await logText(page));
	check("and no escapes of a terminal",
		!/[\x00-\x08\x0b-\x1f]/.test(await logText(page)));
}

async function testButtons(page, other) {
	const key = page.locator('[data-button="F6"]');
	await checkChange("a click changes the picture", page, FEATURE,
		() => key.click());
	await until(async () => !await isDown(page, "F6"));
	await checkChange("a key does", page, FEATURE,
		() => page.keyboard.press("F6"));
	await checkChange("so does its digit", page, FEATURE,
		() => page.keyboard.press("6"));
	await until(async () => !await isDown(page, "F6"));
	const presses = [];
	await page.exposeFunction("onKeypad", (down) => presses.push(down));
	await page.evaluate(() => new MutationObserver(([change]) =>
		onKeypad(change.target.hasAttribute("data-down"))).observe(
		document.querySelector('[data-button="F6"]'),
		{ attributeFilter: ["data-down"] }));
	await page.keyboard.press("6");
	await page.keyboard.press("6");
	check("two quick presses are two", await until(() => presses.length === 4) &&
		presses.join() === "true,false,true,false", presses);
	await key.focus();
	await checkChange("and Space on the focused button", page, FEATURE,
		() => page.keyboard.press("Space"));
	await page.evaluate(() => document.activeElement.blur());
	check("a second page has the same picture",
		await until(async () => await region(other, FEATURE) ===
			await region(page, FEATURE)));
	await page.locator('[data-button="UP"]').hover();
	await page.mouse.down();
	await page.keyboard.down("ArrowLeft");
	check("two buttons are held, for all pages to see", await until(async () =>
		await isDown(other, "UP") && await isDown(other, "LEFT")));
	await sleep(500);
	check("as long as they are held", await isDown(other, "UP"));
	await page.mouse.move(5, 5);
	await page.mouse.up();
	check("a release beside the button releases it", await until(async () =>
		!await isDown(other, "UP")));
	check("and no other", await isDown(other, "LEFT"));
	await page.keyboard.up("ArrowLeft");
	check("then that one", await until(async () => !await isDown(other, "LEFT")));
}

// What a console shows of a text, line by line.
function shown(page, text) {
	return page.evaluate(async (said) => {
		const { Console } = await import("/console.js");
		const form = document.createElement("form");
		form.append(document.createElement("input"));
		const log = new Console(document.createElement("pre"), form, () => {});
		log.say(said);
		return log.log.textContent;
	}, text);
}

async function testEscapes(page) {
	const texts = {
		"colours": ["\x1b[1;31mred\x1b[0m", "red"],
		"a mode of the cursor": ["\x1b[?25lhidden", "hidden"],
		"a soft reset": ["\x1b[!pafter", "after"],
		"two characters": ["\x1b7saved", "saved"],
		"one that a line's end breaks": ["\x1b[12\nnext", "\nnext"],
		"one that another one breaks": ["\x1b[1\x1b[0mplain", "plain"],
	};
	for (const [name, [said, wanted]] of Object.entries(texts)) {
		const got = await shown(page, said);
		check(`escapes of a terminal are left out: ${name}`, got === wanted,
			JSON.stringify(got));
	}
	const face = await shown(page, "\u{1f600}a");
	check("a character of two code units stays whole", face === "\u{1f600}a",
		JSON.stringify(face));
}

async function testConsole(page) {
	await page.fill("#text", "echo $((6 * 7))-from-the-board");
	await page.keyboard.press("Enter");
	check("a line that is typed is run by the board's shell",
		await until(async () => /^42-from-the-board$/m.test(await logText(page))),
		await logText(page));
	check("its Enter is no button's", !await isDown(page, "ENTER"));
	await page.evaluate(() => document.activeElement.blur());
}

async function testCamera(page) {
	const camera = page.locator("#camera");
	check("the camera is off at first",
		await camera.getAttribute("aria-checked") === "false" &&
		await colourBars(page) < 0.002);
	await camera.click();
	check("its switch plugs it in",
		await until(() => page.locator(
			'#camera[aria-checked="true"]:not([data-pending])').count()));
	check("and its colour bars are in the picture",
		await until(async () => await colourBars(page) > 0.004, 30000),
		await colourBars(page));
	await page.screenshot({ path: path.join(FOLDER, "camera.png") });
	// After UP the walker walks, and the floor is visible through the label.
	await page.keyboard.press("ArrowDown");
	await checkChange("F10 puts it elsewhere", page, CAMERA_USE,
		() => page.keyboard.press("F10"));
}

async function testReset(page) {
	await page.click("#reset");
	check("reset begins again", await until(async () =>
		/-- reset --\n[^]*Booting Linux/.test(await logText(page))),
	await logText(page));
	check("and the board is back", await isRunning(page), await statusText(page));
	check("with its camera", await until(() => page.locator(
		'#camera[aria-checked="true"]:not([data-pending])').count(), 40000));
	await page.click("#camera");
	check("which can be pulled out", await until(() => page.locator(
		'#camera[aria-checked="false"]:not([data-pending])').count()));
}

async function testPower(page, server) {
	await page.click("#power");
	check("switched off, the page says so", await until(() =>
		page.locator("#notice:visible", { hasText: "is off" }).count()));
	check("and no QEMU runs", server.qemu() === 0);
	check("nor can one type to it", await page.isDisabled("#text") &&
		await page.isDisabled("#reset"));
	await page.screenshot({ path: path.join(FOLDER, "off.png") });
	await page.click("#power");
	check("switched on it boots", await isRunning(page), await statusText(page));
	// halt -f could end while limber flips, and the kernel holds its console back.
	await page.fill("#text", "halt");
	await page.keyboard.press("Enter");
	check("a system that is halted is reported", await until(() =>
		page.locator("#notice:visible", { hasText: "halted" }).count()),
	await logText(page));
	await page.click("#notice button");
	check("and reset from there", await isRunning(page), await statusText(page));
	process.kill(server.qemu(), "SIGKILL");
	check("a board that has stopped is reported", await until(() =>
		page.locator("#notice:visible", { hasText: "has stopped" }).count()),
	await statusText(page));
	await page.screenshot({ path: path.join(FOLDER, "stopped.png") });
	await page.click("#notice button");
	check("and starts again from there", await isRunning(page), await statusText(page));
}

async function testLayout(page) {
	for (const [width, height] of [[800, 700], [1280, 760], [1920, 1080]]) {
		await page.setViewportSize({ width, height });
		const wrong = await page.evaluate(() => {
			const out = document.documentElement.scrollWidth > innerWidth ?
				["scrolls sideways"] : [];
			for (const element of document.querySelectorAll(".side button, #screen")) {
				const box = element.getBoundingClientRect();
				if (box.bottom > innerHeight || box.right > innerWidth) {
					out.push(element.id || element.textContent);
				}
			}
			return out;
		});
		check(`all of the board is in view at ${width}x${height}`,
			wrong.length === 0, wrong);
		await page.screenshot({ path: path.join(FOLDER, `${width}.png`) });
	}
}

async function testStrangers(url) {
	const own = url.replace(/\/$/, "");
	const upgrade = { Connection: "Upgrade", Upgrade: "websocket",
		"Sec-WebSocket-Version": "13",
		"Sec-WebSocket-Key": Buffer.alloc(16).toString("base64") };
	check("its own page gets a socket",
		await ask(url, { ...upgrade, Origin: own }, "socket") === 101);
	check("another site's page gets none",
		await ask(url, { ...upgrade, Origin: "http://example.org" }, "socket") === 403);
	check("and a nameless one neither", await ask(url, upgrade, "socket") === 403);
	check("a foreign name for this machine is refused",
		await ask(url, { Host: "example.org" }) === 403);
	check("files beside the page are not served",
		await ask(url, {}, "..%2fserve") === 404);
}

async function testRefusals(server, url) {
	const port = new URL(url).port;
	const folder = path.join(FOLDER, "second");
	const second = new Server(folder, "--port", port);
	check("a port that is taken is reported in a sentence",
		await second.ended === 1 && /^limber: port \d+ is taken: .*\n$/.test(second.said),
		second.said);
	const third = new Server(server.folder, "--port", "0");
	check("so is a folder in use",
		await third.ended === 1 && /^limber: .*already.*\n$/.test(third.said),
		third.said);
}

async function testEnd(page, server) {
	/* The board may be in any state here. */
	if (!server.qemu()) {
		await page.reload();
		await page.click("#power");
	}
	const pid = await until(() => server.qemu());
	check("SIGTERM ends the server", await server.end("SIGTERM") === 0, server.said);
	check("and its QEMU", pid > 0 && !fs.existsSync(`/proc/${pid}`));
	check("and the page says so", await until(() =>
		page.locator("#notice:visible", { hasText: "server has ended" }).count()));
	const again = new Server(server.folder, "--port", "0");
	await again.url();
	const second = await until(() => again.qemu());
	check("Ctrl-C does, while the board starts",
		second > 0 && await again.end("SIGINT") === 0, again.state());
	check("and leaves no QEMU", !fs.existsSync(`/proc/${second}`));
	const third = new Server(server.folder, "--port", "0");
	await third.url();
	const hanging = await until(() => third.qemu());
	if (hanging) {
		process.kill(hanging, "SIGSTOP");
	}
	check("Ctrl-C does, while QEMU hangs at its start",
		hanging > 0 && await third.end("SIGINT") === 0, third.state());
	check("and leaves no QEMU that hangs", !fs.existsSync(`/proc/${hanging}`));
}

async function testAll() {
	fs.rmSync(FOLDER, { recursive: true, force: true });
	const server = new Server(path.join(FOLDER, "state"), "--port", "0");
	let browser = null;
	try {
		const url = await server.url();
		check("the server says where its page is", url, server.said);
		browser = await openBrowser(FOLDER);
		const errors = [];
		const page = await browser.newPage();
		page.on("pageerror", (error) => errors.push(error.message));
		page.on("console", (line) => {
			if (line.type() === "error") {
				errors.push(line.text());
			}
		});
		await page.goto(url);
		await testPicture(page);
		const other = await browser.newPage();
		await other.goto(url);
		await page.bringToFront();
		await testButtons(page, other);
		await other.close();
		await testEscapes(page);
		await testConsole(page);
		await testCamera(page);
		await testLayout(page);
		await testReset(page);
		await testPower(page, server);
		await testStrangers(url);
		await testRefusals(server, url);
		check("the page has no errors", errors.length === 0, errors.join("\n"));
		await testEnd(page, server);
	} catch (error) {
		check("goes on to its end", false, `${error.stack}\n${server.said}`);
	} finally {
		if (server.status === null) {
			await server.end("SIGTERM");
		}
		await browser?.close();
	}
}

setTimeout(() => {
	check(`takes no longer than ${PATIENCE_MS / 1000} s`, false);
	process.exit(1);
}, PATIENCE_MS).unref();
testAll().then(() => {
	console.log(`1..${count}`);
	process.exitCode = failed ? 1 : 0;
});
