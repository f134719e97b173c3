// Starts the server as a user does, and Chromium with its page, for the test and
// for the screenshot.

const { spawn } = require("child_process");
const fs = require("fs");
const path = require("path");
const { chromium } = require("playwright-core");

const TOP = path.resolve(__dirname, "../..");
const SERVE = path.join(TOP, "board/imx31-pdk/virtual/serve");
const BOOT_MS = 90000;
const FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic",
	"--no-first-run", "--disable-background-networking",
	"--disable-component-update", "--disable-sync", "--no-proxy-server"];

const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

// Waits until get() returns a true value; returns its last value.
async function until(get, ms = 20000, step = 100) {
	const end = Date.now() + ms;
	for (;;) {
		const over = Date.now() > end;
		const value = await get();
		if (value || over) {
			return value;
		}
		await sleep(step);
	}
}

class Server {
	constructor(folder, ...options) {
		this.folder = folder;
		this.said = "";
		this.status = null;
		const image = process.env.IMAGE ? ["--image", process.env.IMAGE] : [];
		this.process = spawn(SERVE, ["--state", folder, ...image, ...options],
			{ stdio: ["ignore", "pipe", "pipe"] });
		for (const stream of [this.process.stdout, this.process.stderr]) {
			stream.on("data", (data) => { this.said += data; });
		}
		this.ended = new Promise((done) => {
			/* After "exit" there may be output to come. */
			this.process.on("close", (code, name) => {
				this.status = code ?? name;
				done(this.status);
			});
		});
	}

	async url() {
		await until(() => /http:\S+/.test(this.said) || this.status !== null, 60000);
		return this.said.match(/http:\S+/)?.[0];
	}

	// The process id of the emulated board's QEMU, or 0.
	qemu() {
		try {
			const pid = Number(fs.readFileSync(path.join(this.folder, "pid")));
			const words = fs.readFileSync(`/proc/${pid}/cmdline`, "utf8");
			return words.includes("qemu-system-arm") ? pid : 0;
		} catch {
			return 0;
		}
	}

	// For messages: what became of the server and of QEMU, and what it said.
	state() {
		return `status ${this.status}, QEMU ${this.qemu()}\n${this.said}`;
	}

	async end(signal) {
		this.process.kill(signal);
		return Promise.race([this.ended, sleep(60000).then(() => "nothing")]);
	}
}

async function openBrowser(folder, options = {}) {
	fs.mkdirSync(folder, { recursive: true });
	const profile = fs.mkdtempSync(path.join(folder, "profile-"));
	const browser = await chromium.launchPersistentContext(profile, {
		executablePath: "/usr/bin/chromium", headless: true, args: FLAGS,
		viewport: { width: 1280, height: 760 }, timeout: 60000, ...options });
	browser.on("close", () => {
		try {
			fs.rmSync(profile, { recursive: true, force: true });
		} catch {
			/* Chromium may still write to the folder, which stays in build/. */
		}
	});
	return browser;
}

const phase = (page) => page.textContent("#phase");
const statusText = async (page) =>
	`${await phase(page)}: ${await page.textContent("#notice")}`;
const isRunning = (page) =>
	until(async () => await phase(page) === "running", BOOT_MS);

module.exports = { Server, openBrowser, isRunning, statusText, sleep, until, TOP };
