// Buttons operated by pointer, touch and keyboard. Several may be held at a time.
// press(name, down) is called once for each change.

const KEYS = {
	ArrowUp: "UP", ArrowDown: "DOWN", ArrowLeft: "LEFT", ArrowRight: "RIGHT",
	Enter: "ENTER", F6: "F6", F8: "F8", F9: "F9", F10: "F10",
	6: "F6", 8: "F8", 9: "F9", 0: "F10",
};
const CLICK_MS = 150;

export class Keypad {
	constructor(element, press) {
		this.press = press;
		this.buttons = new Map();
		// For each button's name, the pointers and keys that hold it.
		this.holders = new Map();
		for (const button of element.querySelectorAll("[data-button]")) {
			this.buttons.set(button.dataset.button, button);
			this.listen(button, button.dataset.button);
		}
		addEventListener("keydown", (event) => this.keyDown(event));
		addEventListener("keyup", (event) => this.letGo(`key ${event.code}`));
		addEventListener("blur", () => this.letGoAll());
		document.addEventListener("visibilitychange", () => this.letGoAll());
	}

	listen(button, name) {
		button.addEventListener("pointerdown", (event) => {
			if (event.button === 0) {
				button.setPointerCapture(event.pointerId);
				this.hold(name, `pointer ${event.pointerId}`);
			}
		});
		for (const kind of ["pointerup", "pointercancel", "lostpointercapture"]) {
			button.addEventListener(kind, (event) => {
				this.letGo(`pointer ${event.pointerId}`);
			});
		}
		button.addEventListener("contextmenu", (event) => event.preventDefault());
		// A click without a pointer, as screen readers make it.
		button.addEventListener("click", (event) => {
			if (event.detail === 0 && event.pointerId < 0) {
				this.hold(name, "click");
				setTimeout(() => this.letGo("click"), CLICK_MS);
			}
		});
	}

	keyDown(event) {
		const target = event.target;
		if (event.ctrlKey || event.altKey || event.metaKey ||
			target.matches("input, pre")) {
			return;
		}
		const own = event.key === "Enter" || event.key === " ";
		if (own && target.matches("button:not([data-button])")) {
			return;
		}
		const name = own && target.dataset.button || KEYS[event.key];
		if (name) {
			event.preventDefault();
			if (!event.repeat) {
				this.hold(name, `key ${event.code}`);
			}
		}
	}

	hold(name, holder) {
		const holders = this.holders.get(name) ?? new Set();
		this.holders.set(name, holders.add(holder));
		if (holders.size === 1) {
			this.press(name, true);
		}
	}

	letGo(holder) {
		for (const [name, holders] of this.holders) {
			if (holders.delete(holder) && holders.size === 0) {
				this.press(name, false);
			}
		}
	}

	letGoAll() {
		for (const holders of this.holders.values()) {
			for (const holder of [...holders]) {
				this.letGo(holder);
			}
		}
	}

	// Shows the buttons that are down on the board, whichever page holds them.
	show(held) {
		for (const [name, button] of this.buttons) {
			button.toggleAttribute("data-down", held.includes(name));
		}
	}
}
