// The table of all cases, sorted by any column and filtered by text and by kind.

const COLUMNS = [
  { key: "number", head: "no.", number: true },
  { key: "name", head: "case" },
  { key: "path", head: "planner or path" },
  { key: "vehicle", head: "vehicle" },
  { key: "controller", head: "controller" },
  { key: "speed", head: "speed", number: true, words: "speed_words" },
  { key: "verdict", head: "verdict" },
  { key: "share", head: "trackworthy", number: true, words: "share_words" },
  { key: "decided", head: "decided by" },
  { key: "rank", head: "margin", number: true, words: "margin_words",
    title: "By the share of the limit that is left; where the limit is 0 m, by that of the corridor" },
  { key: "p95", head: "error, 95 %", number: true, words: "p95_words" },
];
const FILTERS = [["vehicle", "vehicle"], ["controller", "controller"], ["scenario", "scenario"]];
const EXPECTED = { "as-expected": "as expected", "against": "not as expected" };
const sorting = { key: "number", rising: true };
const wanted = { text: "", verdict: "", vehicle: "", controller: "", scenario: "" };

function casesTable() {
  if (DATA.rows.length === 0) return;
  const body = make("tbody", {});
  const head = make("tr", {}, COLUMNS.map((column) => make("th", { scope: "col", class: column.number ? "number" : null,
    "data-key": column.key }, make("button", { type: "button", title: column.title, onclick: () => sortBy(column.key) }, column.head))));
  const count = make("p", { class: "muted small", id: "case-count", "aria-live": "polite" });
  section("cases", "All cases", filters(), count,
    make("div", { class: "scroll" }, make("table", { id: "case-rows" }, make("thead", {}, head), body)));
  showRows();
}

function filters() {
  const change = (key) => (event) => { wanted[key] = event.target.value; showRows(); };
  const search = make("input", { type: "search", id: "filter-text", placeholder: "name, path, metric …", oninput: change("text") });
  const verdicts = [...new Set(DATA.rows.map((row) => row.verdict))].map((verdict) => [verdict, verdict.replace("-", " ")]);
  const option = ([value, words]) => make("option", { value }, words);
  const select = (key, words, options) => make("label", {}, words,
    make("select", { id: `filter-${key}`, onchange: change(key) }, option(["", "all"]), options.map(option)));
  const kinds = FILTERS.map(([key, words]) => {
    const values = [...new Set(DATA.rows.map((row) => row[key]))].filter(Boolean).sort();
    return values.length > 1 && select(key, words, values.map((value) => [value, value]));
  });
  return make("div", { class: "filters" }, make("label", {}, "find", search),
    select("verdict", "verdict", [...verdicts, ...Object.entries(EXPECTED)]), kinds);
}

function sortBy(key) {
  sorting.rising = sorting.key === key ? !sorting.rising : true;
  sorting.key = key;
  showRows();
}

/** The rows that are wanted, in their order; what has no value stands last either way. */
function shownRows() {
  const text = wanted.text.toLowerCase();
  const fits = (row) => {
    const told = COLUMNS.map((column) => row[column.words || column.key]).concat(row.scenario).join(" ").toLowerCase();
    const verdict = { "as-expected": row.passed, against: !row.passed }[wanted.verdict];
    return told.includes(text) && (verdict === undefined ? !wanted.verdict || row.verdict === wanted.verdict : verdict)
      && FILTERS.every(([key]) => !wanted[key] || row[key] === wanted[key]);
  };
  const compare = (a, b) => {
    const [x, y] = [a[sorting.key], b[sorting.key]];
    if (x === null || y === null) return (x === null) - (y === null);
    const order = typeof x === "string" ? x.localeCompare(y, "en", { numeric: true }) : x - y;
    return sorting.rising ? order : -order;
  };
  return DATA.rows.filter(fits).sort(compare);
}

function showRows() {
  const rows = shownRows();
  const body = document.querySelector("#case-rows tbody");
  body.replaceChildren(...rows.map(caseRow));
  byId("case-count").textContent = `${rows.length} of ${DATA.rows.length} ${DATA.rows.length === 1 ? "case" : "cases"}`;
  for (const head of document.querySelectorAll("#case-rows th")) {
    const own = head.dataset.key === sorting.key;
    head.setAttribute("aria-sort", own ? (sorting.rising ? "ascending" : "descending") : "none");
    const words = COLUMNS.find((column) => column.key === head.dataset.key).head;
    head.firstChild.textContent = own ? `${words} ${sorting.rising ? "▲" : "▼"}` : words;
  }
}

function caseRow(row) {
  const cell = (column) => {
    const words = row[column.words || column.key];
    if (column.key === "name") return make("a", { href: `#case-${row.number}` }, row.name);
    if (column.key === "path") return [words, row.scenario && make("div", { class: "muted small" }, row.scenario)];
    if (column.key === "speed") return words.split(" (").map((part, i) => make("div", { class: i ? "muted" : null }, part.replace(")", "")));
    if (column.key === "rank") return [make(row.missed ? "b" : "span", { class: row.missed ? "bad" : null }, words), make("div", { class: "muted" }, row.margin_share)];
    if (column.key !== "verdict") return words;
    const expected = row.expect === "either" ? "to be compared" : row.passed ? "as expected" : "not as expected";
    return [badge(row.verdict), make("div", { class: `small ${row.passed ? "muted" : "bad"}` }, expected)];
  };
  const cells = COLUMNS.map((column) => make("td", { class: column.number ? "number" : null }, cell(column)));
  const open = (event) => { if (!event.target.closest("a")) location.hash = `#case-${row.number}`; };
  return make("tr", { "data-case": row.number, onclick: open }, cells);
}
