// Pictures of topics, which are camera images, or laser scans from above.
"use strict";
(() => {
  zbot.showPicture = (id, address) => {
    const image = getHtmlElement(id);
    if (image && /^data:image\/(png|jpeg|webp|bmp|gif);base64,/.test(address)) image.src = address;
  };

  const SVG = "http://www.w3.org/2000/svg";
  const HALF = 100;

  function shape(parent, name, attributes) {
    const made = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    parent.append(made);
    return made;
  }

  // The sensor's x axis points up, and its y axis points to the left.
  zbot.showScan = (id, points, reach, ring) => {
    const place = getHtmlElement(id);
    if (!place) return;
    const scale = (HALF * 0.96) / reach;
    const drawing = document.createElementNS(SVG, "svg");
    drawing.setAttribute("viewBox", `${-HALF} ${-HALF} ${2 * HALF} ${2 * HALF}`);
    for (let radius = ring; radius <= reach * 1.001; radius += ring) {
      shape(drawing, "circle", { r: radius * scale, class: "zb-scan-ring" });
    }
    shape(drawing, "path", { d: `M0 ${-HALF}V${HALF}M${-HALF} 0H${HALF}`, class: "zb-scan-ring" });
    let hits = "";
    for (let at = 0; at < points.length; at += 2) {
      hits += `M${(-points[at + 1] * scale).toFixed(1)} ${(-points[at] * scale).toFixed(1)}h0`;
    }
    shape(drawing, "path", { d: hits, class: "zb-scan-hit" });
    shape(drawing, "path", { d: "M0 -5L3.6 4L0 2.2L-3.6 4Z", class: "zb-scan-sensor" });
    place.replaceChildren(drawing);
  };
})();
