// Puts the page together.

const percentileColumns = (label, key, names, unit) => names.map(name =>
  column(`${label} ${name}`, row => row[key]?.[name] ?? null, numberText, unit));

// Light-facing samples on any of the scene's planes, or on none of them.
function planeErrors(row, isOn) {
  const counts = (row.planes ?? []).filter(one => (one.plane !== null) === isOn);
  const sum = key => counts.reduce((total, one) => total + one[key], 0);
  return sum("samples") ? 100 * sum("misclassified") / sum("samples") : null;
}

// "floor 350×350, rest 128×128; without wall (plane-faces-away)".
function mapsText(row) {
  const maps = (row.regions ?? []).map(({plane, lixels}) => `${plane ?? "rest"} ${lixels[0]}×${lixels[1]}`).join(", ");
  const without = (row.left_out ?? []).map(({plane, reason}) => `${plane} (${reason})`).join(", ");
  return without ? `${maps}; without ${without}` : maps || kNone;
}

const shareOfDarkInterior = ({shades}) => shades?.dark_interior_samples
  ? 100 * shades.dark_interior_lit / shades.dark_interior_samples : null;

function showRows() {
  const group = {...column("View", groupName), title: "View and light; shows its pictures", open: row => openView(row)};
  const columns = [
    group, ...techniqueColumns(), ...errorColumns, ...flipColumns,
    column("False shadow", "false_shadow", countText, "samples"),
    column("False lit", "false_lit", countText, "samples"),
    column("Unserved", "unserved", countText, "samples that no map covers"),
    column("Light-facing", "light_facing", countText, "samples that count"),
    ...percentileColumns("Footprint", "footprint_pixels_per_lixel", ["p50", "p90", "p99", "max"], "pixels a lixel"),
    ...percentileColumns("Density", "density_lixels_per_pixel", ["p1", "p10", "p50"], "lixels a pixel"),
    ...costColumns, column("Frame ms", row => row.timing.frame_ms, numberText),
  ];
  if (measured.some(row => row.agreement_with !== undefined)) columns.push(
    column("Agreement %", "agreement_percent", percentText, "samples for which both executors say the same"),
    column("Shared errors %", "shared_misclassified_percent", percentText, "of the samples that either got wrong"),
    column("Lixels alike %", "lixels_agreeing_percent", percentText, "lixels of one depth to 1e-4 of the range in both executors' maps"));
  if (measured.some(row => row.planes)) columns.push(
    column("On planes %", row => planeErrors(row, true), percentText, "of samples on the scene's planes"),
    column("Off planes %", row => planeErrors(row, false), percentText, "of all other samples"));
  if (measured.some(row => row.regions?.some(one => one.plane !== null) || row.left_out)) columns.push(
    {...column("Maps", mapsText), title: "of planes and of the rest, lixels; planes without a map, and why"});
  const shade = (label, key, title) => column(label, row => row.shades?.[key] ?? null, numberText, title);
  if (measured.some(row => row.shades)) columns.push(
    shade("Shades", "distinct", "different values of visibility"),
    shade("Transition", "transition_pixels", "pixels from 5 to 95 % lit, across the boundary of exact visibility"),
    shade("Bleeding %", "bleeding_percent", "mean light of interior samples that are exactly dark"),
    column("False lit inside %", row => shareOfDarkInterior(row), percentText,
      "of the interior samples that are exactly dark: lit, when rounded"),
    shade("Area RMSE", "area_rmse", "over the edge band, against the share of the pixel that is lit"),
    shade("Area largest", "area_largest", "error over the edge band"),
    shade("Filtered RMSE", "filtered_rmse", "over the edge band, against the share of the filter's footprint that is lit"),
    shade("Filtered largest", "filtered_largest", "error over the edge band"));
  const inZone = (label, key) => column(label, row => row.temporal?.[key] ?? null, percentText,
    "of those points, in this zone of the earlier frame");
  if (isPath) columns.push(
    column("Flips", row => row.temporal?.flips ?? null, countText, "over all frames"),
    inZone("Edge band flips %", "edge_band_flips_percent"),
    inZone("Terminator band flips %", "terminator_band_flips_percent"),
    inZone("Interior flips %", "interior_flips_percent"),
    column("Refused frames", row => row.temporal?.refused_frames ?? null, countText, "which count nowhere else"));
  byId("rows").hidden = !measured.length;
  byId("rows-table").replaceChildren(sortableTable("All rows", columns, measured, true));
}

function showRefused() {
  byId("refused").hidden = !refused.length;
  byId("refused-table").replaceChildren(sortableTable("Refused", [
    column("View", groupName), ...techniqueColumns(), column("Reason", row => row.refused.reason),
    {...column("Message", row => row.refused.message), className: "message"},
  ], refused));
}

showHead();
showSummary();
startPictures();
showReproduction();
showStudy();
showRows();
showRefused();
