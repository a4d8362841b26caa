// Behaviour of report.html and run.html beyond plain pages: tables can be sorted and filtered, and details are
// open on paper. Without it everything is still to be read.
"use strict";

// A cell is sorted by the number that it was made from, where it has one, else by its text.
function keyOf(row, column) {
  const cell = row.cells[column];
  if (!cell) return "";
  return cell.dataset.sort === undefined ? cell.textContent.trim() : Number(cell.dataset.sort);
}

function compare(a, b) {
  if (typeof a === "number" && typeof b === "number") return a - b;
  if (typeof a !== typeof b) return typeof a === "number" ? -1 : 1;
  return a.localeCompare(b, "en", { numeric: true });
}

function sortBy(table, column) {
  const header = table.tHead.rows[0].cells[column];
  const direction = header.getAttribute("aria-sort") === "ascending" ? -1 : 1;
  for (const cell of table.tHead.rows[0].cells) cell.removeAttribute("aria-sort");
  header.setAttribute("aria-sort", direction === 1 ? "ascending" : "descending");
  const keyed = Array.from(table.tBodies[0].rows, row => [keyOf(row, column), row]);
  // A cell without a number stands last in either direction.
  keyed.sort(([a], [b]) => typeof a === typeof b ? direction * compare(a, b) : compare(a, b));
  table.tBodies[0].append(...keyed.map(([, row]) => row));
}

function makeSortable(table) {
  Array.from(table.tHead.rows[0].cells).forEach((header, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...header.childNodes);
    button.addEventListener("click", () => sortBy(table, column));
    header.append(button);
  });
}

function makeFilterable(table) {
  const label = document.createElement("label");
  label.className = "filter";
  const input = document.createElement("input");
  input.type = "search";
  label.append("Only rows with these words: ", input);
  const rows = Array.from(table.tBodies[0].rows, row => [row.textContent.toLowerCase(), row]);
  input.addEventListener("input", () => {
    const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const [text, row] of rows) row.hidden = !words.every(word => text.includes(word));
  });
  table.closest(".scroll").before(label);
}

for (const table of document.querySelectorAll("table.sortable")) {
  if (table.tBodies[0].rows.length > 1) makeSortable(table);
  if (table.classList.contains("long")) makeFilterable(table);
}

// A link to something within details opens them.
function openTarget() {
  const target = location.hash.length > 1 && document.getElementById(decodeURIComponent(location.hash.slice(1)));
  for (let node = target; node; node = node.parentElement) if (node.tagName === "DETAILS") node.open = true;
  if (target) target.scrollIntoView();
}
addEventListener("hashchange", openTarget);
openTarget();

// On paper nothing can be opened. What is there to look something up, page after page, stays closed.
const onPaper = () => document.querySelectorAll("details:not(.not-on-paper):not([open])");
let opened = [];
addEventListener("beforeprint", () => { opened = Array.from(onPaper()); for (const each of opened) each.open = true; });
addEventListener("afterprint", () => { for (const each of opened) each.open = false; });
