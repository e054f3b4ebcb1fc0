// What the whole page uses: elements, and numbers as text.

// element("td", {class: "text", onclick: f}, child, "text", ...)
function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function") made.addEventListener(key.slice(2), value);
    else if (value === true) made.setAttribute(key, "");
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

const byId = id => document.getElementById(id);
const jsonOf = id => JSON.parse(byId(id).textContent);

const kNone = "–"; // where there is no number

const isNumber = value => typeof value === "number" && Number.isFinite(value);

// 1234567 as 1 234 567, with narrow spaces that do not break.
function countText(value) {
  return isNumber(value) ? String(Math.round(value)).replace(/\B(?=(\d{3})+$)/g, "\u202f") : kNone;
}

// Three decimals, so that columns align; less than they can show keeps its digits, and a plain 0 is exactly none.
function percentText(value) {
  if (!isNumber(value)) return kNone;
  if (value === 0) return "0";
  return value < 0.01 ? String(Number(value.toPrecision(2))) : value.toFixed(3);
}

function numberText(value) {
  if (!isNumber(value)) return kNone;
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1000) return countText(value);
  return size >= 0.001 ? String(Number(value.toPrecision(3))) : value.toExponential(1);
}

function bytesText(value) {
  if (!isNumber(value)) return kNone;
  for (const [unit, size] of [["GiB", 2 ** 30], ["MiB", 2 ** 20], ["KiB", 2 ** 10]])
    if (value >= size) return `${Number((value / size).toPrecision(3))} ${unit}`;
  return `${value} B`;
}

const differ = (rows, key) => new Set(rows.map(row => row[key])).size > 1;

// The mean of the numbers among the values; null when there are none.
function mean(values) {
  const numbers = values.filter(isNumber);
  return numbers.length ? numbers.reduce((sum, value) => sum + value, 0) / numbers.length : null;
}
