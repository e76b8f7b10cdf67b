// Plots of a run over time or distance, one under the other, with one cursor through all of them.

const INK = "#1b2733", MUTED = "#5b6875", GRID = "#e4e9ee", AXIS = "#aab4be";
const BLUE = "#0072b2", SKY = "#56b4e9", GREEN = "#009e73", VERMILION = "#d55e00", ORANGE = "#e69f00", PURPLE = "#cc79a7";
const OBSTACLE = "#c3cad2", OBSTACLE_EDGE = "#77828e";
const MEMBERS = [BLUE, ORANGE, GREEN, PURPLE, SKY];
const CORRIDOR_FILL = "rgba(86,180,233,0.22)";
const FONT = 'system-ui, -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif';
const CONFIG = { displaylogo: false, responsive: true, modeBarButtons: [["zoom2d", "pan2d", "zoomIn2d", "zoomOut2d", "resetScale2d"]] };
const MODEBAR = { bgcolor: "rgba(255,255,255,0.85)", color: MUTED, activecolor: BLUE };
const PANEL_HEIGHT = 142, FIRST_EXTRA = 1.45; // [px] of a panel; the first, the error, is higher
const LETTER = 6.6; // [px] of what stands over a panel, about
const KILO_FROM = 10000; // [m] beyond which axes are in kilometres

function axis(title, more) {
  return { title: { text: title, font: { size: 12, color: MUTED }, standoff: 6 }, gridcolor: GRID, linecolor: AXIS, tickcolor: AXIS,
    tickfont: { size: 11, color: MUTED }, zeroline: false, automargin: true, exponentformat: "none", ...more };
}

function layoutOf(more) {
  return { font: { family: FONT, color: INK, size: 12 }, paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
    margin: { l: 66, r: 14, t: 26, b: 44 }, hoverlabel: { font: { family: FONT, size: 12 } }, showlegend: false, modebar: MODEBAR, ...more };
}

function line(x, y, colour, name, more) {
  return { type: "scatter", mode: "lines", x, y, name: plain(name), line: { color: colour, width: 1.6, ...(more && more.line) },
    connectgaps: false, ...(more && more.trace) };
}

function scaleOf(largest) {
  return largest >= KILO_FROM ? [1000, "km"] : [1, "m"];
}

const times = (values, factor) => (factor === 1 ? Array.from(values) : Array.from(values, (value) => value * factor));

/** What is plotted of a run: the error of each vehicle, and the other panels of the one that is followed. */
function panelTraces(vehicles, followed, over) {
  const vehicle = vehicles[followed];
  const longest = Math.max(...vehicles.map((one) => one.columns.s[one.columns.s.length - 1] || 0));
  const [scale, unit] = scaleOf(longest);
  const across = (one) => (over === "time" ? Array.from(one.clock) : times(one.columns.s, 1 / scale));
  const traces = [], panels = [];
  const ordered = [...vehicle.panels].sort((a, b) => (b.corridor !== null) - (a.corridor !== null));
  ordered.forEach((panel, i) => {
    const axes = { xaxis: "x", yaxis: i === 0 ? "y" : `y${i + 1}` };
    const add = (one, values, colour, name, look) => traces.push(line(across(one), Array.from(values), colour, name,
      { line: look, trace: { ...axes, customdata: Array.from(one.clock), hovertemplate: `%{y:.4~g} ${plain(panel.unit)}<extra>${plain(name)}</extra>`,
        ...(look && look.quiet ? { hoverinfo: "skip", hovertemplate: null } : {}) } }));
    if (panel.corridor !== null && vehicles.length > 1) {
      vehicles.forEach((one, k) => k !== followed && add(one, one.panels.find((p) => p.corridor !== null).values, MEMBERS[k % MEMBERS.length], `vehicle ${one.number}`, { width: 1.1 }));
    }
    const own = MEMBERS[followed % MEMBERS.length];
    if (panel.upper) add(vehicle, panel.upper, VERMILION, "limit", { width: 1, dash: "dash" });
    if (panel.lower) add(vehicle, panel.lower, VERMILION, "limit", { width: 1, dash: "dash" });
    if (panel.needed) add(vehicle, panel.needed, PURPLE, "the path needs", { width: 1.2 });
    if (panel.command) add(vehicle, panel.command, MUTED, "commanded", { width: 1, dash: "dot" });
    add(vehicle, panel.values, own, vehicles.length > 1 ? `vehicle ${vehicle.number}` : panel.title, { width: 1.6 });
    panels.push(panel);
  });
  return { traces, panels, label: over === "time" ? "time [s]" : `distance along the path [${unit}]`, scale };
}

