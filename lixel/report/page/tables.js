// Tables that sort by a click on a heading; the sort is stable, and rows without a value come last both ways.

// columns: [{label, title, value: row => number or string, text: (value, row) => string (or as it is), open: row => ...}]
// A column whose values are strings is text. `open` makes a button of its cells.
function sortableTable(caption, columns, rows, isTall = false) {
  const texts = new Set(columns.filter(column => rows.some(row => typeof column.value(row) === "string")));
  const isText = column => texts.has(column);
  const body = element("tbody");
  const headings = columns.map(column => {
    const sort = () => sortBy(column);
    const button = element("button", {type: "button", title: column.title, onclick: sort}, column.label);
    return element("th", {scope: "col", "aria-sort": "none", class: isText(column) ? "text" : null}, button);
  });

  const fill = sorted => body.replaceChildren(...sorted.map(row => element("tr", {},
    ...columns.map(column => cell(column, row, isText(column))))));

  function sortBy(column) {
    const heading = headings[columns.indexOf(column)];
    // Numbers start with the largest, names with the first.
    const order = heading.getAttribute("aria-sort");
    const ascending = order === "none" ? isText(column) : order === "descending";
    for (const other of headings) other.setAttribute("aria-sort", "none");
    heading.setAttribute("aria-sort", ascending ? "ascending" : "descending");
    fill([...rows].sort((a, b) => compareValues(column.value(a), column.value(b), ascending)));
  }

  fill(rows);
  const table = element("table", {"aria-label": caption}, element("thead", {}, element("tr", {}, ...headings)), body);
  const frame = {class: isTall ? "scroll tall" : "scroll", tabindex: 0, role: "region", "aria-label": caption};
  return element("div", frame, table);
}

function cell(column, row, isText) {
  const value = column.value(row);
  const text = column.text ? column.text(value, row) : value ?? kNone;
  const content = column.open ? element("button", {type: "button", onclick: () => column.open(row)}, text) : text;
  return element("td", {class: [isText && "text", column.className].filter(Boolean).join(" ") || null}, content);
}

function compareValues(a, b, ascending) {
  const missing = value => value === null || value === undefined;
  if (missing(a) || missing(b)) return missing(a) - missing(b);
  const order = typeof a === "string" ? a.localeCompare(b, "en", {numeric: true}) : a - b;
  return ascending ? order : -order;
}
