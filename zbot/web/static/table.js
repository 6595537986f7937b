// Tables whose cells the server changes. All content is text, never HTML.
"use strict";
zbot.table = (() => {
  // A cell is a string, or {t: text, c: classes, i: indent, h: address on this server, d: title}.
  function fill(element, cell) {
    const one = typeof cell === "string" ? { t: cell } : cell;
    let inner = element;
    if (one.h && one.h.startsWith("/") && !one.h.startsWith("//")) {
      inner = document.createElement("a");
      inner.setAttribute("href", one.h);
      element.replaceChildren(inner);
    }
    fillText(inner, one.t);
    element.className = `${element.dataset.c ?? ""} ${one.c ?? ""}`;
    element.title = one.d ?? "";
    element.style.paddingLeft = one.i ? `${10 + 16 * one.i}px` : "";
  }

  // Names and types break after `/`, after `_` and between words: Pose, With, Covariance.
  // <wbr> adds nothing to the text.
  function fillText(element, text) {
    const parts = text.match(/(?:[A-Z]+[^A-Z/_]*|[^A-Z/_]+)[/_]?|[/_]/g) ?? [];
    element.replaceChildren(...parts.flatMap((part) => [part, document.createElement("wbr")]));
  }

  function newRow(body, key, columns) {
    const row = document.createElement("tr");
    row.dataset.key = key;
    if (body.closest(".zb-choosable")) row.tabIndex = 0;
    for (const classes of columns) {
      const cell = document.createElement("td");
      cell.dataset.c = classes;
      row.append(cell);
    }
    return row;
  }

  // `order` has the keys of all rows, or null if they are unchanged. `changed` has new cells by key.
  function show(id, columns, order, changed, chosen) {
    const body = getHtmlElement(id)?.querySelector("tbody");
    if (!body) return;
    const rows = new Map([...body.children].map((row) => [row.dataset.key, row]));
    for (const key of order ?? []) {
      if (!rows.has(key)) rows.set(key, newRow(body, key, columns));
    }
    for (const [key, cells] of Object.entries(changed)) {
      const row = rows.get(key);
      cells.forEach((cell, index) => cell !== null && fill(row.children[index], cell));
    }
    if (order) arrange(body, order.map((key) => rows.get(key)));
    for (const row of body.children) row.classList.toggle("zb-chosen", row.dataset.key === chosen);
  }

  // Rows in the right place are not changed, so that selection and scroll position stay.
  function arrange(body, rows) {
    const kept = new Set(rows);
    for (const row of [...body.children]) if (!kept.has(row)) row.remove();
    rows.forEach((row, index) => {
      if (body.children[index] !== row) body.insertBefore(row, body.children[index] ?? null);
    });
  }

  // Rows can move while the user presses the button. Then the row where the button was pressed
  // counts, unless the pointer was moved, e.g. to select text.
  const MOST_PIXELS = 4;
  let pressed = null;
  document.addEventListener("pointerdown", (event) => {
    pressed = { row: rowOf(event), x: event.clientX, y: event.clientY };
  });

  function rowOf(event) {
    if (event.target.closest?.("a")) return null;
    return event.target.closest?.(".zb-choosable tbody tr");
  }

  function clickedRow(event) {
    const isByKey = event.detail === 0;
    if (isByKey || !pressed) return rowOf(event);
    const distance = Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y);
    return distance > MOST_PIXELS ? rowOf(event) : pressed.row;
  }

  document.addEventListener("click", (event) => {
    const row = clickedRow(event);
    if (!row?.isConnected) return;
    emitEvent("zbot_choose", row.closest(".zb-choosable").id, row.dataset.key);
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && event.target.matches?.(".zb-choosable tbody tr")) {
      event.target.click();
    }
  });

  return { show };
})();
