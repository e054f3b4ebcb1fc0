// The pictures of one view and light: two over each other, and all beside each other.

const shown = {group: [], left: null, right: null};
let openView = () => {}; // shows a row's picture, where there are pictures

function startPictures() {
  const withPictures = groups.filter(rows => rows.some(row => row.pictures?.shaded));
  if (!withPictures.length) {
    byId("pictures").hidden = true;
    return;
  }
  byId("group").append(...withPictures.map(rows => new Option(groupName(rows[0]))));
  byId("group-field").hidden = withPictures.length < 2;
  byId("boundary-field").hidden = !measured.some(row => row.pictures?.boundary);
  byId("group").addEventListener("change", () => showGroup(withPictures[byId("group").selectedIndex]));
  for (const [id, step] of [["group-back", -1], ["group-on", 1]])
    byId(id).addEventListener("click", () => {
      const count = withPictures.length;
      byId("group").selectedIndex = (byId("group").selectedIndex + step + count) % count;
      showGroup(withPictures[byId("group").selectedIndex]);
    });
  byId("left").addEventListener("change", () => showPair(shown.group[byId("left").value], shown.right));
  byId("right").addEventListener("change", () => showPair(shown.left, shown.group[byId("right").value]));
  byId("swap").addEventListener("click", () => showPair(shown.right, shown.left));
  for (const [id, other] of [["show-footprint", "show-density"], ["show-density", "show-footprint"]])
    byId(id).addEventListener("change", () => byId(other).checked = false); // one would hide the other
  for (const id of ["show-error", "show-footprint", "show-density", "show-boundary"])
    byId(id).addEventListener("change", redraw);
  startViewer();
  showGroup(withPictures[0]);
  openView = row => {
    byId("group").selectedIndex = withPictures.findIndex(rows => rows.includes(row));
    showGroup(withPictures[byId("group").selectedIndex]);
    if (row.pictures?.shaded) showPair(shown.left, row);
    byId("pictures").scrollIntoView();
  };
}

// The same two techniques stay in view when the group changes.
function showGroup(rows) {
  forgetPictures();
  const same = wanted => shown.group.find(row => wanted && nameOf(row) === nameOf(wanted));
  const [left, right] = [shown.left, shown.right];
  shown.group = rows.filter(row => row.pictures?.shaded).sort(byError);
  const options = () => shown.group.map((row, index) => new Option(nameOf(row), index));
  byId("left").replaceChildren(...options());
  byId("right").replaceChildren(...options());
  const [width, height] = rows[0].size.split("x").map(Number);
  byId("pictures").style.setProperty("--aspect", width / height);
  document.querySelector(".viewer").classList.toggle("beside", width < 1.3 * height);
  byId("stage").style.aspectRatio = `${width} / ${height}`;
  for (const tile of byId("tiles").children) forgetFrame(tile.querySelector(".frame"));
  const tiled = [...shown.group, ...rows.filter(row => row.refused)];
  byId("tiles").replaceChildren(...tiled.map(row => makeTile(row, width / height)));
  const first = shown.group[0], last = shown.group.findLast(row => row.executor === first.executor);
  showPair(same(left) ?? first, same(right) ?? last); // to begin with, the truth and the most wrong
  redraw();
}

function showPair(left, right) {
  shown.left = left;
  shown.right = right;
  byId("left").value = shown.group.indexOf(left);
  byId("right").value = shown.group.indexOf(right);
  byId("tag-left").textContent = `${percentText(left.misclassified_percent)} % ${nameOf(left)}`;
  byId("tag-right").textContent = `${percentText(right.misclassified_percent)} % ${nameOf(right)}`;
  for (const tile of byId("tiles").children)
    for (const button of tile.querySelectorAll(".put button"))
      button.setAttribute("aria-pressed", tile.row === shown[button.dataset.side]);
  drawPanes([[byId("pane-left"), left], [byId("pane-right"), right]]);
}

function redraw() {
  const layers = layersShown();
  const end = 2 ** colours.density_octaves;
  byId("legend").replaceChildren(...(layers.error ? [errorKeys()] : []),
    ...(layers.footprint ? [densityRamp(`${end}`, `1/${end} pixels a lixel`)] : []),
    ...(layers.density ? [densityRamp(`1/${end}`, `${end} lixels a pixel`)] : []),
    ...(layers.boundary ? [colourKey("shadow boundary seen", colours.boundary)] : []));
  const tiles = [...byId("tiles").children].filter(tile => !tile.row.refused);
  return drawPanes([[byId("pane-left"), shown.left], [byId("pane-right"), shown.right],
    ...tiles.map(tile => [tile.querySelector(".pane"), tile.row])]);
}

function layersShown() {
  return {
    error: byId("show-error").checked, footprint: byId("show-footprint").checked,
    density: byId("show-density").checked, boundary: byId("show-boundary").checked,
  };
}

async function drawPanes(panes) {
  const layers = layersShown();
  await Promise.all(panes.map(([pane, row]) => drawLayers(pane.querySelector("canvas"), row, layers)));
  showZoom();
}

// From lixels too few to lixels more than enough.
function densityRamp(few, many) {
  const ramp = element("span", {class: "ramp"}, ...colours.density.map(colour => {
    const part = element("i");
    part.style.background = colour;
    return part;
  }));
  return element("span", {class: "key"}, few, ramp, many);
}

function makeTile(row, aspect) {
  const frame = element("div", {class: "frame"}, row.refused
    ? element("div", {class: "none"}, `refused: ${row.refused.reason}`)
    : element("div", {class: "pane"}, element("canvas")));
  frame.style.aspectRatio = aspect;
  const put = (side, label) => element("button", {
    type: "button", "data-side": side, "aria-label": `Show ${nameOf(row)} on the ${side}`,
    onclick: () => side === "left" ? showPair(row, shown.right) : showPair(shown.left, row),
  }, label);
  const buttons = row.refused ? "" : element("span", {class: "put"}, put("left", "Left"), put("right", "Right"));
  const tile = element("figure", {class: "tile"}, frame, element("figcaption", {},
    element("strong", {title: row.technique_full}, nameOf(row)), buttons,
    ...figuresOf(row).map(line => element("span", {class: "figures"}, line))));
  tile.row = row;
  if (!row.refused) makeMovable(frame);
  return tile;
}

function figuresOf(row) {
  if (row.refused) return [row.refused.message];
  const passes = row.timing.passes.map(pass => `${pass.name} ${numberText(pass.ms)} ms`);
  return [
    `${percentText(row.misclassified_percent)} % misclassified: ${countText(row.false_shadow)} false shadow, `
      + `${countText(row.false_lit)} false lit`,
    ...(row.temporal ? [`${percentText(row.temporal.flips_percent)} % flips, picture of the frame in the middle`] : []),
    ...(passes.length ? [passes.join(", ")] : []),
  ];
}
