// The cases at a glance, coloured by how far they are from their limits: blue keeps them, vermilion misses them.

const MARK = { trackworthy: "✓ ", "not-trackworthy": "✗ ", error: "! " };

function caseLink(named, words) {
  const row = DATA.rows.find((one) => one.name === named);
  return row ? make("a", { href: `#case-${row.number}` }, words === undefined ? named : words) : words || named;
}

function matrix() {
  const told = TOLD.matrix;
  if (told.rows.length === 0) return;
  const same = told.same.length > 0 ? ` The same in all cases: ${told.same.join(", ")}.` : "";
  section("matrix", "All cases at a glance", bands(told).map((rows) => matrixTable(told, rows)), make("p", { class: "muted small" },
    `A cell tells by how much of its limit the requirement that decides is kept (blue, ✓) or missed (vermilion, ✗).${same}`));
}

/** The rows in groups that have columns in common, so that no table is mostly empty. */
function bands(told) {
  let found = [];
  told.rows.forEach((_, i) => {
    const columns = new Set(told.columns.map((__, k) => k).filter((k) => told.cells[i][k]));
    const joined = found.filter((band) => [...columns].some((k) => band.columns.has(k)));
    const merged = { rows: [...joined.flatMap((band) => band.rows), i], columns: new Set([...joined.flatMap((band) => [...band.columns]), ...columns]) };
    found = [...found.filter((band) => !joined.includes(band)), merged];
  });
  return found.map((band) => band.rows.sort((a, b) => a - b)).sort((a, b) => a[0] - b[0]);
}

function matrixTable(told, shown) {
  const used = told.columns.map((_, k) => k).filter((k) => shown.some((i) => told.cells[i][k]));
  const columns = used.map((k) => told.columns[k]);
  const heads = (told.across.length > 0 ? told.across : [""]).map((dimension, level) => make("tr", {},
    told.down.map((words) => make("th", { scope: "col" }, level === levels(told) - 1 ? words : "")),
    spans(columns, level).map(([words, count]) => make("th", { scope: "col", colspan: count, class: "across" },
      dimension ? words : "margin of the requirement that decides"))));
  const rows = shown.map((i, at) => make("tr", {},
    told.rows[i].map((words, k) => make("th", { scope: "row", class: "down" },
      at > 0 && sameUpTo(told.rows[shown[at - 1]], told.rows[i], k) ? "" : words)),
    used.map((k) => matrixCell(told.cells[i][k]))));
  return make("div", { class: "scroll" }, make("table", { class: "matrix" }, make("thead", {}, heads), make("tbody", {}, rows)));
}

function levels(told) {
  return Math.max(1, told.across.length);
}

function sameUpTo(before, row, k) {
  return row.slice(0, k + 1).every((words, i) => words === before[i]);
}

/** The values of one dimension of the columns, each with how many columns that follow each other it spans. */
function spans(columns, level) {
  const found = [];
  columns.forEach((column, i) => {
    const last = found[found.length - 1];
    if (last && sameUpTo(columns[i - 1], column, level)) last[1] += 1;
    else found.push([column[level] === undefined ? "" : column[level], 1]);
  });
  return found;
}

function matrixCell(cell) {
  if (!cell) return make("td", {});
  const words = [`${MARK[cell.verdict] || ""}${cell.margin}`, cell.share && make("div", { class: "small" }, cell.share),
    cell.count > 1 && make("div", { class: "small" }, `worst of ${cell.count}`), !cell.passed && make("div", { class: "small" }, "not as expected")];
  const element = make("td", { title: `${cell.case}: ${cell.metric}` }, caseLink(cell.case, words));
  element.style.background = cell.fill;
  element.style.color = cell.ink;
  return element;
}
