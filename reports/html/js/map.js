// The map of a case: what is forbidden, what was planned, what was flown or driven.

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
  for (const path of paths) traces.push({ ...area([path.line], scale, null, INK, "planned path", "dash"), line: { color: INK, width: 1.3, dash: "dash" } });
  vehicles.forEach((vehicle, i) => traces.push(line(times(vehicle.columns.x, 1 / scale), times(vehicle.columns.y, 1 / scale), MEMBERS[i % MEMBERS.length],
    vehicles.length > 1 ? `vehicle ${vehicle.number}` : one.kind === "ground" ? "driven" : "flown",
    { line: { width: 2.2 }, trace: { customdata: Array.from(vehicle.clock), hovertemplate: "at %{customdata:.1f} s<extra>%{fullData.name}</extra>" } })));
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

function drawMap(target, one, run, vehicles) {
  const [west, south, east, north] = one.view;
  const [scale, unit] = scaleOf(Math.max(east - west, north - south));
  const world = one.map === null ? null : DATA.maps[one.map];
  const images = [];
  if (world && world.raster) {
    const { picture, x, y, width, height } = world.raster;
    images.push({ source: picture, xref: "x", yref: "y", x: x / scale, y: (y + height) / scale, sizex: width / scale, sizey: height / scale,
      sizing: "stretch", layer: "below" });
  }
  const layout = layoutOf({
    margin: { l: 58, r: 10, t: 10, b: 42 }, dragmode: "pan", hovermode: "closest", images,
    xaxis: axis(`east [${unit}]`, { range: [west / scale, east / scale], nticks: 9 }),
    yaxis: axis(`north [${unit}]`, { range: [south / scale, north / scale], scaleanchor: "x", scaleratio: 1, nticks: 8 }),
  });
  return window.Plotly.newPlot(target, mapTraces(one, run, vehicles, scale), layout, { ...CONFIG, scrollZoom: false }).then(() => scale);
}

/** What the map's lines mean, and the wind. */
function mapLegend(one, run, vehicles) {
  const world = one.map === null ? null : DATA.maps[one.map];
  const key = (words, style) => make("span", { class: "small muted", style: "margin-right:16px;white-space:nowrap" },
    make("span", { style: `display:inline-block;width:22px;height:10px;vertical-align:-1px;margin-right:5px;${style}` }), words);
  const hasPath = vehicles.some((vehicle) => vehicle.path !== null);
  return make("p", {},
    hasPath && key("planned path", `border-bottom:2px dashed ${INK};height:5px;vertical-align:4px`),
    hasPath && key(`corridor ±${metres(one.corridor)}`, `background:${CORRIDOR_FILL}`),
    vehicles.map((vehicle, i) => key(vehicles.length > 1 ? `vehicle ${vehicle.number}` : one.kind === "ground" ? "driven" : "flown",
      `border-bottom:3px solid ${MEMBERS[i % MEMBERS.length]};height:5px;vertical-align:4px`)),
    world && (world.solid.length > 0 || world.raster) && key("obstacle", `background:${OBSTACLE};border:1px solid ${OBSTACLE_EDGE}`),
    world && world.fences.length > 0 && key("to stay inside", `border:1.5px dashed ${GREEN}`),
    run.focus && key(run.focus.title, `border:3px solid ${run.focus.alarm ? VERMILION : GREEN};border-radius:50%;width:11px;height:11px`),
    make("span", { class: "small muted" }, one.kind !== "ground" || run.wind.some(Boolean) ? run.wind_words : ""),
    !hasPath && make("span", { class: "small muted" }, " · this trial's plan is its own, and not on this page"));
}
