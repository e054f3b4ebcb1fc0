// Curves over logarithmic axes, drawn again when their width changes.

const kPlotHeight = 250, kPlotLeft = 50, kPlotRight = 16, kPlotTop = 10, kPlotBottom = 30;
const kLineColours = ["var(--accent)", "#c2571a", "#2a8a5b", "#9a4fc0", "#b58900", "#c23a6a", "#1f8fa8", "#7a7f87"];
const kDashes = [null, "7 4", "2 4"];

// Of the index-th line of a page: first colours, then dashes tell them apart.
const lineLook = index => ({colour: kLineColours[index % kLineColours.length],
  dash: kDashes[Math.floor(index / kLineColours.length) % kDashes.length]});

// The line itself, as in the plot.
function lineKey(name, {colour, dash}) {
  const line = svgElement("svg", {width: 26, height: 8, "aria-hidden": "true"});
  line.append(svgElement("line", {x1: 0, x2: 26, y1: 4, y2: 4, stroke: colour, "stroke-width": 2.5,
    ...(dash ? {"stroke-dasharray": dash} : {})}));
  return element("span", {class: "key"}, line, name);
}

// lines: [{label, colour, dash, points: [{x, y, title}]}]; x is above 0, a y of 0 lies on a line of its own below the others.
// `xTicks(low, high)` gives [{at, text}]; `yText` says how a value of y is written.
function logPlot(title, lines, {xTicks = plainTicks, xLabel = "", yText = shortNumber} = {}) {
  const told = lines.map(line => ({label: line.label, text: line.points.map(point => point.title).join("; ")}));
  return chart(title, told, (svg, width) => drawPlot(svg, width, lines.filter(line => line.points.length), {xTicks, xLabel, yText}));
}

function drawPlot(svg, width, lines, {xTicks, xLabel, yText}) {
  if (!width || !lines.length) return;
  const points = lines.flatMap(line => line.points), seen = points.map(point => point.y).filter(y => y > 0);
  const hasZero = seen.length < points.length;
  const [left, right] = rangeOf(points.map(point => point.x), 1), [low, high] = rangeOf(seen, 1.6);
  const height = kPlotHeight + (xLabel ? 14 : 0), bottom = kPlotHeight - kPlotBottom;
  const floor = bottom - (hasZero ? 26 : 4);
  const xOf = x => kPlotLeft + (width - kPlotLeft - kPlotRight) * Math.log(x / left) / Math.log(right / left);
  const yOf = y => y > 0 ? kPlotTop + (floor - kPlotTop) * Math.log(high / y) / Math.log(high / low) : bottom - 8;
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.setAttribute("height", height);
  svg.replaceChildren();
  const tickAt = (y, text) => svg.append(
    svgElement("line", {class: "grid", x1: kPlotLeft, x2: width - kPlotRight, y1: y, y2: y}),
    svgElement("text", {class: "tick", x: kPlotLeft - 6, y: y + 4, "text-anchor": "end"}, text));
  for (const {at} of yText === bytesText ? doublings(low, high) : plainTicks(low, high)) tickAt(yOf(at), yText(at));
  if (hasZero) tickAt(yOf(0), "0");
  drawXTicks(svg, xTicks(left, right), xOf, bottom, xLabel, width);
  for (const line of lines) drawLine(svg, line, xOf, yOf);
}

// As many as there is room for; the first and those after it that do not touch the one before.
function drawXTicks(svg, ticks, xOf, bottom, xLabel, width) {
  let free = -Infinity;
  for (const {at, text} of ticks) {
    const x = xOf(at), half = 4 * text.length, middle = Math.min(x, width - half);
    if (middle - half < free) continue;
    free = middle + half + 6;
    svg.append(svgElement("line", {class: "grid", x1: x, x2: x, y1: bottom, y2: bottom + 4}),
      svgElement("text", {class: "tick", x: middle, y: bottom + 16, "text-anchor": "middle"}, text));
  }
  if (xLabel) svg.append(svgElement("text", {class: "tick", x: width - kPlotRight, y: bottom + 32, "text-anchor": "end"}, xLabel));
}

function drawLine(svg, {colour, dash, points}, xOf, yOf) {
  svg.append(svgElement("polyline", {fill: "none", stroke: colour, "stroke-width": 2,
    ...(dash ? {"stroke-dasharray": dash} : {}),
    points: points.map(point => `${xOf(point.x)},${yOf(point.y)}`).join(" ")}));
  for (const point of points) {
    const dot = svgElement("circle", {cx: xOf(point.x), cy: yOf(point.y), r: points.length > 1 ? 3 : 5, fill: colour});
    dot.append(svgElement("title", {}, point.title));
    svg.append(dot);
  }
}

// Around all values, and a factor apart at least.
function rangeOf(values, factor) {
  if (!values.length) return [0.1, 1];
  const low = Math.min(...values), high = Math.max(...values), widen = Math.max(1, factor * low / high);
  return low * 1.0001 < high ? [low / Math.sqrt(widen), high * Math.sqrt(widen)] : [low / 2, high * 2];
}

// 12.3k, 4M: three digits.
function shortNumber(value) {
  const [unit, size] = [["G", 1e9], ["M", 1e6], ["k", 1e4]].find(([, size]) => value >= size) ?? ["", 1];
  return Number((value / (unit === "k" ? 1e3 : size)).toPrecision(3)) + unit;
}

// Powers of ten, and 2 and 5 times these where the range is short.
function plainTicks(low, high) {
  const decades = Math.log10(high / low), ticks = [];
  const factors = decades > 3 ? [1] : decades > 0.7 ? [1, 2, 5] : [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power)
    for (const factor of factors) {
      const at = factor * 10 ** power;
      if (at >= low * 0.999 && at <= high * 1.001) ticks.push({at, text: shortNumber(at)});
    }
  return ticks;
}

// Powers of two, of bytes: at most eight; with quarters between them where the range is short.
function doublings(low, high) {
  const range = Math.log2(high / low), step = Math.ceil(range / 8), ticks = [];
  const factors = range > 3 ? [1] : range > 1.5 ? [1, 1.5] : [1, 1.125, 1.25, 1.375, 1.5, 1.625, 1.75, 1.875];
  for (let power = Math.floor(Math.log2(low)); power <= Math.log2(high); power += step)
    ticks.push(...factors.map(factor => ({at: factor * 2 ** power})).filter(({at}) => at >= low && at <= high));
  return ticks;
}

// 256², 512²: of numbers of lixels and pixels.
function squareTicks(low, high) {
  const ticks = [];
  for (let power = Math.ceil(Math.log2(low) / 2 - 1e-3); power <= Math.log2(high) / 2 + 1e-3; ++power)
    ticks.push({at: 4 ** power, text: `${2 ** power}²`});
  return ticks.length ? ticks : plainTicks(low, high);
}

// The values themselves.
const ticksAt = values => () => [...new Set(values)].sort((a, b) => a - b).map(at => ({at, text: shortNumber(at)}));
