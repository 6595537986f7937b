// Table of log lines. New lines go to its end, and old lines are removed. It never contains HTML.
"use strict";
window.zbotConsole = (() => {
  function cell(row, text, classes) {
    const element = row.insertCell();
    element.textContent = text;
    element.className = classes;
  }

  function add(lines, isReset, most) {
    const table = document.querySelector(".zb-log");
    if (!table) return;
    const box = table.parentElement;
    const isAtEnd = box.scrollHeight - box.scrollTop - box.clientHeight < 40;
    const body = table.tBodies[0] ?? table.createTBody();
    if (isReset) body.replaceChildren();
    for (const [time, level, name, text, place, classes] of lines) {
      const row = body.insertRow();
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

  return { add };
})();
