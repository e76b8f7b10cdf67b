// The map of a case: what is forbidden, what was planned, what was flown or driven.

const BESIDE = "(min-width: 1100px)"; // map and plots lie side by side, as the style sheet has it
const LEAST_MAP = 230, MOST_MAP = 780; // [px]
const BELOW_MAP = 430, BELOW_ALONE = 150; // [px] of the window for all but the map, with the instruments and without
const INSTRUMENTS_BESIDE = "(min-width: 1500px), (max-height: 860px)"; // of the map
const MAP_EDGES = [68, 52]; // [px] beside and below the map, for its axes
const THIN = 2; // [px] below which a corridor is not seen

/** Rings as one filled shape: x and y with gaps between them. */
function ringsToLines(rings, scale) {
  const x = [], y = [];
  for (const ring of rings) {
    for (let i = 0; i < ring.length; i += 2) { x.push(ring[i] / scale); y.push(ring[i + 1] / scale); }
    x.push(null);
    y.push(null);
  }
  return { x, y };
}

function area(rings, scale, fill, edge, name, dash) {
  const outline = { color: edge, width: edge ? 1 : 0, dash: dash || "solid" };
  return { type: "scatter", mode: "lines", ...ringsToLines(rings, scale), fill: fill ? "toself" : "none", fillcolor: fill, line: outline,
    name: plain(name), hoverinfo: "skip", connectgaps: false };
}

function mapTraces(one, run, vehicles, scale) {
  const traces = [];
  const world = one.map === null ? null : DATA.maps[one.map];
  if (world) {
    if (world.solid.length) traces.push(area(world.solid, scale, OBSTACLE, OBSTACLE_EDGE, "obstacle"));
    if (world.fences.length) traces.push(area(world.fences, scale, null, GREEN, "to stay inside", "longdashdot"));
    if (world.bounds) {
      const [a, b, c, d] = world.bounds;
      traces.push(area([[a, b, c, b, c, d, a, d, a, b]], scale, null, MUTED, "edge of the map"));
    }
  }
  const paths = vehicles.filter((vehicle) => vehicle.path !== null).map((vehicle) => DATA.paths[vehicle.path]);
  for (const path of paths) traces.push(area(path.corridor, scale, CORRIDOR_FILL, null, "corridor"));
  vehicles.forEach((vehicle, i) => traces.push(line(times(vehicle.columns.x, 1 / scale), times(vehicle.columns.y, 1 / scale), MEMBERS[i % MEMBERS.length],
    vehicles.length > 1 ? `vehicle ${vehicle.number}` : one.kind === "ground" ? "driven" : "flown",
    { line: { width: 3.2 }, trace: { customdata: Array.from(vehicle.clock), hovertemplate: "at %{customdata:.1f} s<extra>%{fullData.name}</extra>" } })));
  for (const path of paths) traces.push({ ...area([path.line], scale, null, INK, "planned path"), line: { color: INK, width: 1.1, dash: "6px,6px" } });
  for (const path of paths) traces.push(...ends(path, scale));
  if (run.focus) {
    const { x, y, title, label, alarm, clock } = run.focus;
    traces.push({ type: "scatter", mode: "markers", x: [x / scale], y: [y / scale], name: "worst", customdata: [clock],
      marker: { symbol: "circle-open", size: 15, color: alarm ? VERMILION : GREEN, line: { width: 3 } },
      hovertemplate: `${plain(title)}<br>${plain(label)}<extra></extra>` });
  }
  return traces;
}

function ends(path, scale) {
  const last = path.line.length - 2;
  const mark = (i, symbol, name) => ({ type: "scatter", mode: "markers", x: [path.line[i] / scale], y: [path.line[i + 1] / scale], name,
    marker: { symbol, size: 9, color: "#ffffff", line: { color: INK, width: 1.8 } }, hovertemplate: `${name}<extra></extra>` });
  return [mark(0, "circle", "start"), mark(last, "square", "goal")];
}

/** Cells as a trace, from the south-west on: an image of the layout would lie below the grid. */
function picture({ picture: source, x, y, width, height, columns, rows }, scale) {
  const [dx, dy] = [width / columns / scale, height / rows / scale];
  return { type: "image", source, x0: x / scale + dx / 2, y0: y / scale + dy / 2, dx, dy, hoverinfo: "skip" };
}

