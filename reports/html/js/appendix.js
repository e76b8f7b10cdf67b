// What it takes to get the same results again, and where the limits come from.

function appendix() {
  const about = DATA.about;
  const facts = [
    ["campaign", about.name], ["command", about.command], ["seed", about.seed], ["trials", about.trials],
    ["git revision", about.revision || "none"], ["platform", about.platform], ["schema of the metrics", about.schema],
    ["hash of the campaign", about.hash], ...Object.entries(about.versions),
  ];
  const requirements = DATA.requirements.map((row) => [row.words, row.limit, row.source, row.cases]);
  section("appendix", "Appendix",
    make("div", { class: "columns" },
      make("div", {}, make("h3", {}, "To get the same results"), table([["what"], ["value"]], facts)),
      requirements.length > 0 && make("div", {}, make("h3", {}, "Requirements, and where they come from"),
        table([["metric"], ["limit", "number"], ["source"], ["cases", "number"]], requirements))));
}
