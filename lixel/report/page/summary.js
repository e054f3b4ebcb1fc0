// Means over the views of the page.

function showHead() {
  const valuesOf = key => [...new Set(run.results.map(row => row[key]))].filter(value => value !== "").join(", ");
  showFacts({
    Scene: valuesOf("scene"), Picture: valuesOf("size"), "Lixels a light": valuesOf("lixels"),
    Executor: valuesOf("executor"), Seed: run.seed, lixel: run.lixel_version, Made: run.timing.date,
    On: run.timing.host,
  });
  document.title = `lixel: ${valuesOf("scene")}`;
}

const kLayers = [["False shadow", "false_shadow"], ["False lit", "false_lit"]];

function showSummary() {
  const several = differ(summary, "scene");
  const label = row => (several ? `${row.scene} · ` : "") + nameOf(row);
  const counts = groups.length > 1 ? `Means over ${groups.length} views and lights. ` : "";
  byId("summary-note").textContent = counts + "Error is the share of light-facing view samples that are misclassified."
    + (run.timing.host ? " Times are of this machine; compare them with each other only." : "");
  const compared = summary.filter(row => row.technique !== "exact"); // whose error is 0 by definition
  const errors = compared.map(row => ({label: label(row), text: percentText(row.misclassified_percent) + " %",
    parts: kLayers.map(([, key]) => ({value: row[key + "_percent"] ?? 0, colour: colours[key]}))}));
  const costs = compared.filter(row => isNumber(row.frame_ms))
    .map(row => ({label: label(row), text: numberText(row.frame_ms) + " ms",
      parts: [{value: row.frame_ms, className: "cost"}]}));
  const isCharted = !run.study?.lookups; // whose own charts are over all scenes
  if (isCharted && errors.length) byId("charts").append(barChart("Misclassified samples", "%", errors));
  if (isCharted && costs.length) byId("charts").append(barChart("Time of a frame", "ms", costs));
  byId("charts").querySelector("figcaption")?.append(errorKeys());
  if (isPath) showFlips(compared, label);
  byId("summary").hidden = !summary.length;
  byId("summary-table").replaceChildren(sortableTable("Means by technique", summaryColumns(several), summary));
}

// How steady the shadows are along the path.
function showFlips(rows, label) {
  const {frames, from_seconds, to_seconds, still} = measured.find(row => row.temporal).temporal;
  byId("summary-note").textContent += ` Along a path: ${frames} frames from ${numberText(from_seconds)} s to `
    + `${numberText(to_seconds)} s${still ? ", casters and light held" : ""}. Flips are surface points whose shadow `
    + "changes from one frame to the next while exact visibility does not.";
  const strips = rows.map(row => ({label: label(row), text: percentText(row.flips_percent) + " %",
    values: row.pairs.map(pair => ({at: pair.seconds, value: pair.percent}))}));
  byId("charts").append(stripChart("Flips from frame to frame", "%", "s", strips));
}

const errorKeys = () => element("span", {class: "keys"},
  ...kLayers.map(([name, key]) => colourKey(name, colours[key])));

function colourKey(name, colour) {
  const swatch = element("span", {class: "swatch"});
  swatch.style.background = colour;
  return element("span", {class: "key"}, swatch, name);
}

function column(label, key, text, title) {
  label = label.replace(" %", "\u00a0%"); // the sign stays with its word
  return {label, value: typeof key === "function" ? key : row => row[key] ?? null, text, title};
}

const errorColumns = [
  column("Misclassified %", "misclassified_percent", percentText, "of all light-facing samples"),
  column("Edge band %", "edge_band_percent", percentText, "of the samples within 2 pixels of a shadow boundary"),
  column("Terminator band %", "terminator_band_percent", percentText,
    "of the samples within 2 pixels of a surface that turns away"),
  column("Interior %", "interior_percent", percentText, "of all other samples"),
];
const flipColumns = isPath ? [
  column("Flips %", row => row.flips_percent ?? row.temporal?.flips_percent ?? null, percentText,
    "of the surface points that two frames of the path show and whose exact visibility stays"),
] : [];
const costColumns = [
  column("Lixels used", "lixels_used", countText, "of the light in a frame"),
  column("Bytes", "bytes", bytesText, "of all maps and tables"),
];

function techniqueColumns() {
  const keys = [["Lixels", "lixels"], ["Picture", "size"], ["Executor", "executor"]];
  return [
    {...column("Technique", "technique"), title: "as it was typed"},
    ...keys.filter(([, key]) => differ(run.results, key)).map(([label, key]) => column(label, key)),
  ];
}

function summaryColumns(several) {
  return [
    ...(several ? [column("Scene", "scene")] : []), ...techniqueColumns(), ...errorColumns, ...flipColumns,
    column("Unserved", "unserved", countText, "samples that no map covers, over all views"),
    ...(isPath ? [column("Footprint p50", "footprint_p50", numberText, "pixels a lixel, exceeded by half of the samples")]
      : []),
    column("Footprint p90", "footprint_p90", numberText, "pixels a lixel, exceeded by a tenth of the samples"),
    ...costColumns, column("Frame ms", "frame_ms", numberText),
  ];
}
