// How cost grows: for each axis a plot of every quantity, and the exponents.

const run = jsonOf("results");
const kQuantities = [["frame_ms", "Frame, ms", numberText], ["plan_ms", "Planning, ms", numberText],
  ["peak_resident_bytes", "Peak memory of the process, bytes", bytesText],
  ["device_bytes", "Buffers and textures on the device, bytes", bytesText]];
const kTicks = {pixels: squareTicks, lixels: squareTicks};

const measuredRows = run.rows.filter(row => !row.skipped), skippedRows = run.rows.filter(row => row.skipped);
const techniques = [...new Set(run.rows.map(row => row.technique))];
const growthOf = (axis, technique, quantity) => run.timing.growth.find(one => one.axis === axis
  && one.technique === technique && one.quantity === quantity);

function quantityPlot({axis, unit}, [quantity, title, text]) {
  const rows = measuredRows.filter(row => row.axis === axis && isNumber(row.timing[quantity]));
  if (!rows.length) return [];
  const lines = techniques.map((technique, index) => ({label: technique, ...lineLook(index),
    points: rows.filter(row => row.technique === technique && row.timing[quantity] > 0).map(row => ({x: row.size, y: row.timing[quantity],
      title: `${technique}, ${countText(row.size)} ${unit}: ${text(row.timing[quantity])}`}))}));
  return [logPlot(title, lines, {xLabel: unit, yText: quantity.endsWith("bytes") ? bytesText : undefined,
    xTicks: kTicks[axis] ?? ticksAt(rows.map(row => row.size))})];
}

function exponentTable({axis}) {
  const columns = kQuantities.map(([quantity, title]) => ({
    label: title.replace(/,.*/, ""), title: "exponent of the upper half, and how far points are from the line, in percent",
    value: technique => growthOf(axis, technique, quantity)?.exponent ?? null,
    text: (value, technique) => isNumber(value)
      ? `${value.toFixed(2)} \u00b1${(100 * growthOf(axis, technique, quantity).log_deviation).toFixed(0)}\u00a0%` : kNone,
  }));
  return sortableTable(`Exponents by ${axis}`, [{label: "Technique", value: technique => technique}, ...columns], techniques);
}

function axisSection(axis) {
  const title = `By ${axis.axis}`;
  return element("section", {"aria-label": title}, element("h2", {}, title),
    element("p", {class: "note"}, `With ${axis.others}.`),
    element("div", {class: "charts"}, ...kQuantities.flatMap(quantity => quantityPlot(axis, quantity))), exponentTable(axis));
}

function showBenchRows() {
  const column = (label, value, text) => ({label, value, text});
  const common = [column("Axis", row => row.axis), column("Technique", row => row.technique),
    column("Triangles", row => row.triangles, countText), column("Pixels", row => row.pixels, countText),
    column("Lixels a light", row => row.lixels, countText), column("Lights", row => row.lights, countText)];
  const passes = [...new Set(measuredRows.flatMap(row => row.timing.passes.map(pass => pass.name)))];
  byId("rows-table").replaceChildren(sortableTable("All rows", [...common,
    ...kQuantities.map(([key, label, text]) => column(label.replace(/, bytes/, ""), row => row.timing[key], text)),
    ...passes.map(name => column(`${name}, ms`, row => row.timing.passes.find(pass => pass.name === name)?.ms ?? null, numberText)),
  ], measuredRows, true));
  byId("skipped").hidden = !skippedRows.length;
  byId("skipped-table").replaceChildren(sortableTable("Left out", [...common,
    {...column("Why", row => row.skipped), className: "message"}], skippedRows));
}

showFacts({Executor: run.executor, "Frames a time": run.timing_frames, lixel: run.lixel_version, Made: run.timing.date,
  On: run.timing.host});
document.title = "lixel: how cost grows";
byId("keys").append(...techniques.map((technique, index) => lineKey(technique, lineLook(index))));
byId("axes").append(...run.axes.map(axisSection));
showBenchRows();