/** How far a panel reaches: its values, the corridor unless the error is on its `own` scale, and limits not too far off. */
function rangeOf(panel, vehicles, own) {
  let low = Infinity, high = -Infinity;
  const reach = (values) => { for (const value of values) if (Number.isFinite(value)) { low = Math.min(low, value); high = Math.max(high, value); } };
  if (panel.corridor !== null) for (const one of vehicles) reach(one.panels.find((p) => p.corridor !== null).values);
  else for (const key of ["values", "command"]) if (panel[key]) reach(panel[key]);
  if (panel.corridor !== null) {
    const most = 1.12 * Math.max(own ? 0 : panel.corridor, Math.abs(low), Math.abs(high), 1e-6);
    return [-most, most];
  }
  const size = Math.max(Math.abs(low), Math.abs(high), 1e-9);
  for (const key of ["lower", "upper"]) if (panel[key]) reach(Array.from(panel[key]).filter((value) => Math.abs(value) < 3 * size));
  const room = 0.08 * (high - low) || Math.max(1, 0.1 * Math.abs(high));
  return [low - room, high + room];
}

/** The layout of the panels in so much `width` [px]: their axes, what they are called, and the corridor behind the error. */
function panelLayout(panels, vehicles, label, own, width) {
  const shares = panels.map((_, i) => (i === 0 ? FIRST_EXTRA : 1));
  const total = shares.reduce((a, b) => a + b, 0);
  const gap = 0.22 / total;
  const layout = layoutOf({ hovermode: "x", hoverdistance: -1, dragmode: "zoom", height: Math.round(total * PANEL_HEIGHT + 70) });
  layout.annotations = [];
  layout.shapes = [];
  let ceiling = 1;
  panels.forEach((panel, i) => {
    const floor = ceiling - shares[i] / total;
    const key = i === 0 ? "yaxis" : `yaxis${i + 1}`;
    const top = ceiling - (i === 0 ? 0 : gap);
    layout[key] = axis(plain(`[${panel.unit}]`), { domain: [Math.max(0, floor + gap / 4), top], range: rangeOf(panel, vehicles, own), nticks: 6 });
    const legend = [panel.upper && "dashed: limit", panel.command && "dotted: command", panel.needed && "purple: needed",
      panel.corridor !== null && `shaded: corridor ±${metres(panel.corridor)}; left is positive`].filter(Boolean).join(" · ");
    const two = LETTER * (panel.title.length + legend.length + 2) > width - layout.margin.l - layout.margin.r;
    if (two && i === 0) layout.margin = { ...layout.margin, t: 42 };
    layout.annotations.push({ text: `<b>${plain(panel.title)}</b>${two ? "<br>" : "  "}<span style="color:${MUTED}">${plain(legend)}</span>`, showarrow: false, xref: "paper",
      yref: "paper", x: 0, y: top, xanchor: "left", yanchor: "bottom", font: { size: 12 }, align: "left" });
    if (panel.corridor !== null) {
      layout.shapes.push({ type: "rect", xref: "paper", x0: 0, x1: 1, yref: i === 0 ? "y" : `y${i + 1}`, y0: -panel.corridor, y1: panel.corridor,
        fillcolor: CORRIDOR_FILL, line: { width: 0 }, layer: "below" });
    }
    ceiling = floor;
  });
  layout.xaxis = axis(label, { anchor: panels.length === 1 ? "y" : `y${panels.length}`, showspikes: false });
  return layout;
}
