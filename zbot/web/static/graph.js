// Drawing of the graph, with smooth changes, zoom, movement and highlighting.
"use strict";
zbot.graph = (() => {
  const MOVE_MS = 350; // the same value as in graph.css
  const NARROW = 600; // CSS pixels; a narrower drawing is on a phone
  const SMALLEST = 0.75; // smallest scale on a phone, so that names can be read
  const LARGEST = 1.7; // largest scale, so that a graph of two nodes does not become huge
  const LAYERS = ["frame", "edge", "item"]; // from the lowest to the highest
  const MOST_MOVING = 300; // number of groups; larger drawings change without animation
  const MOST_PIXELS = 8000; // longer side of a PNG; all browsers can draw this size
  const drawings = new Map();

  const parse = (text) => {
    const svg = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
    if (svg.localName !== "svg") throw new Error("the drawing of the graph is not SVG");
    return document.importNode(svg, true);
  };
  const layerOf = (group) => LAYERS.find((one) => group.classList.contains(one)) ?? "item";
  const keyed = (root) => [...root.querySelectorAll("g[data-key]")];

  class Drawing {
    constructor(place) {
      this.place = place;
      this.groups = new Map();
      this.view = null; // left, top, width and height of the visible part
      this.isFitted = true; // true until the user zooms or moves the drawing
      this.chosen = "";
      this.lit = "";
      new ResizeObserver(() => this.resize()).observe(place);
      // A CSS class of the page's body shows whether the page is light or dark.
      new MutationObserver(() => this.updateTheme()).observe(document.body, { attributeFilter: ["class"] });
      this.listen();
    }

    // -- content ----------------------------------------------------------------------------

    show(text) {
      const next = parse(text);
      this.content = next.getAttribute("viewBox").split(" ").map(Number);
      if (!this.svg) this.begin(next);
      const groups = keyed(next);
      this.svg.classList.toggle("still", groups.length > MOST_MOVING);
      const empty = next.querySelector("text.empty");
      this.svg.querySelector("text.empty")?.remove();
      if (empty) this.svg.append(empty);
      const keys = new Set(groups.map((group) => group.dataset.key));
      for (const [key, group] of this.groups) {
        if (!keys.has(key)) this.leave(key, group);
      }
      for (const group of groups) this.put(group);
      this.light(keys.has(this.lit) ? this.lit : "");
      if (this.isFitted) this.fit();
    }

    begin(next) {
      this.svg = next.cloneNode(false);
      this.svg.removeAttribute("width");
      this.svg.removeAttribute("height");
      this.svg.append(next.querySelector("style"));
      this.layers = {};
      for (const name of LAYERS) {
        this.layers[name] = document.createElementNS(this.svg.namespaceURI, "g");
        this.svg.append(this.layers[name]);
      }
      this.place.replaceChildren(this.svg);
      this.updateTheme();
    }

    // A group keeps its element while its key exists, so that CSS can animate the movement.
    put(next) {
      const key = next.dataset.key;
      const group = this.groups.get(key);
      if (group?.source === next.outerHTML) return;
      next.source = next.outerHTML;
      place(next);
      if (!group) {
        next.classList.add("appearing");
        this.groups.set(key, next);
        this.layers[layerOf(next)].append(next);
        return;
      }
      const lights = [...group.classList].filter((one) => LIGHTS.includes(one));
      group.setAttribute("class", [next.getAttribute("class"), ...lights].join(" "));
      for (const { name, value } of next.attributes) {
        if (name !== "class" && name !== "style") group.setAttribute(name, value);
      }
      group.source = next.source;
      group.style.transform = next.style.transform;
      const [olds, news] = [[...group.children], [...next.children]];
      if (olds.map(kindOf).join() !== news.map(kindOf).join()) group.replaceChildren(...news);
      else news.forEach((child, index) => update(olds[index], child));
    }

    leave(key, group) {
      this.groups.delete(key);
      for (const name of Object.keys(group.dataset)) delete group.dataset[name];
      group.setAttribute("class", `${group.getAttribute("class")} leaving`);
      setTimeout(() => group.remove(), MOVE_MS);
    }

    showRates(texts) {
      for (const [key, group] of this.groups) {
        const rate = group.querySelector("text.rate");
        if (rate) rate.textContent = texts[key] ?? "";
      }
    }

    updateTheme() {
      const isDark = zbot.isDark();
      this.svg?.classList.toggle("dark", isDark);
      this.svg?.classList.toggle("light", !isDark);
    }

    // -- highlighting -----------------------------------------------------------------------

    // As in rqt_graph, the colour of an arrow shows whether it is incoming, outgoing or both.
    light(key) {
      this.lit = key;
      if (!this.svg) return;
      const ways = this.neighbours(key);
      this.svg.classList.toggle("lit", ways.size > 0);
      for (const [one, group] of this.groups) {
        group.classList.remove(...LIGHTS);
        if (ways.has(one)) group.classList.add(ways.get(one));
      }
    }

    neighbours(key) {
      const ways = new Map();
      const add = (one, way) => {
        const before = ways.get(one);
        ways.set(one, before && before !== way ? "both" : way);
      };
      const group = this.groups.get(key);
      if (!group || group.classList.contains("frame")) return ways;
      const edges = [...this.groups.values()].filter((one) => one.dataset.from);
      for (const edge of edges) {
        const { from, to, topic } = edge.dataset;
        const isBoth = edge.querySelectorAll(".head").length > 1;
        if (edge === group || (group.dataset.from && edge.querySelector("text:not(.rate)") && group.dataset.topic === topic)) {
          add(edge.dataset.key, "chosen");
          add(from, "incoming");
          add(to, "outgoing");
        } else if (from === key || to === key) {
          const way = isBoth ? "both" : from === key ? "outgoing" : "incoming";
          add(edge.dataset.key, way);
          if (from !== to) add(from === key ? to : from, way);
        }
      }
      ways.set(key, "chosen");
      return ways;
    }

    choose(key) {
      this.groups.get(this.chosen)?.classList.remove("marked");
      this.chosen = key;
      this.groups.get(key)?.classList.add("marked");
    }

    // -- visible part -----------------------------------------------------------------------

    get size() {
      return [Math.max(1, this.place.clientWidth), Math.max(1, this.place.clientHeight)];
    }

    heightOf(selector) {
      const said = this.place.parentElement.querySelector(selector)?.offsetHeight ?? 0;
      return said < this.size[1] / 3 ? said : 0;
    }

    fit() {
      this.isFitted = true;
      const [left, top, width, height] = this.content;
      const [w, h] = this.size;
      // Keep the top and the bottom of the drawing free, because texts cover these areas.
      const above = this.heightOf(".zb-graph-problems");
      const below = this.heightOf(".zb-graph-left-out");
      const room = h - above - below;
      const smallest = w < NARROW ? SMALLEST : 0;
      const scale = Math.max(Math.min(w / width, room / height, LARGEST), smallest);
      // If the drawing is too large, its left and its top are visible. The user can move it.
      const x = left + Math.min(0, (width - w / scale) / 2);
      const y = top - above / scale + Math.min(0, (height - room / scale) / 2);
      this.look([x, y, w / scale, h / scale], !this.view);
    }

    resize() {
      if (!this.svg) return;
      if (this.isFitted) {
        this.view = null;
        this.fit();
        return;
      }
      const scale = this.size[0] / this.view[2];
      this.look([this.view[0], this.view[1], this.size[0] / scale, this.size[1] / scale], true);
    }

    look(goal, isAtOnce) {
      const from = this.view ?? goal;
      const begin = performance.now();
      const isStill = isAtOnce || matchMedia("(prefers-reduced-motion: reduce)").matches;
      cancelAnimationFrame(this.turn);
      const step = (now) => {
        const part = isStill ? 1 : Math.min(1, Math.max(0, now - begin) / MOVE_MS);
        const eased = 1 - (1 - part) ** 3;
        this.view = goal.map((value, index) => from[index] + (value - from[index]) * eased);
        this.svg.setAttribute("viewBox", this.view.join(" "));
        if (part < 1) this.turn = requestAnimationFrame(step);
      };
      step(begin);
    }

    point(event) {
      const box = this.place.getBoundingClientRect();
      const scale = this.view[2] / box.width;
      return [this.view[0] + (event.clientX - box.left) * scale, this.view[1] + (event.clientY - box.top) * scale];
    }

    zoom(factor, [x, y] = [this.view[0] + this.view[2] / 2, this.view[1] + this.view[3] / 2]) {
      const least = this.content[2] / 40;
      const most = Math.max(this.content[2], this.content[3], this.size[0]) * 4;
      const by = Math.min(most / this.view[2], Math.max(least / this.view[2], factor));
      const [left, top, width, height] = this.view;
      this.isFitted = false;
      this.look([x - (x - left) * by, y - (y - top) * by, width * by, height * by], true);
    }

    listen() {
      const target = (event) => event.target.closest?.("g[data-key]")?.dataset.key ?? "";
      let held = null; // the point at which the user drags the drawing
      let hasMoved = false;
      this.place.addEventListener("wheel", (event) => {
        if (!this.svg) return;
        event.preventDefault();
        this.zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * 0.004), this.point(event));
      }, { passive: false });
      this.place.addEventListener("pointerdown", (event) => {
        if (!this.svg || event.button) return;
        [held, hasMoved] = [[event.clientX, event.clientY, ...this.view], false];
      });
      this.place.addEventListener("pointermove", (event) => {
        if (!held) return;
        const [dx, dy] = [event.clientX - held[0], event.clientY - held[1]];
        if (!hasMoved && Math.hypot(dx, dy) < 4) return;
        if (!hasMoved) this.place.setPointerCapture(event.pointerId);
        hasMoved = true;
        this.isFitted = false;
        const scale = held[4] / this.size[0];
        this.look([held[2] - dx * scale, held[3] - dy * scale, held[4], held[5]], true);
      });
      for (const name of ["pointerup", "pointercancel"]) {
        this.place.addEventListener(name, () => (held = null));
      }
      this.place.addEventListener("click", (event) => {
        if (!hasMoved) this.pick(target(event));
      });
      this.place.addEventListener("dblclick", (event) => {
        if (!target(event)) this.fit();
      });
      this.place.addEventListener("pointerover", (event) => {
        if (!held) this.light(target(event));
      });
      this.place.addEventListener("pointerleave", () => this.light(""));
      this.place.addEventListener("focusin", (event) => this.light(target(event)));
      this.place.addEventListener("focusout", () => this.light(""));
      this.place.addEventListener("keydown", (event) => this.press(event, target(event)));
    }

    press(event, key) {
      if (event.key === "Enter" && key) this.pick(key);
      else if (event.key === "Escape") this.pick("");
      else if (event.key === "+") this.zoom(0.8);
      else if (event.key === "-") this.zoom(1.25);
      else if (event.key === "0") this.fit();
      else return;
      event.preventDefault();
    }

    // A click on an arrow chooses its topic. A click on a frame chooses nothing.
    pick(key) {
      const group = this.groups.get(key);
      const isEdge = group?.classList.contains("edge");
      const shown = isEdge ? group.dataset.about : group?.classList.contains("frame") ? "" : key;
      emitEvent("zbot_choose", this.place.id, shown ?? "");
    }
  }

  const LIGHTS = ["chosen", "incoming", "outgoing", "both"];
  const kindOf = (child) => `${child.localName}.${child.getAttribute("class") ?? ""}`;

  // Sets the place of a group by CSS, because browsers do not animate SVG attributes.
  function place(group) {
    const at = /translate\(([-\d.]+),([-\d.]+)\)/.exec(group.getAttribute("transform") ?? "");
    if (at) group.style.transform = `translate(${at[1]}px, ${at[2]}px)`;
    group.removeAttribute("transform");
    for (const path of group.children) if (path.localName === "path") glide(path);
  }

  function glide(path) {
    path.style.setProperty("d", `path("${path.getAttribute("d")}")`);
  }

  function update(old, next) {
    for (const { name, value } of next.attributes) {
      if (name !== "style" && old.getAttribute(name) !== value) old.setAttribute(name, value);
    }
    if (old.localName === "path") glide(old);
    else if (old.innerHTML !== next.innerHTML) old.replaceChildren(...next.childNodes);
  }

  function drawingAt(id) {
    const place = document.getElementById(id);
    if (place && !drawings.has(id)) drawings.set(id, new Drawing(place));
    return drawings.get(id);
  }

  function savePng(name, text) {
    const svg = parse(text);
    svg.classList.add(zbot.isDark() ? "dark" : "light");
    const [width, height] = [Number(svg.getAttribute("width")), Number(svg.getAttribute("height"))];
    const scale = Math.min(2, MOST_PIXELS / Math.max(width, height));
    const image = new Image();
    image.onload = () => {
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [Math.round(width * scale), Math.round(height * scale)];
      canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
      canvas.toBlob((blob) => zbot.save(name, blob, "image/png"), "image/png");
    };
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg.outerHTML)}`;
  }

  return {
    show(id, text, chosen) {
      const drawing = drawingAt(id);
      drawing?.show(text);
      drawing?.choose(chosen);
    },
    showRates: (id, texts) => drawingAt(id)?.showRates(texts),
    choose: (id, key) => drawingAt(id)?.choose(key),
    fit: (id) => drawingAt(id)?.fit(),
    savePng,
  };
})();
