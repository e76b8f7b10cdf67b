// What it takes to get the same results again, and what they were held against.

function appendix() {
  const told = TOLD.appendix;
  const limits = (row) => row.limits.map((limit) => make("div", {}, `${limit.words} ${limit.limit}`));
  const part = (title, heads, rows) => rows.length > 0 && make("details", {}, make("summary", {}, title), table(heads, rows));
  section("appendix", "Appendix", [
    make("h3", {}, "To get the same results"), table([["what"], ["value"]], told.made),
    part("Requirements, and where they come from", [["limits"], ["source"], ["cases"]], told.requirements.map((row) => [limits(row), row.source, row.cases])),
    part("Conditions", [["conditions"], ["cases"]], told.conditions.map((row) => [row.conditions, row.cases])),
    part("Seeds", [["case"], ["trials", "number"], ["seed of the plan"], ["seeds of the trials"], ["worst trial: its seed"], ["hash"]],
      told.seeds.map((row) => [caseLink(row.case), row.trials, row.plan, row.seeds, row.worst, row.hash])),
    part("Metrics and their definitions", [["metric"], ["unit"], ["better"], ["definition"], ["source"]],
      told.metrics.map((row) => [row.words, row.unit, row.better, row.definition, row.source])),
  ]);
}
