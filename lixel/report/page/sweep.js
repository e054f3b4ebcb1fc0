// A study of one's own: how error and cost go with what it varies.

const kMostRowsShown = 2000;
const facts = run.sweep;
const shapes = new Map(); // how a technique's line looks
const drawn = measured.filter(row => row.lixels !== "" || isNumber(row.timing.frame_ms)); // not exact visibility

// What rows can be chosen by, where the study has several.
const choices = [["Scene", "scene"], ["View", "view"], ["Time", "time_seconds"], ["Lights", "lights"],
  ["Picture", "size"], ["Lixels", "lixels"]].filter(([, key]) => differ(run.results.filter(row => key !== "lixels" || row.lixels), key));

const pixelsOf = row => row.size.split("x").map(Number).reduce((w, h) => w * h);

// x: what the value is drawn over; along: the members that change along a line. All others stay as they are.
const plots = [
  {title: "Error against lixels", x: "lixels_used", y: "misclassified_percent", along: ["lixels"], unit: "lixels a light",
    ticks: squareTicks, isError: true, needs: ["lixels"]},
  {title: "Error against cost", x: "frame_ms", y: "misclassified_percent", along: ["lixels"], unit: "ms a frame", isError: true, needs: []},
  {title: "Cost by lixels", x: "lixels_used", y: "frame_ms", along: ["lixels"], unit: "lixels a light", ticks: squareTicks, needs: ["lixels"]},
  {title: "Error by pixels", x: "pixels", y: "misclassified_percent", along: ["size"], unit: "pixels of the picture",
    ticks: squareTicks, isError: true, needs: ["size"]},
  {title: "Cost by pixels", x: "pixels", y: "frame_ms", along: ["size"], unit: "pixels of the picture", ticks: squareTicks, needs: ["size"]},
  {title: "Error by triangles", x: "triangles", y: "misclassified_percent", along: ["scene", "view", "light"],
    unit: "triangles of the scene", isError: true, needs: ["scene"]},
  {title: "Cost by triangles", x: "triangles", y: "frame_ms", along: ["scene", "view", "light"], unit: "triangles of the scene", needs: ["scene"]},
  {title: "Cost by lights", x: "light_count", y: "frame_ms", along: ["lights", "light"], unit: "lights of the picture", needs: ["light_count"]},
];
const kKeys = ["scene", "view", "time_seconds", "lights", "light", "size", "lixels"];

const valueOf = (row, name) => name === "pixels" ? pixelsOf(row) : name === "frame_ms" ? row.timing.frame_ms : row[name];

function chosenRows() {
  const wanted = choices.map(([, key]) => [key, byId(`choose-${key}`).value]).filter(([, value]) => value !== "");
  return drawn.filter(row => wanted.every(([key, value]) =>
    String(row[key]) === value || (key === "lixels" && row.lixels === "")));
}

// Lines of one plot, a technique each. Means are over the places that all techniques have at every step, where there are any:
// only then can they be held against each other.
function linesOf(plot, rows) {
  const usable = rows.filter(row => isNumber(valueOf(row, plot.x)) && isNumber(valueOf(row, plot.y)));
  const budgeted = usable.filter(row => row.lixels !== "");
  const stepOf = row => plot.along.includes("lixels") ? row.lixels : String(valueOf(row, plot.x));
  const placeOf = (row, ...without) => JSON.stringify(
    kKeys.filter(key => !plot.along.includes(key) && !without.includes(key)).map(key => row[key]));
  const steps = new Set(budgeted.map(stepOf)), techniques = new Set(budgeted.map(row => row.technique_full));
  const met = groupBy(budgeted, row => placeOf(row));
  const isWhole = rows => new Set(rows.map(row => stepOf(row) + row.technique_full)).size === steps.size * techniques.size;
  const whole = [...met.values()].filter(isWhole).flat();
  // What has no map belongs to every budget, and to no growth with lixels.
  const pictures = new Set(whole.map(row => placeOf(row, "lixels")));
  const unbudgeted = plot.along.includes("lixels") ? []
    : usable.filter(row => row.lixels === "" && (!whole.length || pictures.has(placeOf(row, "lixels"))));
  const compared = [...(whole.length ? whole : budgeted), ...unbudgeted];
  const leftOut = whole.length ? met.size - new Set(whole.map(row => placeOf(row))).size : 0;
  const lines = [...groupBy(compared, row => row.technique)].map(([technique, rows]) => ({
    label: technique, ...shapes.get(technique), points: [...groupBy(rows, stepOf).values()].map(rows => {
      const x = mean(rows.map(row => valueOf(row, plot.x))), y = mean(rows.map(row => valueOf(row, plot.y)));
      const value = plot.isError ? `${percentText(y)} %` : `${numberText(y)} ms`;
      return {x, y, title: `${technique}, ${numberText(x)} ${plot.unit}: ${value}`};
    }).filter(point => point.x > 0).sort((a, b) => a.x - b.x),
  }));
  return {lines, leftOut, isWhole: whole.length > 0};
}

