// A paper's experiment run again: its numbers and tables beside ours, and its figures.

const experiment = run.reproduction;

function showReproduction() {
  byId("experiment").hidden = !experiment;
  if (!experiment) return;
  byId("experiment-title").textContent = experiment.name;
  byId("experiment-paper").textContent = experiment.paper;
  byId("experiment-question").textContent = experiment.question;
  byId("parameters").replaceChildren(...Object.entries(experiment.parameters).flatMap(([name, value]) =>
    [element("dt", {}, name), element("dd", {}, value)]));
  const numbers = [...experiment.numbers, ...experiment.timing.numbers];
  byId("numbers-table").replaceChildren(element("h3", {}, "Numbers"), sortableTable("Numbers of the experiment", [
    column("Number", "key"), column("Ours", "ours", numberText),
    ...(numbers.some(number => number.papers !== null) ? [column("Paper", "papers", numberText)] : []),
    column("Unit", "unit"), {...column("In the paper", "source"), className: "message"},
  ], numbers, true));
  const claims = [...experiment.claims, ...experiment.timing.claims];
  byId("claims-table").replaceChildren(...claims.length ? [element("h3", {}, "What the paper says"), sortableTable("What the paper says", [
    {...column("The paper", "sentence"), className: "message"}, column("Where", "source"),
    {...column("Measured", "measured"), className: "message"}, column("Holds", "holds", holdsText),
  ], claims, true)] : []);
  byId("reproduced-tables").replaceChildren(...experiment.tables.flatMap(makeTable));
  byId("reproduced-charts").replaceChildren(...[...experiment.charts, ...experiment.timing.charts].map(makeCurves));
  byId("figures").replaceChildren(...experiment.figures.map(makeFigure), ...experiment.plates.map(makePlates));
}

const holdsText = holds => holds === null ? "not decided by this quick run" : holds ? "yes" : "no";

const signedText = value => `${value < 0 ? "\u2212" : "+"}${Math.abs(value).toFixed(1)}\u00a0%`;

// The first column as it is, the others as percent more than it; the paper's in parentheses.
function tableCellText({ours, papers, percent_more, papers_percent_more}, isFirst) {
  const text = (value, more) => isFirst ? numberText(value) : isNumber(more) ? signedText(more) : numberText(value);
  return text(ours, percent_more) + (isNumber(papers) ? ` (${text(papers, papers_percent_more)})` : "");
}

function makeTable({title, unit, source, columns, rows}) {
  const methods = columns.map((method, index) => ({
    ...column(method.title, row => row.cells[index].ours),
    text: (value, row) => tableCellText(row.cells[index], index === 0),
    title: method.technique,
  }));
  return [
    element("h3", {}, title),
    element("p", {class: "note"}, `${unit}; then percent more than ${columns[0].title}; in parentheses the paper's, ${source}.`),
    sortableTable(title, [column("Summed over", "title"), ...methods], rows),
  ];
}

function makeCurves({title, x_label, unit, lines}) {
  const made = logPlot(`${title}, ${unit}`, lines.map(({label, points}, index) => ({label, ...lineLook(index),
    points: points.map(([x, y]) => ({x, y, title: `${label}, ${numberText(x)} ${x_label}: ${numberText(y)} ${unit}`}))})),
    {xLabel: x_label, xTicks: ticksAt(lines.flatMap(line => line.points.map(([x]) => x)))});
  made.append(element("div", {class: "legend"}, ...lines.map(({label}, index) => lineKey(label, lineLook(index)))));
  return made;
}

function makeFigure(figure) {
  const rows = figure.techniques.map(technique => run.results.find(row => row.technique === technique
    && ["scene", "view", "light"].every(key => row[key] === figure[key]))).filter(row => row?.pictures?.shaded);
  const made = element("figure", {class: "figure"}, element("figcaption", {}, figure.title,
    element("button", {type: "button", onclick: () => openView(rows.at(-1))}, "Compare")));
  const panels = element("div", {class: "panels"}, ...rows.map(row => makePanel(row, figure)));
  made.append(panels);
  return made;
}

// Maps, and what they are made from: lixel by lixel.
function makePlates({title, plates}, row) {
  return element("figure", {class: "figure"}, element("figcaption", {}, title),
    element("div", {class: "panels"}, ...plates.map((plate, column) => {
      const made = element("div", {class: "plate"}, element("strong", {}, plate.title));
      pictureOf(`plate-${row}-${column}`).then(canvas => canvas && made.append(canvas));
      return made;
    })));
}

// The picture with a frame around what is enlarged below it.
function makePanel(row, {layer, enlarged: {left, top, side}}) {
  const whole = element("canvas"), enlarged = element("canvas", {width: side, height: side, class: "enlarged"});
  drawLayers(whole, row, {[layer]: true}).then(() => {
    enlarged.getContext("2d").drawImage(whole, left, top, side, side, 0, 0, side, side);
    const context = whole.getContext("2d");
    context.lineWidth = Math.max(2, whole.width / 200);
    context.strokeStyle = "#fff";
    context.strokeRect(left, top, side, side);
  });
  return element("div", {class: "panel"}, element("strong", {title: row.technique_full}, row.technique), whole, enlarged,
    element("span", {class: "figures"}, `${percentText(row.misclassified_percent)} % misclassified`));
}
