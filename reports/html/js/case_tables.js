// The tables of one case: requirements, what the plan asks too much, trials, other metrics, notes.

function metricWords(row) {
  const mark = row.met === true ? make("span", { class: "good" }, "✓ ") : row.met === false ? make("b", { class: "bad" }, "✗ ") : "";
  return [mark, row.words];
}

function requirementsTable(told) {
  if (!told.requirements || told.requirements.length === 0) return null;
  const rows = told.requirements.map((row) => [
    metricWords(row), row.value, row.limit, make("b", { class: row.met ? "good" : "bad" }, row.margin),
    row.value === "n/a" ? row.note : row.at || row.when,
  ]);
  const heads = [["metric"], ["value", "number"], ["limit", "number"], ["margin", "number"], ["worst at", "number"]];
  return make("div", {}, make("h3", {}, "Requirements"), table(heads, rows));
}

function tightTable(told) {
  if (!told.tight || told.tight.length === 0) return null;
  const rows = told.tight.map((turn) => [turn.where, turn.turn, turn.required, turn.available, make("b", { class: "bad" }, turn.missing)]);
  const heads = [["where"], ["turn", "number"], ["needs radius", "number"], ["offers", "number"], ["missing", "number"]];
  const left = told.tight_count - told.tight.length;
  return make("div", {}, make("h3", {}, `Turns too tight for the vehicle: ${told.tight_count}`), table(heads, rows),
    left > 0 && make("p", { class: "muted small" }, `and ${left} more, less tight`));
}

function steepTable(told) {
  if (!told.steep || told.steep.length === 0) return null;
  const rows = told.steep.map((leg) => [leg.where, leg.gradient, leg.limit, make("b", { class: "bad" }, leg.missing)]);
  const heads = [["where"], ["gradient", "number"], ["limit", "number"], ["missing", "number"]];
  return make("div", {}, make("h3", {}, `Legs too steep for the vehicle: ${told.steep_count}`), table(heads, rows));
}

function membersTable(told) {
  if (!told.members || told.members.length === 0) return null;
  const tanks = told.members.some((row) => row.fuel !== "");
  const heads = [["vehicle"], ["path", "number"], ["leaves at", "number"], ["error, 95 %", "number"], ["error, max", "number"],
    ["clearance", "number"], ...(tanks ? [["fuel used", "number"], ["its range", "number"]] : []), ["alone"]];
  const rows = told.members.map((row) => [
    row.name, row.length, row.departure, row.p95, row.largest, row.clearance, ...(tanks ? [row.fuel, row.fuel_range] : []),
    [make("span", { class: row.trackworthy ? "good" : "bad" }, row.trackworthy ? "✓ " : "✗ "), row.why],
  ]);
  return make("div", {}, make("h3", {}, "The fleet"), table(heads, rows));
}

function trialsTable(told) {
  const trials = told.trials;
  if (!trials) return null;
  const rows = trials.metrics.map((row) => [
    metricWords(row), row.limit, row.median, row.p95, row.worst, row.trial,
    make("b", { class: row.met === false ? "bad" : "good" }, row.kept),
  ]);
  const heads = [["metric"], ["limit", "number"], ["median", "number"], ["95 % of trials", "number"], ["worst", "number"],
    ["in trial", "number"], ["met by", "number"]];
  return make("div", {}, make("h3", {}, "Over the trials"), make("p", {}, trials.reason),
    make("p", { class: "muted" }, [trials.headline, trials.spread].filter(Boolean).join("; ")), table(heads, rows),
    trials.conditions.length > 0 && [make("h3", {}, "Conditions of the trials"), make("p", {}, trials.conditions.join(" · ")),
      make("p", { class: "muted small" }, "Of a range every value is as likely; ± is a standard deviation.")]);
}

function metricsTable(told) {
  if (!told.metrics || told.metrics.length === 0) return null;
  const rows = told.metrics.map((row) => [row.words, row.value, row.at || row.when]);
  const heads = [["metric"], ["value", "number"], ["at", "number"]];
  const half = Math.ceil(rows.length / 2);
  const lines = (told.unmeasured || []).map((line) => make("p", { class: "muted small" }, `Not measured: ${line}`));
  return make("details", {}, make("summary", {}, `Other metrics: ${rows.length}`),
    make("div", { class: "columns" }, table(heads, rows.slice(0, half)), table(heads, rows.slice(half))), lines);
}

function notes(told) {
  if (!told.notes || told.notes.length === 0) return null;
  const left = told.notes_count - told.notes.length;
  return make("div", {}, make("h3", {}, told.notes_about ? `Notes on ${told.notes_about}` : "Notes"),
    make("ul", { class: "small" }, told.notes.map((note) => make("li", {}, note))),
    left > 0 && make("p", { class: "muted small" }, `and ${left} more`));
}
