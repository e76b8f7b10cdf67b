// What it takes to get the same results again, and where the limits come from.

function appendix() {
  const about = DATA.about;
  const facts = [
    ["campaign", about.name], ["command", about.command], ["seed", about.seed], ["trials", about.trials],
    ["git revision", about.revision || "none"], ["platform", about.platform], ["schema of the metrics", about.schema],
    ["hash of the campaign", about.hash], ...Object.entries(about.versions),
  ];
  if (TOLD.appendix) {
    wholeAppendix(TOLD.appendix);
    return;
  }
  const requirements = DATA.requirements.map((row) => [row.words, row.limit, row.source, row.cases]);
  section("appendix", "Appendix",
    make("div", { class: "columns" },
      make("div", {}, make("h3", {}, "To get the same results"), table([["what"], ["value"]], facts)),
      requirements.length > 0 && make("div", {}, make("h3", {}, "Requirements, and where they come from"),
        table([["metric"], ["limit", "number"], ["source"], ["cases", "number"]], requirements))));
}

/** The appendix as the PDF has it. */
function wholeAppendix(told) {
  const limits = (row) => row.limits.map((limit) => make("div", {}, `${limit.words} ${limit.limit}`));
  const part = (title, heads, rows) => rows.length > 0 && make("details", {}, make("summary", {}, title), table(heads, rows));
  section("appendix", "Appendix", [
    make("h3", {}, "To get the same results"), table([["what"], ["value"]], told.made),
    part("Requirements, and where they come from", [["limits"], ["source"], ["cases"]], told.requirements.map((row) => [limits(row), row.source, row.cases])),
    part("Conditions", [["conditions"], ["cases"]], told.conditions.map((row) => [row.conditions, row.cases])),
    part("Seeds", [["case"], ["trials", "number"], ["seed of the plan"], ["seeds of the trials"], ["worst trial: its seed"], ["hash"]],
      told.seeds.map((row) => [row.case, row.trials, row.plan, row.seeds, row.worst, row.hash])),
    part("Metrics and their definitions", [["metric"], ["unit"], ["better"], ["definition"], ["source"]],
      told.metrics.map((row) => [row.words, row.unit, row.better, row.definition, row.source])),
  ]);
}
