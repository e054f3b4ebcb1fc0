// The rows of the run: their names, and who belongs together.

const run = jsonOf("results");
const colours = jsonOf("colours");
run.results.forEach((row, index) => { row.index = index; });
const measured = run.results.filter(row => !row.refused);
const refused = run.results.filter(row => row.refused);

const severalScenes = differ(run.results, "scene");
const differing = ["lixels", "size", "executor"].filter(key => differ(run.results, key));

// A row's name among the others: what differs is said, what is common is not.
const nameOf = row => [row.technique, ...differing.map(key => row[key])].join(" · ");

function groupName(row) {
  return [severalScenes && row.scene, row.view, row.light].filter(Boolean).join(" · ");
}

function groupBy(rows, keyOf) {
  const groups = new Map();
  for (const row of rows) {
    const key = keyOf(row);
    if (!groups.has(key)) groups.set(key, []);
    groups.get(key).push(row);
  }
  return groups;
}

const groups = [...groupBy(run.results, row => JSON.stringify([row.scene, row.view, row.light])).values()];

// Exact first, then by error, so that every list of the page has the same order.
const byError = (a, b) => (a.technique !== "exact") - (b.technique !== "exact")
  || compareValues(a.misclassified_percent, b.misclassified_percent, true);

const shareOf = (row, count) => row.light_facing ? 100 * row[count] / row.light_facing : null;

// One row for each technique of a scene: means over its views and lights.
function summarise(rows) {
  const {scene, technique, technique_full, lixels, size, executor} = rows[0];
  const meanOf = valueOf => mean(rows.map(valueOf));
  return {
    scene, technique, technique_full, lixels, size, executor, views: rows.length,
    misclassified_percent: meanOf(row => row.misclassified_percent),
    false_shadow_percent: meanOf(row => shareOf(row, "false_shadow")),
    false_lit_percent: meanOf(row => shareOf(row, "false_lit")),
    edge_band_percent: meanOf(row => row.edge_band_percent),
    terminator_band_percent: meanOf(row => row.terminator_band_percent),
    interior_percent: meanOf(row => row.interior_percent),
    unserved: rows.reduce((sum, row) => sum + row.unserved, 0),
    flips_percent: meanOf(row => row.temporal?.flips_percent),
    footprint_p50: meanOf(row => row.footprint_pixels_per_lixel?.p50),
    footprint_p90: meanOf(row => row.footprint_pixels_per_lixel?.p90),
    lixels_used: meanOf(row => row.lixels_used),
    bytes: meanOf(row => row.bytes),
    frame_ms: meanOf(row => row.timing.frame_ms),
    pairs: pairsOf(rows.filter(row => row.temporal)),
  };
}

// Of rows along the same path: flips from frame to frame, in percent; null where no frame could be compared.
function pairsOf(rows) {
  if (!rows.length) return [];
  return rows[0].temporal.pairs.map(({seconds}, index) => {
    const sum = key => rows.reduce((total, row) => total + (row.temporal.pairs[index]?.[key] ?? 0), 0);
    return {seconds, percent: sum("samples") ? 100 * sum("flips") / sum("samples") : null};
  });
}

const isPath = measured.some(row => row.temporal);

const keyOverViews = row => JSON.stringify([row.scene, row.technique_full, row.lixels, row.size, row.executor]);
const summary = [...groupBy(measured, keyOverViews).values()].map(summarise).sort(byError);
