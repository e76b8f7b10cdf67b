// One case: its verdict, its replay with the plots in step, and its tables.

let shownCase = null; // what is on the page of a case now: its player, and how to let go of it

function caseView(row) {
  leaveCase();
  const told = TOLD.cases.find((one) => one.name === row.name) || {};
  const one = DATA.cases[row.name];
  const stage = make("div", { id: "stage" });
  const spreads = make("div", { class: "columns", id: "spreads" });
  const view = byId("one-case");
  view.replaceChildren();
  fill(view, [
    caseHead(row),
    make("p", { class: "muted" }, [caseSetting(row, told), told.corridor && `corridor ±${told.corridor}`, told.path].filter(Boolean).join(" · ")),
    make("p", {}, told.trials ? told.trials.reason : (one || row.decided) && TOLD.rows[row.number - 1].why),
    !row.passed && make("p", { class: "bad" }, make("b", {}, "Not as expected.")),
    stage, spreads,
    make("div", { class: "columns" }, [requirementsTable(told), tightTable(told), steepTable(told)].filter(Boolean)),
    membersTable(told), trialsTable(told), metricsTable(told), notes(told),
    told.command && [make("h3", {}, told.trials ? "To repeat this trial" : "To repeat this case"), command(told.command)],
  ]);
  if (!one) {
    fill(stage, withoutTrack(row));
    return;
  }
  showRun(stage, spreads, row, one, 0);
}

/** Why there is nothing to replay, how to repeat it, and where its plan is told. */
function withoutTrack(row) {
  const { why, seed, command: again } = DATA.absent[row.name];
  const place = TOLD.plans.findIndex((one) => one.cases.includes(row.name));
  return [make("p", { class: "alarm" }, why), seed && make("p", { class: "muted small" }, `planned with seed ${seed}`),
    place >= 0 && make("p", {}, make("a", { href: `#plans-${place + 1}` }, `Its plans, among those on ${TOLD.plans[place].scenario}`)),
    again && [make("h3", {}, "To repeat it"), command(again)]];
}

function caseSetting(row, told) {
  return told.trials ? told.trials.setting : told.setting || [row.vehicle, row.controller, row.speed_words].filter(Boolean).join(" · ");
}

/** The name, the verdict, and the ways to the other cases. */
function caseHead(row) {
  const order = shownRows().map((one) => one.number);
  const at = order.indexOf(row.number);
  const to = (number, words) => make("button", { class: "button", type: "button", disabled: number === undefined,
    onclick: () => { location.hash = `#case-${number}`; } }, words);
  return make("div", { class: "case-head" },
    make("div", { class: "steps" }, make("a", { class: "button", href: "#cases", id: "back" }, "← All cases"),
      to(order[at - 1], "Previous"), to(at < 0 ? order[0] : order[at + 1], "Next")),
    make("h1", { tabindex: "-1", id: "case-name" }, row.name), badge(row.verdict));
}

function leaveCase() {
  if (!shownCase) return;
  shownCase.player.pause();
  shownCase.stop();
  shownCase = null;
}

function runName(run, i, trials) {
  return trials === 1 ? "the run" : `trial ${run.trial}${i === 0 ? " (worst)" : ""}`;
}

