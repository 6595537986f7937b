// Scene of turtlesim, with lines on a canvas and turtles as SVG above it.
"use strict";
window.zbotTurtle = (() => {
  const SIDE = 500; // pixels
  const METRE = 45; // pixels
  const SVG = "http://www.w3.org/2000/svg";
  const KEYS = new Set(["ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight", ..."gbvcdertf"]);
  let canvas, context, overlay;
  let chosen = "";
  let turtles = new Map();
  // Pictures are drawn one after the other, because the decoding of an image takes time, and later
  // lines must be above the image.
  let work = Promise.resolve();

  function start() {
    canvas = document.querySelector(".zb-sheet");
    overlay = document.querySelector(".zb-turtles");
    const scale = window.devicePixelRatio || 1;
    canvas.width = canvas.height = Math.round(SIDE * scale);
    context = canvas.getContext("2d");
    context.scale(canvas.width / SIDE, canvas.height / SIDE);
    context.lineCap = "round";
  }

  function show(picture) {
    work = work.then(() => draw(picture)).catch((error) => console.error(error));
  }

  async function draw(picture) {
    if (!canvas?.isConnected) start();
    canvas.parentElement.style.backgroundColor = `rgb(${picture.background.join()})`;
    if (picture.sheet) await drawSheet(picture.sheet);
    drawLines(picture.lines, picture.pens);
    drawTurtles(picture.turtles);
  }

  async function drawSheet(file) {
    const image = new Image();
    image.src = `data:image/png;base64,${file}`;
    await image.decode();
    context.clearRect(0, 0, SIDE, SIDE);
    context.drawImage(image, 0, 0, SIDE, SIDE);
  }

  function drawLines(lines, pens) {
    for (let index = 0; index * 4 < lines.length; index++) {
      const [x0, y0, x1, y1] = lines.slice(index * 4, index * 4 + 4);
      const [r, g, b, width] = pens.slice(index * 4, index * 4 + 4);
      context.strokeStyle = `rgb(${r},${g},${b})`;
      context.lineWidth = width;
      context.beginPath();
      context.moveTo(x0, y0);
      context.lineTo(x1, y1);
      context.stroke();
    }
  }

  function drawTurtles(present) {
    const names = new Set(present.map(([name]) => name));
    for (const [name, turtle] of turtles) {
      if (names.has(name) && turtle.isConnected) continue;
      turtle.remove();
      turtles.delete(name);
    }
    for (const [name, x, y, theta] of present) {
      if (!turtles.has(name)) turtles.set(name, hatch(name));
      const turtle = turtles.get(name);
      const degrees = (-theta * 180) / Math.PI;
      turtle.setAttribute("transform", `translate(${x * METRE} ${SIDE - 1 - y * METRE})`);
      turtle.firstChild.setAttribute("transform", `rotate(${degrees})`);
    }
  }

  function part(kind, attributes, parent) {
    const element = document.createElementNS(SVG, kind);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    parent.append(element);
    return element;
  }

  // A name has the same colour on every machine.
  function hue(name) {
    let sum = 0;
    for (const letter of name) sum = (sum * 31 + letter.codePointAt(0)) % 360;
    return (sum * 47 + 95) % 360;
  }

  // Returns a new turtle, which looks to the right and is 45 pixels long.
  function hatch(name) {
    const turtle = part("g", { class: "zb-turtle", "data-turtle": name, tabindex: 0 }, overlay);
    turtle.setAttribute("role", "button");
    turtle.setAttribute("aria-label", name);
    const body = part("g", {}, turtle);
    const shell = `hsl(${hue(name)} 52% 42%)`;
    const plate = `hsl(${hue(name)} 48% 56%)`;
    const skin = `hsl(${hue(name)} 42% 70%)`;
    const edge = { stroke: `hsl(${hue(name)} 55% 20%)`, "stroke-width": 1.1 };
    for (const [x, y, turn] of [[9, -13, -35], [9, 13, 35], [-11, -12, 215], [-11, 12, 145]]) {
      const at = `translate(${x} ${y}) rotate(${turn})`;
      part("ellipse", { rx: 7, ry: 3.6, transform: at, fill: skin, ...edge }, body);
    }
    part("path", { d: "M-15 -2.5 L-22.5 0 L-15 2.5 Z", fill: skin, ...edge }, body);
    part("ellipse", { cx: 17.5, rx: 5.6, ry: 5, fill: skin, ...edge }, body);
    part("circle", { cx: 20, cy: -2.1, r: 1, fill: "#16201a" }, body);
    part("circle", { cx: 20, cy: 2.1, r: 1, fill: "#16201a" }, body);
    part("ellipse", { rx: 15.5, ry: 13, fill: shell, ...edge }, body);
    part("path", { d: "M-5 -6 L4 -6 L8 0 L4 6 L-5 6 L-9 0 Z", fill: plate, ...edge }, body);
    const seams = "M4 -6 L7 -11.5 M-5 -6 L-8 -11 M4 6 L7 11.5 M-5 6 L-8 11 M8 0 L15.5 0 M-9 0 L-15.5 0";
    part("path", { d: seams, fill: "none", ...edge }, body);
    part("circle", { class: "zb-ring", r: 28 }, turtle);
    part("text", { y: 42, class: "zb-turtle-name" }, turtle).textContent = name;
    part("title", {}, turtle).textContent = name;
    turtle.addEventListener("click", () => emitEvent("zbot_turtle", name));
    turtle.classList.toggle("zb-chosen", name === chosen);
    return turtle;
  }

  function choose(name) {
    chosen = name;
    for (const [other, turtle] of turtles) turtle.classList.toggle("zb-chosen", other === name);
  }

  function isTyping(target) {
    return target.closest("input, textarea, select, [contenteditable], .q-menu, .q-dialog");
  }

  document.addEventListener("keydown", (event) => {
    if (!document.querySelector(".zb-stage") || !KEYS.has(event.key)) return;
    if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target)) return;
    event.preventDefault(); // arrows would scroll the page
    emitEvent("zbot_turtle_key", event.key);
  });

  return { choose, show };
})();
