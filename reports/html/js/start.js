// The plotting library is unpacked while the words are read; then the page follows its address.

let library = null;

async function unpackLibrary() {
  if (typeof DecompressionStream === "undefined") {
    throw new Error("this browser cannot unpack what the report carries (DecompressionStream); use one of 2023 or later");
  }
  const packed = Uint8Array.from(atob(byId("plotly-packed").textContent), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const code = await new Response(stream).text();
  const script = document.createElement("script");
  script.nonce = document.querySelector("script[nonce]").nonce;
  script.textContent = code;
  document.head.append(script);
  if (!window.Plotly) throw new Error("the plotting library did not start");
}

/** Do `what` once there is the plotting library; say so where there is none. */
async function withPlotly(what) {
  try {
    library = library || unpackLibrary();
    await library;
    await what();
  } catch (error) {
    trouble(`The plots cannot be drawn: ${error.message}`);
  }
}

/** Show what the address asks for: a case, or all of them. */
function route() {
  const match = /^#case-(\d+)$/.exec(location.hash);
  const row = match && DATA.rows.find((one) => one.number === Number(match[1]));
  byId("one-case").hidden = !row;
  byId("overview").hidden = Boolean(row);
  document.body.classList.toggle("in-case", Boolean(row));
  if (row) {
    caseView(row);
    window.scrollTo(0, 0);
    byId("case-name").focus({ preventScroll: true });
    return;
  }
  leaveCase();
  byId("one-case").replaceChildren();
  const wanted = location.hash.length > 1 && document.getElementById(location.hash.slice(1));
  if (wanted) wanted.scrollIntoView();
}

banner();
tested();
worstCases();
repeat();
matrix();
casesTable();
scenariosSection();
plansSection();
searchesSection();
checkSection();
appendix();
byId("foot").textContent = `trackworthy ${DATA.about.version} · all of this page is in this file; it asks no network.`;
window.addEventListener("hashchange", route);
route();
withPlotly(() => {});
