// Draws the board's screen, in RGB565, on a canvas and measures its frame rate.

const WIDTH = 480;
const RATE_OVER_MS = 2000;

// The canvas colours of all 65536 pixel values, with red in the lowest byte.
function makeColours() {
	const colours = new Uint32Array(65536);
	for (let value = 0; value < 65536; value++) {
		const red = Math.floor((value >> 11) * 255 / 31);
		const green = Math.floor((value >> 5 & 63) * 255 / 63);
		const blue = Math.floor((value & 31) * 255 / 31);
		colours[value] = (255 << 24 | blue << 16 | green << 8 | red) >>> 0;
	}
	return colours;
}

export class Screen {
	constructor(canvas) {
		this.context = canvas.getContext("2d", { alpha: false });
		this.colours = makeColours();
		this.drawn = [];
	}

	// Draws a message of the server: first row, number of rows, pixels.
	draw(message) {
		const [first, rows] = new Uint16Array(message, 0, 2);
		const pixels = new Uint16Array(message, 4);
		const image = this.context.createImageData(WIDTH, rows);
		const out = new Uint32Array(image.data.buffer);
		for (let at = 0; at < out.length; at++) {
			out[at] = this.colours[pixels[at]];
		}
		this.context.putImageData(image, 0, first);
		this.drawn.push(performance.now());
	}

	// Frames a second during the last two seconds.
	rate() {
		const since = performance.now() - RATE_OVER_MS;
		this.drawn = this.drawn.filter((time) => time > since);
		return this.drawn.length * 1000 / RATE_OVER_MS;
	}
}
