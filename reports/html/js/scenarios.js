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

function versusTable(told) {
  return [told.title && make("h3", {}, told.title),
    told.head && table(told.head.map((words, i) => [words, i > 0 ? "number" : ""]), told.rows),
    told.note && make("p", { class: "muted small" }, told.note), pictures([...(told.figures || []), ...(told.file ? [told] : [])])];
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
