// What became of a baseline: worse, changed and better.

function checkSection() {
  const told = TOLD.check;
  if (!told) return;
  const values = (row) => [caseLink(row.case), row.metric, row.old, row.new, row.by];
  const heads = [["case"], ["metric"], ["was", "number"], ["is", "number"], ["by", "number"]];
  const more = (rows, count) => count > rows.length && make("p", { class: "muted small" }, `and ${count - rows.length} more`);
  section("check", "Against the baseline", make("p", { class: told.good ? "good" : "bad" }, make("b", {}, told.conclusion)),
    told.worse.length > 0 && [make("h3", {}, "Worse"), table([...heads, ["allowed", "number"], ["trial", "number"]],
      told.worse.map((row) => [...values(row), row.allowed, row.trial])), more(told.worse, told.worse_count)],
    told.changed.length > 0 && [make("h3", {}, "Changed"), table([["case"], ["what"]], told.changed.map((row) => [caseLink(row.case), row.what])),
      more(told.changed, told.changed_count)],
    told.better.length > 0 && [make("h3", {}, "Better"), table(heads, told.better.map(values)), more(told.better, told.better_count)]);
}
