// The 3D view and the controls of its playhead, which lives in the service.

import { byId, h } from "./dom.js";

const SPEEDS = [0.25, 0.5, 1, 2, 4];
const NOT_THERE = 4404;
const PATIENCE = 10000; // [ms] until a 3D view that does not come is loaded again, at first

export class RolloutView {
  /** `moved(time)` is told the moment shown [s], many times a second; `alone` is a page of its own. */
  constructor(moved, { alone = false } = {}) {
    this.alone = alone;
    this.root = byId("rollout-view");
    this.moved = moved;
    this.moment = null;
    this.reset();
    const turn = () => {
      if (this.moment) this.draw();
      requestAnimationFrame(turn);
    };
    requestAnimationFrame(turn);
  }

  reset(text = "The robot at work appears here, live, and can be replayed at any later time.") {
    this.stop();
    this.root.replaceChildren(h("div", { class: "stage empty" }, h("p", { class: "hint" }, text)));
  }

  stop() {
    this.execution = null;
    this.moment = null;
    clearTimeout(this.again);
    this.socket?.close();
    this.socket = null;
  }

  show(execution) {
    if (this.execution === execution) return;
    this.stop();
    this.execution = execution;
    this.token = Math.random().toString(36).slice(2, 12);
    const dark = matchMedia("(prefers-color-scheme: dark)").matches ? "?darkMode" : "";
    this.frame = h("iframe", { src: `/viewer/${execution}/${this.token}/${dark}`, title: "The rollout in 3D", class: "picture" });
    this.waiting = h("p", { class: "waiting", role: "status" }, "Setting up the 3D view …");
    this.root.replaceChildren(h("div", { class: "stage" }, this.frame, this.waiting), this.controls(execution));
    this.patience = PATIENCE;
    this.connect();
  }

  controls(execution) {
    this.button = h("button", { type: "button", class: "small play", onclick: () => this.toggle() }, "Pause");
    this.slider = h("input", {
      type: "range", disabled: true, min: 0, max: 1, step: 0.05, value: 0, "aria-label": "Moment of the rollout, in seconds",
      oninput: () => this.send({ mode: "paused", time: Number(this.slider.value) }),
    });
    this.clock = h("output", { class: "clock" }, "0.0 s");
    this.speed = h("select", { "aria-label": "Speed", onchange: () => this.send({ speed: Number(this.speed.value) }) },
      SPEEDS.map((speed) => h("option", { value: speed, selected: speed === 1 }, `${speed}×`)));
    this.live = h("button", { type: "button", class: "small live", "aria-pressed": "false", onclick: () => this.follow() }, "Follow live");
    const alone = !this.alone && h("a", { class: "button small quiet", href: `/viewer/${execution}/`, target: "_blank", rel: "noopener" }, "Open alone");
    return h("div", { class: "controls" }, this.button, this.slider, this.clock, this.speed, this.live, alone);
  }

  connect() {
    this.since = performance.now();
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/viewer/${this.execution}/${this.token}/playhead`);
    this.socket = socket;
    // Without motion it stands still, at the end as soon as there is one, unless somebody moves it.
    this.still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (this.still) socket.onopen = () => this.tell({ mode: "paused" });
    socket.onmessage = (message) => {
      this.moment = JSON.parse(message.data);
      if (this.still && this.moment.finished) this.seek(this.moment.duration);
      this.told = performance.now();
    };
    socket.onclose = (event) => {
      if (this.socket !== socket) return;
      if (event.code === NOT_THERE) this.reset(event.reason || "There is nothing to be seen of it.");
      else this.lose();
    };
  }

  /** The service has gone: as soon as it is back, so is the picture. */
  lose() {
    this.moment = null;
    this.slider.disabled = true;
    this.waiting.textContent = "The service cannot be reached; trying again …";
    this.waiting.hidden = false;
    this.again = setTimeout(async () => {
      const back = await fetch("/healthz").then((answer) => answer.ok, () => false);
      if (!this.execution) return;
      if (!back) return this.lose();
      this.waiting.textContent = "Setting up the 3D view …";
      this.loadAgain();
      this.connect();
    }, 1500);
  }

  loadAgain() {
    this.frame.src = this.frame.getAttribute("src");
  }

  /** A frame whose page failed to load stays empty, and no event tells of it. */
  awaitDrawing(drawn) {
    const now = performance.now();
    if (drawn) {
      this.since = now;
      this.patience = PATIENCE;
    } else if (now - this.since > this.patience) {
      this.since = now;
      this.patience *= 2;
      this.loadAgain();
    }
  }

  /** What somebody wants of the playhead. */
  send(command) {
    this.still = false;
    this.tell(command);
  }

  tell(command) {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(command));
  }

  /** Jump to a moment [s] and stay there. */
  seek(time) {
    this.send({ mode: "paused", time });
  }

  toggle() {
    this.send({ mode: this.moment?.mode === "paused" ? "playing" : "paused" });
  }

  follow() {
    this.send({ mode: this.moment?.mode === "following" ? "playing" : "following" });
  }

  /** The moment shown now [s]: the service tells it ten times a second, in between it is reckoned. */
  now() {
    const { time, duration, mode, speed, drawn } = this.moment;
    if (mode !== "playing" || !drawn) return time;
    return Math.min(duration, time + (Math.min(performance.now() - this.told, 300) / 1000) * speed);
  }

  draw() {
    const { duration, mode, finished, drawn } = this.moment;
    const time = this.now();
    this.awaitDrawing(drawn);
    this.waiting.hidden = drawn;
    this.slider.disabled = !drawn || duration === 0;
    this.slider.max = Math.max(duration, 0.1);
    if (document.activeElement !== this.slider || mode !== "paused") this.slider.value = time;
    this.slider.setAttribute("aria-valuetext", `${time.toFixed(1)} of ${duration.toFixed(1)} seconds`);
    const text = `${time.toFixed(1)} / ${duration.toFixed(1)} s`;
    if (this.clock.textContent !== text) this.clock.textContent = text;
    const label = mode !== "paused" ? "Pause" : time >= duration - 0.05 && finished ? "Replay" : "Play";
    if (this.button.textContent !== label) this.button.textContent = label;
    this.live.hidden = finished;
    this.live.setAttribute("aria-pressed", String(mode === "following"));
    this.moved(time);
  }
}