/** Replay and plots of run number `index` of a case; `followed` is the place of the vehicle that is followed. */
function showRun(stage, spreads, row, one, index, followed = one.decides) {
  leaveCase();
  const run = one.runs[index];
  const vehicles = run.vehicles.map(unpackedVehicle);
  const again = (place, vehicle) => showRun(stage, spreads, row, one, place, vehicle);
  const mapBox = make("div", { class: "map-box" });
  const mapPlot = make("div", { class: "plot", id: "map", role: "img", "aria-label": `Map of ${row.name}: obstacles, planned path, corridor and track` });
  const canvas = make("canvas", { id: "vehicles", "aria-hidden": "true" });
  const attitude = make("canvas", { class: "attitude", role: "img", "aria-label": one.kind === "ground" ? "Steering of the front wheels" : "Attitude: bank and pitch" });
  const plotsBox = make("div", { class: "plots-box" });
  const plots = make("div", { id: "plots", role: "img", "aria-label": `Error and other series of ${row.name}` });
  const cursor = make("div", { class: "cursor" });
  const over = make("select", { id: "over", onchange: () => drawPlots() },
    make("option", { value: "time" }, "time"), make("option", { value: "distance" }, "distance"));
  const own = make("input", { type: "checkbox", id: "own-scale", onchange: () => drawPlots() });
  const live = readouts(vehicles[followed], one.kind, vehicles.length > 1);
  fill(mapBox, [mapPlot, canvas]);
  fill(plotsBox, [plots, cursor]);
  let scale = null; // of the map, once it is drawn
  let corner = null; // of the map, where the wind is told
  let plotted = null;
  let following = false;
  let gone = false;
  let drawing = Promise.resolve(); // of the map: cells are drawn later, and must find it
  let moved = 0;
  const player = new Player(vehicles, () => show());
  const worst = run.focus && make("button", { class: "button", id: "to-worst", type: "button", onclick: () => player.go(run.focus.clock) }, `→ ${focusWords(run.focus)}`);
  const panel = controls(player, worst, (on) => { following = on; moved = 0; if (!on) wholeMap(); show(); });
  const legend = make("div", { class: "legend" });
  stage.replaceChildren();
  fill(stage, [choices(row, one, index, followed, again), panel.element, make("div", { class: "workbench" },
    make("div", { class: "seen" }, make("div", { class: "ground" }, mapBox, legend), make("div", { class: "instruments" }, attitude, live.element)),
    make("div", { class: "series" }, make("div", { class: "player" }, make("label", {}, "plots over", over), make("label", {}, own, "error on its own scale")), plotsBox)),
    make("p", { class: "muted small" }, "Space plays and pauses, ← and → go along the run, + and − change the speed. A click on a plot goes there.")]);
  fill(legend, mapLegend(one, run, vehicles, sizeMap(mapBox, one)));

  function show() {
    const states = vehicles.map((vehicle) => stateAt(vehicle, player.clock));
    panel.update();
    live.update(states[followed], nearestOther(states, followed));
    drawAttitude(attitude, one, states[followed]);
    if (scale) {
      if (following) followVehicle(states[followed]);
      const at = drawVehicles(canvas, mapBox, mapPlot, scale, one, run, states, followed, corner)[followed];
      canvas.dataset.x = at[0].toFixed(1);
      canvas.dataset.y = at[1].toFixed(1);
    }
    placeCursor(states[followed]);
  }

  function placeCursor(state) {
    if (!plotted) return;
    const { xaxis, _size: size, height } = plots._fullLayout;
    const value = over.value === "time" ? player.clock : state.s / plotted.scale;
    const at = xaxis.l2p(value);
    const inside = at >= -1 && at <= xaxis._length + 1;
    cursor.style.display = inside ? "block" : "none";
    cursor.style.left = `${xaxis._offset + at}px`;
    cursor.style.top = `${size.t}px`;
    cursor.style.height = `${height - size.t - size.b}px`;
    cursor.dataset.at = value.toFixed(3);
  }

  function followVehicle(state) {
    const now = performance.now();
    if (now - moved < 120 || !Number.isFinite(state.x + state.y)) return;
    moved = now;
    const body = one.body.radius ? 2 * one.body.radius : one.body.length;
    const [, , width, height] = projection(mapPlot, scale).box;
    const perPixel = Math.max(4 * one.corridor, 3 * body) / scale / Math.min(width, height);
    const [x, y, across, along] = [state.x / scale, state.y / scale, perPixel * width, perPixel * height];
    drawing = window.Plotly.relayout(mapPlot, { "xaxis.range": [x - across, x + across], "yaxis.range": [y - along, y + along] });
  }

  function placeWind() {
    if (!gone && !following) corner = windCorner(mapPlot, scale, run, vehicles);
  }

  function wholeMap() {
    const [west, south, east, north] = one.view.map((value) => value / scale);
    drawing = window.Plotly.relayout(mapPlot, { "xaxis.range": [west, east], "yaxis.range": [south, north] });
  }

  function drawPlots() {
    const told = panelTraces(vehicles, followed, over.value);
    const layout = panelLayout(told.panels, vehicles, told.label, own.checked, plotsBox.clientWidth);
    plots.style.height = `${layout.height}px`;
    return window.Plotly.react(plots, told.traces, layout, CONFIG).then(() => {
      plotted = told;
      show();
    });
  }

  const keys = (event) => replayKeys(event, player);
  const resized = () => {
    sizeMap(mapBox, one);
    if (scale) drawing = window.Plotly.Plots.resize(mapPlot).then(placeWind);
    show();
  };
  document.addEventListener("keydown", keys);
  window.addEventListener("resize", resized);
  shownCase = { player, run, stop: () => {
    gone = true;
    document.removeEventListener("keydown", keys);
    window.removeEventListener("resize", resized);
    drawing.finally(() => { for (const plot of [mapPlot, plots]) if (plot._fullLayout) window.Plotly.purge(plot); });
  } };
  show();
  withPlotly(async () => {
    if (gone) return;
    drawing = drawMap(mapPlot, one, run, vehicles);
    scale = await drawing;
    placeWind();
    await drawPlots();
    if (gone) return;
    const jump = (event) => { player.go(Number(event.points[0].customdata)); };
    plots.on("plotly_click", jump);
    mapPlot.on("plotly_click", (event) => { if (event.points[0].customdata !== undefined) jump(event); });
    for (const name of ["plotly_relayout", "plotly_relayouting", "plotly_afterplot"]) {
      mapPlot.on(name, () => show());
      plots.on(name, () => placeCursor(stateAt(vehicles[followed], player.clock)));
    }
    drawSpreads(spreads, row, one, run);
    stage.dataset.ready = "yes";
    show();
  });
}

