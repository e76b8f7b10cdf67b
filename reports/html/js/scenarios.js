// Each map: its figures, what is missed on it, the worst first, and who does better than whom.

function scenariosSection() {
  section("scenarios", "Map by map", TOLD.scenarios.map((one) => [
    make("h3", {}, one.name), make("p", { class: "muted small" }, one.about),
    violationsTable(one), pictures(one.figures), (one.versus || []).map(versusTable),
  ]));
}

function violationsTable(one) {
  if (one.violations.length === 0) return null;
  const rows = one.violations.map((row) => [caseLink(row.case), row.words, row.value, row.limit, make("b", { class: "bad" }, row.by), row.at, row.trials, row.note]);
  const heads = [["case"], ["missed"], ["value", "number"], ["limit", "number"], ["by", "number"], ["at"], ["trials", "number"], ["note"]];
  const told = heads.map((_, i) => rows.some((row) => row[i] !== ""));
  const left = one.violations_count - one.violations.length;
  return [table(heads.filter((_, i) => told[i]), rows.map((row) => row.filter((_, i) => told[i]))),
    left > 0 && make("p", { class: "muted small" }, `and ${left} more`)];
}

/** Cases that differ in one thing, side by side: value and spread, below it the difference to the best. */
function versusTable(told) {
  return [make("h4", {}, told.title, " ", make("span", { class: "muted small" }, told.about)),
    told.blocks.map((part) => {
      // The share of trackworthy trials is told with its count, in its own column or among the metrics.
      const shared = part.metrics.indexOf("trackworthy");
      const cells = (row) => row.cells.map((cell, i) => versusCell(i === shared ? { ...cell, value: row.share } : cell));
      return table([[part.name], ...(shared < 0 ? ["trackworthy"] : []).concat(part.metrics).map((words) => [words, "number"])],
        part.rows.map((row) => [[caseLink(row.case, row.name), row.reference && make("div", { class: "muted small whole" }, row.reference)],
          ...(shared < 0 ? [row.share] : []), ...cells(row)]));
    }),
    told.note && make("p", { class: "muted small" }, told.note), pictures(told.figures)];
}

function versusCell(cell) {
  const style = { better: "good", worse: "bad" }[cell.outcome] || "muted";
  return [make("b", {}, cell.value), cell.spread && make("div", { class: "muted" }, cell.spread),
    (cell.change || cell.outcome) && make("div", { class: style }, [cell.change, cell.outcome].filter(Boolean).join(" "))];
}

/** Figures, to be opened; those that found no room are counted. */
function pictures(figures) {
  const shown = figures.filter((one) => one.source);
  const left = figures.length - shown.length;
  return [
    shown.length > 0 && make("details", {}, make("summary", {}, shown.length === 1 ? "Figure" : `${shown.length} figures`),
      make("div", { class: "plan-pictures" }, shown.map((one) => make("figure", {},
        make("img", { src: one.source, alt: one.caption || "figure", loading: "lazy" }), make("figcaption", {}, one.caption))))),
    left > 0 && make("p", { class: "muted small" }, `${left === 1 ? "A figure lies" : `${left} figures lie`} in the folder figures.`),
  ];
}
