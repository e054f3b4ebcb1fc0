// Charts as SVG, drawn again when their width changes.

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
  return chart(title, bars, (svg, width) => drawBars(svg, width, unit, bars));
}

function chart(title, lines, drawAt) {
  const alt = `${title}: ` + lines.map(line => `${line.label} ${line.text}`).join(", ");
  const svg = svgElement("svg", {role: "img", "aria-label": alt});
  new ResizeObserver(() => drawAt(svg, svg.clientWidth)).observe(svg);
  return element("figure", {class: "chart"}, element("figcaption", {}, title), svg);
}

function drawBars(svg, width, unit, bars) {
  if (!width) return;
  const total = bar => bar.parts.reduce((sum, part) => sum + part.value, 0);
  const longest = Math.max(...bars.map(total)) || 1;
  const {labelWidth, textWidth} = widthsOf(bars, width);
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

function widthsOf(lines, width) {
  return {
    labelWidth: Math.min(0.42 * width, 12 + 7.4 * Math.max(...lines.map(line => line.label.length))),
    textWidth: 12 + 7.6 * Math.max(...lines.map(line => line.text.length)),
  };
}

function shortLabel(text, labelWidth, middle) {
  const room = Math.floor((labelWidth - 12) / 7.4);
  const short = text.length > room ? text.slice(0, Math.max(1, room - 1)) + "…" : text;
  const label = svgElement("text", {x: labelWidth - 8, y: middle + 4.5, "text-anchor": "end"}, short);
  label.append(svgElement("title", {}, text));
  return label;
}

function drawBar(svg, bar, top, labelWidth, scale) {
  const middle = top + kBarStep / 2;
  svg.append(shortLabel(bar.label, labelWidth, middle));

  let x = labelWidth;
  for (const part of bar.parts) {
    const look = part.className ? {class: part.className} : {fill: part.colour};
    const width = part.value * scale;
    svg.append(svgElement("rect", {x, y: middle - kBarHeight / 2, width, height: kBarHeight, ...look}));
    x += width;
  }
  svg.append(svgElement("text", {x: x + 6, y: middle + 4.5}, bar.text));
}

const kStripHeight = 38, kStripStep = 50;

// strips: [{label, text, values: [{at, value}]}], one column each value, all strips of one scale; null leaves a gap.
function stripChart(title, unit, atUnit, strips) {
  const highest = Math.max(...strips.flatMap(strip => strip.values.map(({value}) => value ?? 0)));
  return chart(`${title}, up to ${percentText(highest)} ${unit}`, strips,
    (svg, width) => drawStrips(svg, width, highest || 1, unit, atUnit, strips));
}

function drawStrips(svg, width, highest, unit, atUnit, strips) {
  if (!width) return;
  const {labelWidth, textWidth} = widthsOf(strips, width);
  const plotWidth = Math.max(20, width - labelWidth - textWidth), bottom = strips.length * kStripStep;
  svg.setAttribute("viewBox", `0 0 ${width} ${bottom + kAxisHeight}`);
  svg.setAttribute("height", bottom + kAxisHeight);
  svg.replaceChildren();
  strips.forEach((strip, index) => {
    const floor = (index + 1) * kStripStep - 6, middle = floor - kStripHeight / 2, count = strip.values.length;
    svg.append(shortLabel(strip.label, labelWidth, middle),
      svgElement("line", {class: "grid", x1: labelWidth, x2: labelWidth + plotWidth, y1: floor, y2: floor}),
      svgElement("text", {x: labelWidth + plotWidth + 6, y: middle + 4.5}, strip.text));
    strip.values.forEach(({at, value}, i) => {
      const x = labelWidth + plotWidth * i / count, height = kStripHeight * (value ?? 0) / highest;
      const bar = svgElement("rect", {class: "flips", x, y: floor - height, height,
        width: Math.max(0.5, 0.85 * plotWidth / count)});
      bar.append(svgElement("title", {}, `${numberText(at)} ${atUnit}: ${percentText(value)} ${unit}`));
      svg.append(bar);
    });
  });
  const times = strips[0].values.map(({at}) => at), y = bottom + 14;
  const tick = (x, anchor, text) => svg.append(svgElement("text", {class: "tick", x, y, "text-anchor": anchor}, text));
  tick(labelWidth, "start", `${numberText(times[0])} ${atUnit}`);
  tick(labelWidth + plotWidth, "end", `${numberText(times.at(-1))} ${atUnit}`);
}
