// What must be known in ten seconds: the verdict, the counts, the worst cases and how to repeat it.

function banner() {
  document.title = `${TOLD.title} – trackworthy`;
  const { headline, counts, good } = TOLD.front;
  fill(byId("banner"), [
    make("div", { class: "kicker" }, "TRACKWORTHY · can a real vehicle follow the planned path?"),
    make("h1", {}, TOLD.title),
    TOLD.subtitle && make("p", { class: "muted subtitle" }, TOLD.subtitle),
    make("div", { class: `answer${good ? "" : " bad-edge"}` }, make("div", { class: `count ${good ? "good" : "bad"}` }, headline.number),
      make("div", { class: "what" }, make("strong", {}, headline.words), counts)),
  ]);
}

/** What was tested, in a few lines. */
function tested() {
  const rows = TOLD.front.tested;
  section("tested", "What was tested", rows.length > 0 && make("dl", { class: "facts" }, rows.map(([word, values]) => [make("dt", {}, word), make("dd", {}, values)])),
    TOLD.front.legend && make("p", { class: "muted small" }, TOLD.front.legend));
}

/** The worst cases in the words of the report's front page, those not as expected first. */
function worstCases() {
  section("worst", "The worst, and why", TOLD.front.worst.map((group) => [
    make("h3", {}, group.title),
    make("ul", { class: "worst" }, group.rows.map((row) => make("li", {}, make("b", { class: row.good ? "good" : "bad" }, `${row.mark} `),
      row.name && [caseLink(row.case, row.name), " "], row.words))),
    group.more > 0 && make("p", { class: "muted small" }, `and ${group.more} more`),
  ]));
}

function repeat() {
  const { repeat: all, repeat_one: one } = TOLD.front;
  const note = DATA.about.note;
  section("repeat", "To repeat it", all && command(all), one && [make("p", { class: "muted small" }, "One trial of a case:"), command(one)],
    note && make("p", { class: "muted small" }, note));
}
