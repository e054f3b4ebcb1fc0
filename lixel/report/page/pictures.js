// The pictures of the report as canvases. A picture is stored whole, or as what differs from another one ("over").

const pictureCache = new Map(); // id -> promise of a canvas; only of the view that is shown

function forgetPictures() { pictureCache.clear(); }

// Null when the report has no such picture.
function picture(row, kind) {
  return pictureOf(`picture-${row.index}-${kind}`);
}

function pictureOf(id) {
  if (!pictureCache.has(id)) pictureCache.set(id, decodePicture(id));
  return pictureCache.get(id);
}

async function decodePicture(id) {
  const source = byId(id);
  if (!source) return null;
  const image = new Image();
  image.src = "data:image/png;base64," + source.textContent;
  await image.decode();
  const canvas = element("canvas", {width: image.naturalWidth, height: image.naturalHeight});
  const context = canvas.getContext("2d");
  if (source.dataset.over) context.drawImage(await pictureOf(source.dataset.over), 0, 0);
  context.drawImage(image, 0, 0);
  return canvas;
}

const kMapOpacity = 0.8; // enough of the scene shows through to know where one is

// Draws a row's layers into a canvas, pixel by pixel; the page scales it.
async function drawLayers(canvas, row, layers) {
  const wanted = canvas.wanted = {};
  const [shaded, map, error, boundary] = await Promise.all([
    picture(row, "shaded"),
    layers.footprint ? picture(row, "footprint") : layers.density ? picture(row, "density") : null,
    layers.error ? picture(row, "error") : null,
    layers.boundary ? picture(row, "boundary") : null,
  ]);
  if (!shaded || canvas.wanted !== wanted) return; // or something newer is wanted by now
  canvas.width = shaded.width;
  canvas.height = shaded.height;
  const context = canvas.getContext("2d");
  context.drawImage(shaded, 0, 0);
  if (map) {
    context.globalAlpha = kMapOpacity;
    context.drawImage(map, 0, 0);
    context.globalAlpha = 1;
  }
  if (error) context.drawImage(error, 0, 0);
  if (boundary) context.drawImage(boundary, 0, 0);
}