/** Which trial is shown, and which vehicle of a fleet; nothing where there is but one. */
function choices(row, one, index, followed, again) {
  const option = (value, words, chosen) => make("option", { value, selected: chosen }, words);
  const trials = one.runs.length > 1 && make("label", {}, "replay of", make("select", { id: "run", onchange: (event) => again(Number(event.target.value), followed) },
    one.runs.map((run, i) => option(i, runName(run, i, row.trials), i === index))));
  const vehicles = one.runs[index].vehicles;
  const which = vehicles.length > 1 && make("label", {}, "vehicle", make("select", { id: "vehicle", onchange: (event) => again(index, Number(event.target.value)) },
    vehicles.map((vehicle, i) => option(i, `${vehicle.number}${i === one.decides ? " (decides)" : ""}`, i === followed))));
  const told = [row.trials > 1 && `${runName(one.runs[index], index, row.trials)} of ${row.trials}`, `seed ${one.runs[index].seed}`,
    one.left_out > 0 && `the tracks of ${one.left_out} more trials were left out, to keep this file small`].filter(Boolean).join(" · ");
  return make("div", { class: "player" }, trials, which, make("span", { class: "muted small" }, told));
}

/** Band and distribution over the trials, where there are several. */
function drawSpreads(target, row, one, run) {
  const spread = DATA.spread[row.name];
  target.replaceChildren();
  if (!spread) return;
  const band = make("div", { role: "img", "aria-label": "Cross-track error over the trials" });
  const chart = make("div", { role: "img", "aria-label": "Distribution of a metric over the trials" });
  const draw = (place) => {
    const metric = spread.metrics[place];
    distributionPlot(chart, metric, metric.values[spread.trials.indexOf(run.trial)]);
  };
  const metric = make("select", { id: "metric", onchange: (event) => draw(Number(event.target.value)) },
    spread.metrics.map((one_, i) => make("option", { value: i }, one_.words)));
  fill(target, [make("div", {}, make("div", { class: "player" }, make("span", { class: "muted small" }, "over all trials")), band),
    make("div", {}, make("div", { class: "player" }, make("label", {}, "metric", metric)), chart)]);
  bandPlot(band, spread, one.corridor);
  draw(0);
}
