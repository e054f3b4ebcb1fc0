// Zoom and place, common to all pictures of the page, and the ways to change them.
// A picture of its frame's size is moved by x and y, in frames, and enlarged by `scale`: 1 fills the frame.

const kMaxZoom = 64;
const zoom = {scale: 1, x: 0, y: 0};
const frames = new Set(); // elements with .pane canvas inside

function showZoom() {
  for (const frame of frames) {
    frame.classList.toggle("zoomed", zoom.scale > 1);
    for (const canvas of frame.querySelectorAll(".pane canvas")) {
      canvas.style.transform = `translate(${zoom.x * 100}%, ${zoom.y * 100}%) scale(${zoom.scale})`;
      const devicePixels = frame.clientWidth * zoom.scale * window.devicePixelRatio;
      frame.classList.toggle("magnified", devicePixels > canvas.width);
    }
  }
  byId("zoom-text").value = `${Number(zoom.scale.toPrecision(2))}×`;
  byId("zoom-in").disabled = zoom.scale >= kMaxZoom;
  byId("zoom-out").disabled = byId("zoom-fit").disabled = zoom.scale <= 1;
}

// Nothing but picture in the frame.
function moveTo(x, y) {
  zoom.x = Math.min(0, Math.max(1 - zoom.scale, x));
  zoom.y = Math.min(0, Math.max(1 - zoom.scale, y));
  showZoom();
}

const moveBy = (dx, dy) => moveTo(zoom.x + dx, zoom.y + dy);

// What is at (atX, atY), in frames from the top left, stays there.
function zoomBy(factor, atX = 0.5, atY = 0.5) {
  const before = zoom.scale;
  zoom.scale = Math.min(kMaxZoom, Math.max(1, before * factor));
  if (zoom.scale < 1.01) zoom.scale = 1;
  const grown = zoom.scale / before;
  moveTo(atX - (atX - zoom.x) * grown, atY - (atY - zoom.y) * grown);
}

function fitPictures() {
  zoom.scale = 1;
  moveTo(0, 0);
}

function placeIn(frame, event) {
  const box = frame.getBoundingClientRect();
  return {x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height};
}

function forgetFrame(frame) { frames.delete(frame); }

function makeMovable(frame) {
  frames.add(frame);
  const pointers = new Map(); // id -> last place in the frame

  frame.addEventListener("wheel", event => {
    if (zoom.scale === 1 && event.deltaY > 0) return; // nothing to zoom out of: the page scrolls
    event.preventDefault();
    const at = placeIn(frame, event);
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    zoomBy(2 ** (-event.deltaY * lines / 240), at.x, at.y);
  }, {passive: false});

  frame.addEventListener("pointerdown", event => {
    if (event.button !== 0 || event.target.closest("button, .divider")) return;
    pointers.set(event.pointerId, placeIn(frame, event));
    frame.setPointerCapture(event.pointerId);
    frame.classList.add("dragging");
  });
  frame.addEventListener("pointermove", event => {
    if (!pointers.has(event.pointerId)) return;
    const before = [...pointers.values()];
    pointers.set(event.pointerId, placeIn(frame, event));
    followPointers(before, [...pointers.values()]);
  });
  for (const name of ["pointerup", "pointercancel"])
    frame.addEventListener(name, event => {
      pointers.delete(event.pointerId);
      if (!pointers.size) frame.classList.remove("dragging");
    });
}

// One pointer drags; two also zoom by their distance, about their middle.
function followPointers(before, after) {
  const middle = points => ({x: mean(points.map(p => p.x)), y: mean(points.map(p => p.y))});
  const from = middle(before), to = middle(after);
  moveBy(to.x - from.x, to.y - from.y);
  if (before.length !== 2) return;
  const distance = ([a, b]) => Math.max(1e-3, Math.hypot(a.x - b.x, a.y - b.y));
  zoomBy(distance(after) / distance(before), to.x, to.y);
}

// The divider: what is left of it shows the left picture.
function setSplit(percent) {
  const kept = Math.min(100, Math.max(0, percent));
  byId("split").value = kept;
  byId("divider").style.left = `${kept}%`;
  byId("pane-right").style.clipPath = `inset(0 0 0 ${kept}%)`;
}

function makeDividerMovable() {
  const divider = byId("divider"), stage = byId("stage"), split = byId("split");
  split.addEventListener("input", () => setSplit(Number(split.value)));
  divider.addEventListener("pointerdown", event => divider.setPointerCapture(event.pointerId));
  divider.addEventListener("pointermove", event => {
    if (divider.hasPointerCapture(event.pointerId)) setSplit(100 * placeIn(stage, event).x);
  });
  setSplit(50);
}

function moveByKeys(event) {
  const step = 0.1;
  const moves = {
    "+": () => zoomBy(1.5), "=": () => zoomBy(1.5), "-": () => zoomBy(1 / 1.5), "0": fitPictures,
    ArrowLeft: () => moveBy(step, 0), ArrowRight: () => moveBy(-step, 0),
    ArrowUp: () => moveBy(0, step), ArrowDown: () => moveBy(0, -step),
    PageUp: () => setSplit(Number(byId("split").value) - 5), PageDown: () => setSplit(Number(byId("split").value) + 5),
  };
  if (!moves[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  moves[event.key]();
}

function startViewer() {
  makeMovable(byId("stage"));
  makeDividerMovable();
  byId("stage").addEventListener("keydown", moveByKeys);
  byId("zoom-in").addEventListener("click", () => zoomBy(1.5));
  byId("zoom-out").addEventListener("click", () => zoomBy(1 / 1.5));
  byId("zoom-fit").addEventListener("click", fitPictures);
  new ResizeObserver(showZoom).observe(byId("stage"));
  showZoom();
}