function showPlots() {
  const rows = chosenRows();
  const isThere = plot => plot.needs.every(key => differ(rows, key))
    && rows.some(row => isNumber(valueOf(row, plot.x)) && isNumber(valueOf(row, plot.y)));
  byId("plots").replaceChildren(...plots.filter(isThere).map(plot => {
    const {lines, leftOut, isWhole} = linesOf(plot, rows);
    const figure = logPlot(`${plot.title}${plot.isError ? ", misclassified %" : ", ms a frame"}`, lines,
      {xTicks: plot.ticks, xLabel: plot.unit});
    const note = !isWhole ? "Means over different pictures: no picture has all techniques at every step."
      : leftOut ? `Without ${leftOut} picture${leftOut > 1 ? "s" : ""} or lights that some technique refused.` : "";
    if (note) figure.append(element("p", {class: "note"}, note));
    return figure;
  }));
  byId("no-plots").hidden = byId("plots").childElementCount > 0;
}

function showChoices() {
  byId("choices").append(...choices.map(([label, key]) => {
    const select = element("select", {id: `choose-${key}`, onchange: showPlots});
    const values = [...new Set(run.results.map(row => row[key]))].filter(value => value !== "");
    select.append(new Option(`all ${values.length}`, ""), ...values.map(value => new Option(String(value), String(value))));
    return element("span", {class: "field"}, element("label", {for: `choose-${key}`}, label), select);
  }));
  byId("choices").hidden = !choices.length;
}

function showSweepRows() {
  const more = [["Time", "time_seconds", numberText], ["Lights", "lights"], ["Light count", "light_count", countText],
    ["Triangles", "triangles", countText]].filter(([, key]) => differ(run.results, key));
  byId("rows-note").textContent += measured.length > kMostRowsShown
    ? ` The first ${kMostRowsShown} of ${measured.length}; all are in results.csv.` : "";
  byId("rows-table").replaceChildren(sortableTable("All rows", [
    column("View", groupName), ...techniqueColumns(), ...more.map(([label, key, text]) => column(label, key, text)),
    ...errorColumns, column("Unserved", "unserved", countText, "samples that no map covers"), ...costColumns,
    column("Frame ms", row => row.timing.frame_ms, numberText), column("By", row => row.timing.host),
  ], measured.slice(0, kMostRowsShown), true));
  byId("refused").hidden = !refused.length;
  byId("refused-table").replaceChildren(sortableTable("Refused", [
    column("View", groupName), ...techniqueColumns(), column("Reason", row => row.refused.reason),
    {...column("Message", row => row.refused.message), className: "message"},
  ], refused.slice(0, kMostRowsShown)));
}

showHead();
byId("sweep-title").textContent = facts.name;
byId("sweep-question").textContent = facts.question;
[...new Set(drawn.map(row => row.technique))].forEach((technique, index) => shapes.set(technique, lineLook(index)));
byId("keys").append(...[...shapes].map(([technique, look]) => lineKey(technique, look)));
showChoices();
showPlots();
byId("summary-table").replaceChildren(sortableTable("Means by technique", summaryColumns(severalScenes), summary, true));
showSweepRows();
document.title = `lixel: ${facts.name}`;
