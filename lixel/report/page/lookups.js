// Errors of lookups against bytes and against time, with those that no other beats.

const kDotPlotHeight = 300, kDotPlotLeft = 52, kDotPlotRight = 18;
const kLookupErrors = [
  ["misclassified_percent", "misclassified %", percentText],
  ["area_rmse", "RMSE to exact-area", numberText],
  ["filtered_rmse", "RMSE to exact-filtered", numberText],
  ["bleeding_percent", "light in dark interiors %", percentText],
];
const kLookupCosts = [
  ["bytes_per_lixel", "bytes a lixel", lookup => lookup.bytes_per_lixel],
  ["frame_ratio", "frame, over pcf(1)", lookup => lookup.timing?.frame_ratio ?? null],
];

function showLookups() {
  const fronts = [...study.fronts, ...study.timing.fronts];
  const frontOf = (error, cost) => fronts.find(one => one.error === error && one.cost === cost)?.lookups ?? [];
  byId("study-note").textContent += " Each dot is a lookup over focused maps; the line joins those that no other beats, with their names.";
  byId("curves").replaceChildren(...kLookupErrors.flatMap(([error, errorName, text]) =>
    kLookupCosts.filter(([, , costOf]) => study.lookups.some(lookup => isNumber(costOf(lookup))))
      .map(([cost, costName, costOf]) => dotChart(`${errorName} against ${costName}`, costName,
        study.lookups.filter(lookup => isNumber(lookup[error]) && isNumber(costOf(lookup))).map(lookup => ({
          name: lookup.lookup, x: costOf(lookup), y: lookup[error], isBest: frontOf(error, cost).includes(lookup.lookup),
          title: `${lookup.lookup}: ${text(lookup[error])}, ${numberText(costOf(lookup))} ${costName}`,
        }))))));
  const bestOf = lookup => fronts.filter(front => front.lookups.includes(lookup.lookup))
    .map(front => `${nameOfError(front.error)} / ${front.cost === "frame_ratio" ? "time" : "bytes"}`).join(", ");
  byId("curves").after(sortableTable("Lookups", lookupColumns(bestOf), study.lookups));
}

const nameOfError = key => ({misclassified_percent: "misclassified", area_rmse: "area", filtered_rmse: "filtered",
  bleeding_percent: "bleeding"})[key];

function lookupColumns(bestOf) {
  const inside = lookup => lookup.dark_interior_samples
    ? 100 * lookup.dark_interior_lit / lookup.dark_interior_samples : null;
  const time = (label, key, title) => column(label, lookup => lookup.timing?.[key] ?? null, numberText, title);
  return [
    column("Lookup", "lookup"),
    column("Bytes", "bytes_per_lixel", countText, "a lixel: the map, and all that is prepared from it"),
    column("Bytes read", "bytes_read_per_lixel", countText, "a lixel: of the textures that the lookup reads"),
    column("Misclassified %", "misclassified_percent", percentText, "mean over views and lights"),
    column("Over pcf(1)", "ratio_to_nearest", numberText, "misclassified, geometric mean over views and lights"),
    column("Shades", "shades", countText, "different values of visibility, at most in one picture"),
    column("Transition", "transition_pixels", numberText, "pixels from 5 to 95 % lit, median over views and lights"),
    column("Area RMSE", "area_rmse", numberText, "over the edge band, against the share of the pixel that is lit"),
    column("Area largest", "area_largest", numberText, "of these errors"),
    column("Filtered RMSE", "filtered_rmse", numberText,
      "over the edge band, against the share of the filter's footprint that is lit"),
    column("Filtered largest", "filtered_largest", numberText, "of these errors"),
    column("Bleeding %", "bleeding_percent", percentText, "mean light of interior samples that are exactly dark"),
    column("False lit inside %", inside, percentText, "of these samples: lit, when rounded"),
    time("Frame", "frame_ratio", "with maps drawn anew, over pcf(1); where processors draw, the time that they spend"),
    time("Passes", "pass_ratio", "preparing and looking up, over pcf(1)"),
    time("Prepare ms", "prepare_ms", "mean"), time("Lookup ms", "lookup_ms", "mean"),
    column("None beats it in", bestOf),
  ];
}

// dots: [{name, x, y, isBest, title}]; y is logarithmic, and 0 lies on the axis below.
function dotChart(title, unit, dots) {
  const told = dots.map(dot => ({label: dot.name, text: dot.title + (dot.isBest ? ", best" : "")}));
  return chart(title, told, (svg, width) => drawDots(svg, width, unit, dots));
}

