// The console: understands line endings, backspace and escape sequences, but no
// other features of a terminal. Input is sent line by line.

const LINES_KEPT = 2000;
const HISTORY_KEPT = 100;

export class Console {
	constructor(log, form, type) {
		this.log = log;
		this.type = type;
		this.clear();
		this.history = [];
		this.at = 0;
		this.input = form.querySelector("input");
		form.addEventListener("submit", (event) => this.submit(event));
		this.input.addEventListener("keydown", (event) => this.keyDown(event));
	}

	clear() {
		this.lines = [""];
		this.column = 0;
		this.escape = "";
		this.log.textContent = "";
	}

	submit(event) {
		event.preventDefault();
		const text = this.input.value;
		this.type(text + "\n");
		if (text && text !== this.history.at(-1)) {
			this.history.push(text);
			this.history.splice(0, this.history.length - HISTORY_KEPT);
		}
		this.at = this.history.length;
		this.input.value = "";
	}

	keyDown(event) {
		const step = { ArrowUp: -1, ArrowDown: 1 }[event.key];
		if (step) {
			event.preventDefault();
			this.at = Math.min(Math.max(this.at + step, 0), this.history.length);
			this.input.value = this.history[this.at] ?? "";
		} else if (event.ctrlKey && event.key === "c" &&
			this.input.selectionStart === this.input.selectionEnd) {
			event.preventDefault();
			this.type("\x03");
		} else if (event.ctrlKey && event.key === "d") {
			event.preventDefault();
			this.type("\x04");
		}
	}

	say(text) {
		const box = this.log;
		const follow = box.scrollTop + box.clientHeight > box.scrollHeight - 24;
		for (const letter of text) {
			this.take(letter);
		}
		this.lines.splice(0, this.lines.length - LINES_KEPT);
		box.textContent = this.lines.join("\n");
		if (follow) {
			box.scrollTop = box.scrollHeight;
		}
	}

	take(letter) {
		// ESC [ parameters and a character, or ESC and one character (ECMA-48
		// section 5.4). A control character ends a sequence that is broken.
		if (this.escape && letter >= " ") {
			this.escape += letter;
			if (!/^\x1b\[[0-?]*[ -/]*$/.test(this.escape)) {
				this.escape = "";
			}
			return;
		}
		this.escape = "";
		if (letter === "\x1b") {
			this.escape = letter;
		} else if (letter === "\n") {
			this.lines.push("");
			this.column = 0;
		} else if (letter === "\r") {
			this.column = 0;
		} else if (letter === "\b") {
			this.column = Math.max(0, this.column - 1);
		} else if (letter >= " " || letter === "\t") {
			const line = this.lines.at(-1);
			this.lines[this.lines.length - 1] = line.slice(0, this.column) +
				letter + line.slice(this.column + letter.length);
			this.column += letter.length;
		}
	}
}
