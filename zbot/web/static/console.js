// Table of log lines, sorted by time. Old lines are removed. It never contains HTML.
"use strict";
window.zbotConsole = (() => {
  function cell(row, text, classes) {
    const element = row.insertCell();
    element.textContent = text;
    element.className = classes;
  }

  // Inserts a row by its time, because a node that was discovered late sends older lines. The
  // search for the place begins at the newest line.
  function newRow(body, stamp) {
    let next = null;
    for (let row = body.lastElementChild; row?.stamp > stamp; row = row.previousElementSibling) next = row;
    const row = body.insertBefore(document.createElement("tr"), next);
    row.stamp = stamp;
    return row;
  }

  function add(lines, isReset, most) {
    const table = document.querySelector(".zb-log");
    if (!table) return;
    const box = table.parentElement;
    const isAtEnd = box.scrollHeight - box.scrollTop - box.clientHeight < 40;
    const body = table.tBodies[0] ?? table.createTBody();
    if (isReset) body.replaceChildren();
    for (const [time, level, name, text, place, classes, stamp] of lines) {
      const row = newRow(body, stamp);
      row.title = place;
      cell(row, time, "zb-mono zb-muted zb-log-time");
      cell(row, level, `zb-mono zb-log-kind ${classes}`);
      cell(row, name, "zb-mono zb-muted zb-log-name");
      cell(row, text, `zb-mono zb-wrap zb-log-text ${classes}`);
    }
    while (body.rows.length > most) body.deleteRow(0);
    // If the user has scrolled up, the view does not move.
    if (isAtEnd || isReset) box.scrollTop = box.scrollHeight;
  }

  // A phone cuts a line at its edge. A touch shows all of the line.
  document.addEventListener("click", (event) => {
    event.target.closest?.(".zb-log tr")?.classList.toggle("zb-open");
  });

  return { add };
})();
