// Bar charts as SVG, drawn again when their width changes.

const kBarHeight = 18, kBarStep = 28, kAxisHeight = 20;

function svgElement(name, attributes, text) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

// A step of 1, 2 or 5 times a power of ten, at most `count` of which make `range`.
function niceStep(range, count) {
  const power = 10 ** Math.floor(Math.log10(range / count));
  return [1, 2, 5, 10].map(factor => factor * power).find(step => range / step <= count);
}

// bars: [{label, text, parts: [{value, colour or className}]}], lengths in one unit; `alt` says it all in words.
function barChart(title, unit, bars) {
  const alt = `${title}: ` + bars.map(bar => `${bar.label} ${bar.text}`).join(", ");
  const svg = svgElement("svg", {role: "img", "aria-label": alt});
  const draw = () => drawBars(svg, svg.clientWidth, unit, bars);
  new ResizeObserver(draw).observe(svg);
  return element("figure", {class: "chart"}, element("figcaption", {}, title), svg);
}

function drawBars(svg, width, unit, bars) {
  if (!width) return;
  const total = bar => bar.parts.reduce((sum, part) => sum + part.value, 0);
  const longest = Math.max(...bars.map(total)) || 1;
  const labelWidth = Math.min(0.42 * width, 12 + 7.4 * Math.max(...bars.map(bar => bar.label.length)));
  const textWidth = 12 + 7.6 * Math.max(...bars.map(bar => bar.text.length));
  const scale = Math.max(20, width - labelWidth - textWidth) / longest;
  const bottom = bars.length * kBarStep;
  svg.setAttribute("viewBox", `0 0 ${width} ${bottom + kAxisHeight}`);
  svg.setAttribute("height", bottom + kAxisHeight);
  svg.replaceChildren();

  const step = niceStep(longest, Math.max(2, Math.floor(scale * longest / 80)));
  for (let i = 0; i * step <= longest * 1.0001; ++i) {
    const x = labelWidth + i * step * scale;
    svg.append(svgElement("line", {class: "grid", x1: x, x2: x, y1: 0, y2: bottom}),
               svgElement("text", {class: "tick", x, y: bottom + 14, "text-anchor": i ? "middle" : "start"},
                          i ? Number((i * step).toPrecision(6)) : `0 ${unit}`));
  }
  bars.forEach((bar, index) => drawBar(svg, bar, index * kBarStep, labelWidth, scale));
}

function drawBar(svg, bar, top, labelWidth, scale) {
  const middle = top + kBarStep / 2;
  const room = Math.floor((labelWidth - 12) / 7.4);
  const short = bar.label.length > room ? bar.label.slice(0, Math.max(1, room - 1)) + "…" : bar.label;
  const label = svgElement("text", {x: labelWidth - 8, y: middle + 4.5, "text-anchor": "end"}, short);
  label.append(svgElement("title", {}, bar.label));
  svg.append(label);

  let x = labelWidth;
  for (const part of bar.parts) {
    const look = part.className ? {class: part.className} : {fill: part.colour};
    const width = part.value * scale;
    svg.append(svgElement("rect", {x, y: middle - kBarHeight / 2, width, height: kBarHeight, ...look}));
    x += width;
  }
  svg.append(svgElement("text", {x: x + 6, y: middle + 4.5}, bar.text));
}
