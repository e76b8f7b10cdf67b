// What is missed on each map, the worst first.

function scenariosSection() {
  const parts = (TOLD.scenarios || []).filter((one) => one.violations.length > 0).map((one) => {
    const rows = one.violations.map((row) => [caseLink(row.case), row.words, row.value, row.limit, make("b", { class: "bad" }, row.by), row.at, row.trials, row.note]);
    const left = one.violations_count - one.violations.length;
    return [make("h3", {}, one.name), make("p", { class: "muted small" }, one.about),
      table([["case"], ["requirement"], ["value", "number"], ["limit", "number"], ["missed by", "number"], ["at"], ["trials", "number"], ["note"]], rows),
      left > 0 && make("p", { class: "muted small" }, `and ${left} more`)];
  });
  section("missed", "What is missed, and where", parts);
}
