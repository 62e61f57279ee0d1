"use strict";

/* Columns sort by a click on their head; numbers by their full value. */
for (const head of document.querySelectorAll("thead th")) {
  head.addEventListener("click", () => {
    const place = head.cellIndex;
    const body = head.closest("table").tBodies[0];
    const direction = head.dataset.sorted === "up" ? -1 : 1;
    head.dataset.sorted = direction > 0 ? "up" : "down";
    const value = (row) => {
      const cell = row.cells[place];
      const data = cell.querySelector("data");
      const number = data ? Number(data.value) : Number.parseFloat(cell.textContent);
      return Number.isNaN(number) ? cell.textContent : number;
    };
    const compare = (a, b) =>
      typeof a === "number" && typeof b === "number" ? a - b : String(a).localeCompare(String(b));
    const rows = [...body.rows].sort((a, b) => direction * compare(value(a), value(b)));
    body.append(...rows);
  });
}