// A logarithmic axis from a little below the least to a little above the most, with some of each decade.
function logTicks(values) {
  const low = Math.min(...values) / 1.15, high = Math.max(...values) * 1.15;
  const digits = high < 6 * low ? [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9] : [1, 2, 5], ticks = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power)
    for (const digit of digits) ticks.push(digit * 10 ** power);
  return {low, high, ticks: ticks.filter(tick => tick >= low && tick <= high)};
}

function drawDots(svg, width, unit, dots) {
  if (!width || !dots.length) return;
  const positive = dots.map(dot => dot.y).filter(y => y > 0);
  const {low, high, ticks} = logTicks(positive.length ? positive : [1]);
  const hasZero = positive.length < dots.length;
  const bottom = kDotPlotHeight - 40, lowest = hasZero ? bottom - 22 : bottom;
  const leastX = Math.min(...dots.map(dot => dot.x)), mostX = Math.max(...dots.map(dot => dot.x));
  const spare = 0.06 * (mostX - leastX || 1), plotWidth = width - kDotPlotLeft - kDotPlotRight;
  const xOf = x => kDotPlotLeft + plotWidth * (x - leastX + spare) / (mostX - leastX + 2 * spare);
  const yOf = y => y > 0 ? 8 + (lowest - 8) * Math.log(high / y) / Math.log(high / low) : bottom;
  svg.setAttribute("viewBox", `0 0 ${width} ${kDotPlotHeight}`);
  svg.setAttribute("height", kDotPlotHeight);
  svg.replaceChildren();
  for (const tick of [...ticks, ...(hasZero ? [0] : [])])
    svg.append(svgElement("line", {class: "grid", x1: kDotPlotLeft, x2: width - kDotPlotRight, y1: yOf(tick), y2: yOf(tick)}),
      svgElement("text", {class: "tick", x: kDotPlotLeft - 6, y: yOf(tick) + 4, "text-anchor": "end"},
        String(Number(tick.toPrecision(2)))));
  const step = niceStep(mostX - leastX || 1, Math.max(2, Math.floor(plotWidth / 70)));
  const isWhole = dots.every(dot => Number.isInteger(dot.x)); // bytes, of which there are few kinds
  const first = Math.ceil(leastX / step), marks = isWhole ? [...new Set(dots.map(dot => dot.x))]
    : Array.from({length: Math.floor(mostX / step + 1e-9) - first + 1}, (_, i) => (first + i) * step);
  for (const x of marks)
    svg.append(svgElement("text", {class: "tick", x: xOf(x), y: bottom + 16, "text-anchor": "middle"},
      String(Number(x.toPrecision(6)))));
  svg.append(svgElement("text", {class: "tick", x: kDotPlotLeft + plotWidth / 2, y: bottom + 34, "text-anchor": "middle"},
    unit));
  drawFront(svg, width, dots.filter(dot => dot.isBest).sort((a, b) => a.x - b.x || b.y - a.y), xOf, yOf);
  for (const dot of dots) {
    const circle = svgElement("circle", {cx: xOf(dot.x), cy: yOf(dot.y), r: dot.isBest ? 4.5 : 3.5,
      class: dot.isBest ? "best" : "dot"});
    circle.append(svgElement("title", {}, dot.title));
    svg.append(circle);
  }
}

// Steps: at a cost between two of them the cheaper one is still the best.
function drawFront(svg, width, best, xOf, yOf) {
  const corners = best.flatMap((dot, i) => i ? [[xOf(dot.x), yOf(best[i - 1].y)], [xOf(dot.x), yOf(dot.y)]]
    : [[xOf(dot.x), yOf(dot.y)]]);
  if (best.length) corners.push([width - kDotPlotRight, yOf(best.at(-1).y)]);
  svg.append(svgElement("polyline", {class: "front", points: corners.map(([x, y]) => `${x},${y}`).join(" ")}));
  let taken = [];
  for (const dot of best) {
    const room = 7 * dot.name.length, isRight = xOf(dot.x) + 8 + room < width;
    let y = yOf(dot.y) - 8;
    while (taken.some(other => Math.abs(other.y - y) < 12 && Math.abs(other.x - xOf(dot.x)) < room)) y -= 12;
    taken = [...taken, {x: xOf(dot.x), y}];
    svg.append(svgElement("text", {class: "name", x: xOf(dot.x) + (isRight ? 6 : -6), y,
      "text-anchor": isRight ? "start" : "end"}, dot.name));
  }
}
