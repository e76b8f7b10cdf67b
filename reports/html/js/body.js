// The vehicles on their map, drawn over it at any moment.

const WIND_ROOM = 60; // [px] that a path must keep from the arrow of the wind
const TO_SCALE = 9; // [px] the length from which a body is drawn as it is

/** A canvas that covers `box`, and its context in CSS pixels. */
function overlay(canvas, box) {
  const ratio = window.devicePixelRatio || 1;
  const { clientWidth: width, clientHeight: height } = box;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}

/** From metres to pixels of the map as it is zoomed now. */
function projection(plot, scale) {
  const { xaxis, yaxis } = plot._fullLayout;
  return {
    at: (x, y) => [xaxis._offset + xaxis.l2p(x / scale), yaxis._offset + yaxis.l2p(y / scale)],
    perMetre: Math.abs(xaxis.l2p(1 / scale) - xaxis.l2p(0)),
    box: [xaxis._offset, yaxis._offset, xaxis._length, yaxis._length],
  };
}

function drawVehicles(canvas, box, plot, scale, one, run, states, followed, corner) {
  const context = overlay(canvas, box);
  const to = projection(plot, scale);
  context.save();
  context.beginPath();
  context.rect(...to.box);
  context.clip();
  states.forEach((state, i) => {
    if (!Number.isFinite(state.x + state.y)) return;
    const [x, y] = to.at(state.x, state.y);
    context.save();
    context.translate(x, y);
    context.rotate((-state.heading * Math.PI) / 180);
    context.globalAlpha = state.waiting ? 0.45 : 1;
    drawBody(context, one, to.perMetre, MEMBERS[i % MEMBERS.length], i === followed);
    context.restore();
    if (states.length > 1) tag(context, String(i + 1), x + 12, y - 10);
  });
  if (corner) windArrow(context, to.box, run.wind, corner);
  context.restore();
  return states.map((state) => to.at(state.x, state.y));
}

/** A body that faces to the right: to scale where it is large enough, a mark of its kind elsewhere. */
function drawBody(context, one, perMetre, colour, followed) {
  context.lineWidth = followed ? 2 : 1.4;
  context.strokeStyle = INK;
  context.fillStyle = colour;
  context.lineJoin = "round";
  if (one.kind === "ground") {
    const { length, width, ahead } = one.body;
    const scale = Math.max(perMetre, TO_SCALE / length) * (perMetre * length < TO_SCALE ? 1.6 : 1);
    const [l, w, a] = perMetre * length < TO_SCALE ? [length * scale, length * scale * 0.5, 0] : [length * scale, width * scale, ahead * scale];
    context.beginPath();
    context.rect(a - l / 2, -w / 2, l, w);
    context.fill();
    context.stroke();
    context.beginPath(); // its cab, so that front and rear are told apart
    context.rect(a + l / 2 - l * 0.24, -w / 2, l * 0.24, w);
    context.fillStyle = "#ffffff";
    context.fill();
    context.stroke();
    return;
  }
  const span = Math.max(12, one.body.radius * perMetre);
  const shape = [[1.1, 0], [0.75, 0.13], [0.3, 0.14], [0.02, 1], [-0.22, 1], [-0.1, 0.13], [-0.7, 0.09], [-0.85, 0.38], [-1, 0.38], [-0.95, 0]];
  context.beginPath();
  for (const [x, y] of shape) context.lineTo(x * span, y * span);
  for (const [x, y] of [...shape].reverse()) context.lineTo(x * span, -y * span);
  context.closePath();
  context.lineWidth = followed ? 1.4 : 1;
  context.fill();
  context.stroke();
}

function tag(context, words, x, y) {
  context.font = `600 11px ${FONT}`;
  context.lineWidth = 3;
  context.strokeStyle = "#ffffff";
  context.strokeText(words, x, y);
  context.fillStyle = INK;
  context.fillText(words, x, y);
}

/** The corner of the whole map where the arrow of the wind covers nothing of the paths, as shares; null for none. */
function windCorner(plot, scale, run, vehicles) {
  if (!run.wind.some(Boolean)) return null;
  const to = projection(plot, scale);
  const lines = vehicles.flatMap(({ path, columns: { x, y } }) => [...(path === null ? [] : [DATA.paths[path].line]), Array.from(x).flatMap((east, i) => [east, y[i]])]);
  const room = (corner) => {
    const [x, y] = windPlace(to.box, corner);
    return Math.min(...lines.map((line) => distanceTo(line, to, x, y)));
  };
  const best = [[1, 0], [0, 0], [1, 1], [0, 1]].map((corner) => [room(corner), corner]).reduce((a, b) => (b[0] > a[0] && a[0] < WIND_ROOM ? b : a));
  return best[0] < WIND_ROOM ? null : best[1];
}

/** How far the line x, y, x, y, ... [m] passes from a point of the map, all in pixels. */
function distanceTo(line, to, x, y) {
  let nearest = Infinity;
  let [x0, y0] = to.at(line[0], line[1]);
  for (let i = 2; i < line.length; i += 2) {
    const [x1, y1] = to.at(line[i], line[i + 1]);
    const along = ((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / ((x1 - x0) ** 2 + (y1 - y0) ** 2 || 1);
    const share = Math.max(0, Math.min(1, along));
    nearest = Math.min(nearest, Math.hypot(x0 + share * (x1 - x0) - x, y0 + share * (y1 - y0) - y));
    [x0, y0] = [x1, y1];
  }
  return nearest;
}

/** Where the arrow stands in a `corner` of the map: below the plot's own buttons, and clear of its edges. */
function windPlace([left, top, width, height], [east, south]) {
  return [left + (east ? width - 46 : 46), top + (south ? height - 50 : 48)];
}

/** Where the wind blows to. */
function windArrow(context, box, [east, north], corner) {
  const speed = Math.hypot(east, north);
  const [x, y] = windPlace(box, corner);
  context.save();
  context.translate(x, y);
  context.rotate(Math.atan2(-north, east));
  context.fillStyle = INK;
  context.strokeStyle = "#ffffff";
  context.lineWidth = 1;
  context.beginPath();
  for (const [x, y] of [[-18, -2.2], [6, -2.2], [6, -7], [18, 0], [6, 7], [6, 2.2], [-18, 2.2]]) context.lineTo(x, y);
  context.closePath();
  context.fill();
  context.stroke();
  context.restore();
  context.textAlign = "center";
  tag(context, `wind ${digits(speed)} m/s`, x, y + 34);
  context.textAlign = "start";
}
