// Many trials of a case: the band of the error along the path, and how a metric is distributed.

function bandPlot(target, spread, corridor) {
  const [scale, unit] = scaleOf(spread.length);
  const count = spread.band.bias.length;
  const x = Array.from({ length: count }, (_, i) => ((i + 0.5) * spread.length) / count / scale);
  const hidden = { line: { width: 0 }, trace: { hoverinfo: "skip" } };
  const signed = [
    line(x, spread.band.p95, BLUE, "95 %", hidden),
    line(x, spread.band.p5, BLUE, "of 90 % of the trials", { line: { width: 0 }, trace: { fill: "tonexty", fillcolor: "rgba(0,114,178,0.22)", hoverinfo: "skip" } }),
    line(x, spread.band.bias, INK, "mean of the trials", { trace: { hovertemplate: "%{y:.3~g} m<extra>mean of the trials</extra>" } }),
  ];
  const size = Math.max(...spread.band.p95.map(Math.abs), ...spread.band.p5.map(Math.abs), 1e-9);
  const most = 1.15 * Math.max(size, corridor < 3 * size ? corridor : 0);
  const layout = layoutOf({ height: 290, hovermode: "x",
    xaxis: axis(`distance along the ${spread.whose} [${unit}]`), yaxis: axis("cross-track error [m]", { range: [-most, most], nticks: 8 }),
    shapes: [corridorEdge(corridor), corridorEdge(-corridor)] });
  layout.annotations = [{ text: `<b>Error over the trials</b>  <span style="color:${MUTED}">line: mean · band: 90 % of trials · dashed: corridor</span>`,
    showarrow: false, xref: "paper", yref: "paper", x: 0, y: 1, xanchor: "left", yanchor: "bottom", align: "left" }];
  window.Plotly.newPlot(target, signed, layout, CONFIG);
}

function corridorEdge(at) {
  return { type: "line", xref: "paper", x0: 0, x1: 1, yref: "y", y0: at, y1: at, line: { color: VERMILION, width: 1, dash: "dash" } };
}

/** One metric over the trials as a histogram, its limit, and a mark at the trial that is shown. */
function distributionPlot(target, metric, shown) {
  const values = metric.values.filter((value) => value !== null);
  const unit = metric.unit ? ` [${metric.unit}]` : "";
  const shapes = metric.limit === null ? [] : [{ type: "line", xref: "x", x0: metric.limit, x1: metric.limit, yref: "paper", y0: 0, y1: 1,
    line: { color: VERMILION, width: 1.5, dash: "dash" } }];
  if (shown !== null && shown !== undefined) shapes.push({ type: "line", xref: "x", x0: shown, x1: shown, yref: "paper", y0: 0, y1: 1, line: { color: INK, width: 1.5 } });
  const trace = { type: "histogram", x: values, nbinsx: 24, marker: { color: BLUE, line: { color: "#fff", width: 1 } },
    hovertemplate: `%{y} trials, %{x} ${plain(metric.unit)}<extra></extra>` };
  const words = ["line: the trial shown above", metric.limit !== null && "dashed: limit"].filter(Boolean).join(" · ");
  const layout = layoutOf({ height: 290, bargap: 0.02, shapes, xaxis: axis(plain(metric.words + unit)), yaxis: axis("trials", { rangemode: "tozero" }) });
  layout.annotations = [{ text: `<b>Distribution over ${values.length} trials</b>  <span style="color:${MUTED}">${words}</span>`, showarrow: false, xref: "paper",
    yref: "paper", x: 0, y: 1, xanchor: "left", yanchor: "bottom", align: "left" }];
  window.Plotly.newPlot(target, [trace], layout, CONFIG);
}
