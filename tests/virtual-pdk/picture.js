// picture.js FILE.png: the virtual PDK's page with the walker in motion, for
// README pages.

const fs = require("fs");
const path = require("path");
const { Server, openBrowser, isRunning, sleep, statusText, TOP } = require("./server.js");

const SETTLE_MS = 6000;

async function draw(file) {
	const folder = path.join(TOP, "build/virtual-pdk-picture");
	fs.rmSync(folder, { recursive: true, force: true });
	const server = new Server(path.join(folder, "state"), "--port", "0", "--camera");
	let browser = null;
	try {
		const url = await server.url();
		browser = url && await openBrowser(folder);
		const page = await browser?.newPage();
		await page?.goto(url);
		if (!page || !await isRunning(page)) {
			throw new Error("the virtual PDK does not start: " +
				(page ? await statusText(page) : server.said));
		}
		await page.waitForSelector('#camera[aria-checked="true"]:not([data-pending])');
		await page.keyboard.press("ArrowUp");
		await sleep(SETTLE_MS);
		await page.keyboard.down("ArrowLeft");
		await sleep(700);
		await page.setViewportSize({ width: 1280, height: 718 });
		await page.screenshot({ path: file });
	} finally {
		await server.end("SIGTERM");
		await browser?.close();
	}
}

if (process.argv.length !== 3) {
	console.error("usage: picture.js FILE.png");
	process.exit(2);
}
draw(process.argv[2]).catch((error) => {
	console.error(`limber: ${error.message}`);
	process.exit(1);
});
