// Connects screen, keypad, switches and console to the server's socket.

import { Screen } from "./screen.js";
import { Keypad } from "./keypad.js";
import { Console } from "./console.js";

const AGAIN_MS = 1000;
const PHASES = {
	off: ["off", "The board is off", ""],
	starting: ["starting", "", ""],
	booting: ["booting", "", ""],
	running: ["running", "", ""],
	halted: ["stopped", "The board has stopped", "Reset"],
	ended: ["stopped", "The board has stopped", "Start again"],
	lost: ["no server", "The server has ended", ""],
};

const find = (id) => document.getElementById(id);
const screen = new Screen(find("screen"));
let socket = null;
let state = { phase: "lost", why: "", camera: false, camera_seen: false, held: [] };

function send(message) {
	if (socket?.readyState === WebSocket.OPEN) {
		socket.send(JSON.stringify(message));
	}
}

const keypad = new Keypad(find("keypad"), (name, down) => {
	send({ type: "button", name, down });
});
const log = new Console(find("log"), find("line"), (text) => {
	send({ type: "type", text });
});

function isOn() {
	return ["starting", "booting", "running", "halted"].includes(state.phase);
}

function showNotice([, title, action]) {
	const notice = find("notice");
	const [strong, text, button] = notice.children;
	notice.hidden = !title;
	strong.textContent = title;
	const why = state.phase === "off" ? "Its power switch is beside the screen." :
		state.phase === "lost" ? "make virtual-pdk starts it; this page comes back by itself." :
			state.why && `${state.why[0].toUpperCase()}${state.why.slice(1)}.`;
	text.textContent = why;
	button.hidden = !action;
	button.textContent = action;
}

function showState() {
	const phase = PHASES[state.phase];
	find("phase").textContent = phase[0];
	find("led").dataset.phase = state.phase;
	document.title = state.phase === "running" ? "Virtual PDK" :
		`Virtual PDK: ${phase[0]}`;
	showNotice(phase);
	find("power").setAttribute("aria-checked", isOn());
	find("camera").setAttribute("aria-checked", state.camera);
	find("camera").toggleAttribute("data-pending",
		isOn() && state.camera !== state.camera_seen);
	for (const id of ["power", "camera"]) {
		find(id).disabled = state.phase === "lost";
	}
	/* These have no effect on a board that is off. */
	for (const id of ["reset", "text"]) {
		find(id).disabled = !isOn();
	}
	keypad.show(state.held);
	showRate();
}

function showRate() {
	const rate = screen.rate();
	find("rate").textContent = state.phase !== "running" ? "" :
		rate ? `${rate.toFixed(rate < 10 ? 1 : 0)} pictures/s` : "picture at rest";
}

function take(message) {
	if (message.type === "state") {
		state = message;
		showState();
	} else if (message.type === "log") {
		if (message.fresh) {
			log.clear();
		}
		log.say(message.text);
	}
}

function tellVisible() {
	send({ type: "visible", on: document.visibilityState === "visible" });
}

function connect() {
	socket = new WebSocket(`ws://${location.host}/socket`);
	socket.binaryType = "arraybuffer";
	socket.addEventListener("open", tellVisible);
	socket.addEventListener("message", ({ data }) => {
		if (typeof data === "string") {
			take(JSON.parse(data));
		} else {
			screen.draw(data);
			send({ type: "shown" });
		}
	});
	socket.addEventListener("close", () => {
		state = { ...state, phase: "lost", held: [], camera_seen: false };
		showState();
		setTimeout(connect, AGAIN_MS);
	});
}

find("power").addEventListener("click", () => send({ type: "power", on: !isOn() }));
find("camera").addEventListener("click", () => send({ type: "camera", on: !state.camera }));
find("reset").addEventListener("click", () => send({ type: "reset" }));
find("notice").querySelector("button").addEventListener("click", () => send({ type: "reset" }));
for (const button of document.querySelectorAll("button")) {
	// Keeps the keyboard focus on the keypad after a click.
	button.addEventListener("mousedown", (event) => event.preventDefault());
}
document.addEventListener("visibilitychange", tellVisible);
setInterval(showRate, 500);
connect();
