// What planners did, with what papers claim of them, and what searches found.

function linesCell(lines) {
  return { style: "lines", content: (lines || []).map((words, i) => make("div", { class: i ? "muted" : null }, words)) };
}

function plansSection() {
  section("plans", "Plans, and what papers claim", TOLD.plans.map((one, i) => [
    make("h3", { id: `plans-${i + 1}` }, `Plans on ${one.scenario}`), make("p", { class: "muted small" }, one.about),
    plansTable(one), one.note && make("p", { class: "small" }, one.note), pictures(one.pictures),
  ]));
}

// What a planner's row may tell: its key, its head, and how it is written; columns that are empty for all are left out.
const PLAN_COLUMNS = [
  ["found", "seeds with a path", (row) => [row.found, row.missing && make("div", { class: "bad" }, row.missing)]],
  ["length", "length [map units], median, worst", (row) => linesCell([].concat(row.length))],
  ["ratio", "over the exact, median, worst", (row) => linesCell(row.ratio)],
  ["straight", "over the straight line", (row) => linesCell([].concat(row.straight))],
  ["longest", "longest path [map units], median, worst", (row) => linesCell([].concat(row.longest))],
  ["corner", "largest turn at a vertex", (row) => row.corner],
  ["turn", "largest turn every 5 units and 1, worst", (row) => linesCell([].concat(row.turn))],
  ["radius", "smallest radius, worst", (row) => linesCell(row.radius)],
  ["survivors", "arriving at the end, median", (row) => row.survivors],
  ["converged", "iterations to 1 % of the best", (row) => row.converged],
  ["needs", "needs at its speed [g], worst", (row) => row.needs && [make("span", { class: row.needs.over ? "bad" : null }, row.needs.g), row.needs.at && make("div", { class: "muted" }, row.needs.at)]],
  ["driven", "trackworthy trials", (row) => (row.driven || []).map((by) => make("div", {}, by.vehicle && `${by.vehicle} `,
    make("b", { class: by.all ? "good" : "bad" }, by.share), by.why && make("div", { class: "muted small" }, by.why)))],
];

function says(value) {
  if (Array.isArray(value)) return value.some(says);
  return value !== null && typeof value === "object" ? Boolean(value.g) : Boolean(value);
}

function plansTable(one) {
  const columns = PLAN_COLUMNS.filter(([key]) => one.rows.some((row) => says(row[key]) || (row.claims || []).some((claim) => says(claim[key]))));
  const rows = one.rows.flatMap((row) => [
    { cells: [[make("b", {}, row.name), row.about && make("div", { class: "muted small" }, row.about), row.stages && make("div", { class: "muted small" }, row.stages)],
      ...columns.map(([, , cell]) => cell(row))] },
    ...(row.claims || []).map((claim) => ({ style: "claim", cells: [`claimed: ${claim.source}`, ...columns.map(([key, , cell]) => (key in claim ? cell(claim) : ""))] })),
  ]);
  return table([["planner"], ...columns.map(([, words]) => [words, "number"])], rows);
}

function searchesSection() {
  const parts = TOLD.searches.map((found) => [
    make("h3", {}, found.title),
    table(found.head.map((words, i) => [words, i === 2 || i === 3 ? "number" : ""]), found.rows.map((row) => [
      make("b", {}, row.name), [row.path, make("div", { class: "muted" }, `${row.vehicle} · ${row.controller}`)],
      [make("b", { class: row.passed === false ? "bad" : null }, row.found), row.expected && make("div", { class: row.passed ? "muted small" : "bad small" }, row.expected)],
      row.beside, row.missed,
    ])),
  ]);
  section("searches", "Searches", parts);
}
