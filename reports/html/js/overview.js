// What must be known in ten seconds: the verdict, the counts, the worst cases and how to repeat it.

const WORST_SHOWN = 5, CLOSEST_SHOWN = 3;

function asExpected() {
  const searched = (TOLD.searches || []).every((found) => found.rows.every((row) => row.passed !== false));
  return TOLD.failed === 0 && TOLD.errors === 0 && searched;
}

function banner() {
  document.title = `${TOLD.title} – trackworthy`;
  const fine = asExpected();
  const { number, words } = TOLD.front ? TOLD.front.headline : { number: `${TOLD.passed} of ${TOLD.total}`, words: "cases came out as expected" };
  const counts = TOLD.front ? TOLD.front.counts : `${TOLD.worthy} trackworthy, ${TOLD.unworthy} not trackworthy`;
  fill(byId("banner"), [
    make("div", { class: "kicker" }, "TRACKWORTHY · can a real vehicle follow the planned path?"),
    make("h1", {}, TOLD.title),
    TOLD.subtitle && make("p", { class: "muted subtitle" }, TOLD.subtitle),
    make("div", { class: `answer${fine ? "" : " bad-edge"}` }, make("div", { class: `count ${fine ? "good" : "bad"}` }, number),
      make("div", { class: "what" }, make("strong", {}, words), counts)),
  ]);
}

/** Those not as expected first, then those closest to their limits. */
function worstRows() {
  const badness = (row) => (row.passed ? 2 : row.verdict === "error" ? 0 : 1);
  const margin = (row) => (row.margin === null ? -Infinity : row.margin);
  const order = [...DATA.rows].sort((a, b) => badness(a) - badness(b) || margin(a) - margin(b));
  const failed = order.filter((row) => !row.passed);
  if (failed.length > 0) return failed.slice(0, WORST_SHOWN);
  const worthy = order.filter((row) => row.verdict === "trackworthy" && row.margin !== null);
  return (worthy.length > 0 ? worthy : order).slice(0, CLOSEST_SHOWN);
}

/** The row of that case in what is told, with its reason in words. */
function toldOf(row) {
  return TOLD.rows[row.number - 1] || (TOLD.rows || []).find((one) => one.name === row.name) || {};
}

/** What was tested, in a few lines. */
function tested() {
  const rows = (TOLD.front && TOLD.front.tested) || [];
  section("tested", "What was tested", rows.length > 0 && make("dl", { class: "facts" }, rows.map(([word, values]) => [make("dt", {}, word), make("dd", {}, values)])));
}

/** The worst cases in the words of the report's front page, those not as expected first. */
function frontGroups() {
  const groups = TOLD.front.worst.map((group) => [
    make("h3", {}, group.title),
    make("ul", { class: "worst" }, group.rows.map((row) => make("li", {}, make("b", { class: row.good ? "good" : "bad" }, `${row.mark} `),
      row.name && [caseLink(row.case, row.name), " "], row.words))),
    group.more > 0 && make("p", { class: "muted small" }, `and ${group.more} more`),
  ]);
  section("worst", "The worst, and why", groups);
}

function worstCases() {
  if (TOLD.front) {
    frontGroups();
    return;
  }
  const rows = worstRows();
  if (rows.length === 0) return;
  const failed = rows.some((row) => !row.passed);
  const items = rows.map((row) => make("li", {},
    badge(row.verdict), " ", make("a", { href: `#case-${row.number}` }, row.name),
    make("span", { class: "muted" }, ` · ${[row.vehicle, row.controller, row.speed_words].filter(Boolean).join(" · ")}`),
    make("div", {}, toldOf(row).why)));
  const left = DATA.rows.filter((row) => !row.passed).length - rows.length;
  section("worst", failed ? "What did not come out as expected" : "Closest to their limits",
    make("ul", { class: "worst" }, items),
    failed && left > 0 && make("p", { class: "muted" }, `and ${left} more, in the table of cases`));
}

function repeat() {
  const note = DATA.about.note;
  const one = TOLD.front && TOLD.front.repeat_one;
  section("repeat", "To repeat it", command(DATA.about.command), one && [make("p", { class: "muted small" }, "One trial of a case:"), command(one)], note && make("p", { class: "muted small" }, note));
}
