// The replay: one clock, and everything that shows a moment of the run in step with it.

const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16, 32, 64, 128, 256, 512];
const WATCHED = 20; // [s] that a replay takes at most at the speed it starts with, if that is not the fastest
const STEPS = 200; // arrow keys go through the run in so many

/** What a vehicle does at `clock` [s]: all its columns there, and whether it waits or has arrived. */
function stateAt(vehicle, clock) {
  const place = located(vehicle.clock, clock);
  const state = {};
  for (const [key, column] of Object.entries(vehicle.columns)) {
    state[key] = key === "heading" ? angleBetween(column, place) : between(column, place);
  }
  const last = vehicle.clock[vehicle.clock.length - 1];
  return { ...state, waiting: clock < vehicle.clock[0], arrived: clock > last, clock };
}

/** How far the nearest other vehicle that is under way is [m]; Infinity where there is none. */
function nearestOther(states, followed) {
  const away = (one) => one.waiting || one.arrived;
  const own = states[followed];
  const others = states.filter((one, i) => i !== followed && !away(one) && !away(own));
  return Math.min(...others.map((one) => Math.hypot(one.x - own.x, one.y - own.y, (one.z || 0) - (own.z || 0))));
}

class Player {
  constructor(vehicles, show) {
    this.vehicles = vehicles;
    this.show = show;
    this.start = Math.min(...vehicles.map((one) => one.clock[0]));
    this.end = Math.max(...vehicles.map((one) => one.clock[one.clock.length - 1]));
    this.speed = SPEEDS.find((one) => one >= 1 && (this.end - this.start) / one <= WATCHED) || SPEEDS[SPEEDS.length - 1];
    this.clock = this.start;
    this.playing = false;
    this.frame = null;
  }

  go(clock) {
    this.clock = Math.min(this.end, Math.max(this.start, clock));
    this.show(this);
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.clock >= this.end) this.clock = this.start;
    this.playing = true;
    let before = performance.now();
    const step = (now) => {
      if (!this.playing) return;
      const passed = Math.max(0, now - before) / 1000;
      before = now;
      this.go(this.clock + passed * this.speed);
      if (this.clock >= this.end) this.pause();
      else this.frame = requestAnimationFrame(step);
    };
    this.frame = requestAnimationFrame(step);
    this.show(this);
  }

  pause() {
    this.playing = false;
    cancelAnimationFrame(this.frame);
    this.show(this);
  }

  faster(by) {
    const place = SPEEDS.indexOf(this.speed) + by;
    this.speed = SPEEDS[Math.max(0, Math.min(SPEEDS.length - 1, place))];
    this.show(this);
  }
}

/** The buttons, the slider and the clock of a player, and the way to its `worst` moment; `update` brings them in step with it. */
function controls(player, worst, follow) {
  const play = make("button", { class: "button main-button", id: "play", type: "button", onclick: () => player.toggle() }, "▶ Play");
  const slider = make("input", { type: "range", id: "scrub", min: 0, max: 10000, step: 1, value: 0, "aria-label": "moment of the replay",
    oninput: (event) => player.go(player.start + ((player.end - player.start) * event.target.value) / 10000) });
  const speed = make("select", { id: "speed", "aria-label": "speed of the replay", onchange: (event) => { player.speed = Number(event.target.value); } },
    SPEEDS.map((one) => make("option", { value: one }, `${one}×`)));
  const clock = make("span", { class: "clock", id: "clock", role: "timer" });
  const following = make("input", { type: "checkbox", id: "follow", onchange: (event) => follow(event.target.checked) });
  const update = () => {
    const words = player.playing ? "❚❚ Pause" : "▶ Play";
    if (play.textContent !== words) play.textContent = words;
    slider.value = Math.round((10000 * (player.clock - player.start)) / (player.end - player.start || 1));
    slider.setAttribute("aria-valuetext", `${steady(player.clock, 1)} s`);
    speed.value = String(player.speed);
    clock.textContent = `${steady(player.clock, 1)} of ${steady(player.end, 1)} s`;
  };
  const element = make("div", { class: "player transport", role: "group", "aria-label": "Replay" }, play, clock, slider,
    make("label", {}, make("span", {}, "speed"), speed), make("label", {}, following, "follow"), worst);
  return { element, update };
}

/** Space plays, arrows go along the run, + and − change the speed; not while something is being typed or chosen. */
function replayKeys(event, player) {
  const tag = event.target.tagName;
  if (event.ctrlKey || event.altKey || event.metaKey || tag === "SELECT" || tag === "SUMMARY" || event.target.type === "search") return;
  const pressing = tag === "BUTTON" || tag === "A" || event.target.type === "checkbox";
  const step = ((player.end - player.start) / STEPS) * (event.shiftKey ? 10 : 1);
  const actions = { " ": () => player.toggle(), ArrowRight: () => player.go(player.clock + step), ArrowLeft: () => player.go(player.clock - step),
    "+": () => player.faster(1), "-": () => player.faster(-1) };
  const action = actions[event.key];
  if (!action || (event.key === " " && pressing)) return;
  event.preventDefault();
  action();
}

const READOUTS = [
  ["along the path", "s", (value) => `${steady(value, value >= 10000 ? 0 : 1)} m`],
  ["cross-track error", "cross_track", (value) => `${steady(Math.abs(value), 2)} m${Math.abs(value) < 0.005 ? "" : value > 0 ? " left" : " right"}`],
  ["height", "z", (value) => `${steady(value, 1)} m`],
  ["ground speed", "ground_speed", (value) => `${steady(value, 1)} m/s`],
  ["airspeed", "airspeed", (value) => `${steady(value, 1)} m/s`],
  ["climb", "climb_rate", (value) => `${steady(value, 1)} m/s`],
  ["heading", "heading", (value) => `${steady((((90 - value) % 360) + 360) % 360, 0)}° true`],
  ["load factor", "load_factor", (value) => `${steady(value, 2)} g`],
  ["lateral acceleration", "lateral_acceleration", (value) => `${steady(value, 2)} g`],
];

/** The live values of the vehicle that is followed. */
function readouts(vehicle, kind, fleet) {
  const shown = READOUTS.filter(([, key]) => key in vehicle.columns);
  const cells = shown.map(([words, key]) => [words, make("td", { "data-live": key })]);
  const state = make("td", { "data-live": "state" });
  const nearest = make("td", { "data-live": "nearest" });
  const rows = [...cells.map(([words, cell]) => make("tr", {}, make("td", {}, kind === "ground" && words === "ground speed" ? "speed" : words), cell)),
    fleet && make("tr", {}, make("td", {}, "nearest vehicle"), nearest), make("tr", {}, make("td", {}, "state"), state)];
  const update = (now, distance) => {
    nearest.textContent = Number.isFinite(distance) ? metres(distance) : "none under way";
    shown.forEach(([, key, format], i) => { cells[i][1].textContent = format(now[key]); });
    state.textContent = now.waiting ? `leaves at ${steady(vehicle.departure, 0)} s` : now.arrived ? vehicle.ended : "under way";
  };
  return { element: make("table", { class: "live" }, make("tbody", {}, rows)), update };
}
