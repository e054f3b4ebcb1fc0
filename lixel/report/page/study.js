// What a study found: how error falls with lixels, a chart for each scene, on its planes and off them; or lookups (lookups.js).

const study = run.study;
const kCurveColours = ["var(--accent)", "#c2571a", "#2a8a5b"];
const kPlotHeight = 230, kPlotLeft = 46, kPlotBottom = 30;

function showStudy() {
  byId("study").hidden = !study;
  if (!study) return;
  byId("study-title").textContent = study.name;
  byId("study-note").textContent = study.question
    + (study.left_out ? ` Without ${study.left_out} views and lights that some technique refused.` : "");
  if (study.lookups) showLookups();
  else showBudgets();
}

function showBudgets() {
  const techniques = [...new Set(study.curves.map(curve => curve.technique.replace(/planes\([^)]*\)/, "planes")))];
  const colourOf = curve => kCurveColours[techniques.indexOf(curve.technique.replace(/planes\([^)]*\)/, "planes"))
    % kCurveColours.length];
  byId("study-keys").replaceChildren(
    ...techniques.map((technique, index) => colourKey(technique, kCurveColours[index % kCurveColours.length])));
  byId("curves").replaceChildren(...[...groupBy(study.curves, curve => curve.scene)].flatMap(([scene, curves]) =>
    [["planes", "on its planes"], ["others", "elsewhere"]].map(([receivers, where]) => {
      const drawn = curves.filter(curve => curve.receivers === receivers);
      return curveChart(`${scene}, ${where}: misclassified %`, drawn.map(curve => ({
        label: curve.technique, colour: colourOf(curve),
        points: curve.points.map(point => ({x: point.lixels_used, y: point.misclassified_percent ?? 0,
          title: `${curve.technique}, ${countText(point.lixels_used)} lixels: `
            + `${percentText(point.misclassified_percent)} %`})),
      })));
    })));
}

// lines: [{label, colour, points: [{x, y, title}]}]. Both axes are logarithmic; a y of 0 lies on the axis below.
function curveChart(title, lines) {
  const told = lines.map(line => ({label: line.label, text: line.points.map(point => point.title).join("; ")}));
  return chart(title, told, (svg, width) => drawCurves(svg, width, lines));
}

function drawCurves(svg, width, lines) {
  if (!width) return;
  const points = lines.flatMap(line => line.points), seen = points.filter(point => point.y > 0);
  const [low, high] = decades(seen.map(point => point.y));
  const left = Math.log2(Math.min(...points.map(point => point.x))), right = Math.log2(Math.max(...points.map(p => p.x)));
  const bottom = kPlotHeight - kPlotBottom, zero = bottom - 8, plotWidth = width - kPlotLeft - 14;
  const xOf = x => kPlotLeft + plotWidth * (Math.log2(x) - left) / Math.max(right - left, 1e-9);
  const yOf = y => y > 0 ? 8 + (zero - 26) * (high - Math.log10(y)) / (high - low) : zero;
  svg.setAttribute("viewBox", `0 0 ${width} ${kPlotHeight}`);
  svg.setAttribute("height", kPlotHeight);
  svg.replaceChildren();
  const tickAt = (y, text) => svg.append(
    svgElement("line", {class: "grid", x1: kPlotLeft, x2: width - 14, y1: y, y2: y}),
    svgElement("text", {class: "tick", x: kPlotLeft - 6, y: y + 4, "text-anchor": "end"}, text));
  for (let power = low; power <= high; ++power) tickAt(yOf(10 ** power), String(Number((10 ** power).toPrecision(1))));
  tickAt(zero, "0");
  for (let power = Math.ceil(left / 2) * 2; power <= right + 0.01; power += 2)
    svg.append(svgElement("text", {class: "tick", x: xOf(2 ** power), y: bottom + 16, "text-anchor": "middle"},
      `${2 ** (power / 2)}²`));
  for (const {colour, points} of lines) {
    svg.append(svgElement("polyline", {fill: "none", stroke: colour, "stroke-width": 2,
      points: points.map(point => `${xOf(point.x)},${yOf(point.y)}`).join(" ")}));
    for (const point of points) {
      const dot = svgElement("circle", {cx: xOf(point.x), cy: yOf(point.y), r: points.length > 1 ? 3 : 5, fill: colour});
      dot.append(svgElement("title", {}, point.title));
      svg.append(dot);
    }
  }
}

// Powers of ten around all values, at least one apart.
function decades(values) {
  if (!values.length) return [-1, 0];
  const low = Math.floor(Math.log10(Math.min(...values))), high = Math.ceil(Math.log10(Math.max(...values)));
  return [low, Math.max(high, low + 1)];
}