/** Give the map the sides of its view, as large as there is room beside and above the rest; returns its pixels a metre. */
function sizeMap(box, one) {
  const [width, height] = [one.view[2] - one.view[0], one.view[3] - one.view[1]];
  const beside = window.matchMedia(BESIDE).matches;
  const below = window.matchMedia(INSTRUMENTS_BESIDE).matches ? BELOW_ALONE : BELOW_MAP;
  const highest = Math.max(LEAST_MAP, Math.min(MOST_MAP, beside ? window.innerHeight - below : 0.4 * window.innerHeight)) - MAP_EDGES[1];
  const widest = box.parentElement.clientWidth - MAP_EDGES[0];
  const perMetre = Math.min(widest / width, highest / height);
  box.style.height = `${Math.max(LEAST_MAP, Math.round(perMetre * height + MAP_EDGES[1]))}px`;
  box.style.width = `${Math.min(widest, Math.max(LEAST_MAP, Math.round(perMetre * width))) + MAP_EDGES[0]}px`;
  return perMetre;
}

function drawMap(target, one, run, vehicles) {
  const [west, south, east, north] = one.view;
  const [scale, unit] = scaleOf(Math.max(east - west, north - south));
  const world = one.map === null ? null : DATA.maps[one.map];
  const traces = mapTraces(one, run, vehicles, scale);
  if (world && world.raster) traces.unshift(picture(world.raster, scale));
  const layout = layoutOf({
    margin: { l: 58, r: 10, t: 10, b: 42 }, dragmode: "pan", hovermode: "closest",
    xaxis: axis(`east [${unit}]`, { range: [west / scale, east / scale], nticks: 9 }),
    yaxis: axis(`north [${unit}]`, { range: [south / scale, north / scale], scaleanchor: "x", scaleratio: 1, nticks: 8 }),
  });
  return window.Plotly.newPlot(target, traces, layout, { ...CONFIG, scrollZoom: false }).then(() => scale);
}

/** What the map's lines mean, and the wind, where a metre has so many pixels. */
function mapLegend(one, run, vehicles, perMetre) {
  const world = one.map === null ? null : DATA.maps[one.map];
  const key = (words, style, symbol) => make("span", { class: "key" }, make("span", { class: "symbol", style }, symbol), words);
  const hasPath = vehicles.some((vehicle) => vehicle.path !== null);
  const corridor = `corridor ±${metres(one.corridor)}`;
  return [
    hasPath && key("planned path", `border-bottom:2px dashed ${INK};height:5px;vertical-align:4px`),
    hasPath && (2 * one.corridor * perMetre < THIN ? make("span", { class: "key" }, `${corridor}, too thin to see here`) : key(corridor, `background:${CORRIDOR_FILL}`)),
    vehicles.map((vehicle, i) => key(vehicles.length > 1 ? `vehicle ${vehicle.number}` : one.kind === "ground" ? "driven" : "flown",
      `border-bottom:3px solid ${MEMBERS[i % MEMBERS.length]};height:5px;vertical-align:4px`)),
    world && (world.solid.length > 0 || world.raster) && key("obstacle", `background:${OBSTACLE};border:1px solid ${OBSTACLE_EDGE}`),
    world && world.fences.length > 0 && key("to stay inside", `border:1.5px dashed ${GREEN}`),
    run.focus && key(focusWords(run.focus), `border:3px solid ${run.focus.alarm ? VERMILION : GREEN};border-radius:50%;width:11px;height:11px`),
    run.wind.some(Boolean) ? key(run.wind_words, `transform:rotate(${Math.atan2(-run.wind[1], run.wind[0])}rad);line-height:10px`, "➔")
      : one.kind !== "ground" && make("span", { class: "key" }, run.wind_words),
    !hasPath && make("span", { class: "key" }, "this trial's plan is its own, and not on this page"),
  ];
}

/** What the marked place is, within a sentence. */
function focusWords({ title }) {
  return title.charAt(0).toLowerCase() + title.slice(1);
}
