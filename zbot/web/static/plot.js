// Curves of a plot. The browser keeps their points, and the server sends only new ones.
"use strict";
zbot.plot = (() => {
  const MOST_POINTS = 200_000; // for each curve, e.g. half an hour of 100 Hz
  const COLOURS = 6;
  const plots = new Map();

  function colour(name) {
    return getComputedStyle(document.body).getPropertyValue(name).trim();
  }

  function start(id, windowS) {
    plots.set(id, { names: [], curves: new Map(), windowS, paused: false, nowS: 0, startS: null,
      right: [], over: "" });
    draw(id);
  }

  // The browser loads ECharts a little later than the page.
  function chartOf(id) {
    const chart = getElement(id)?.chart;
    return chart && !chart.isDisposed() ? chart : null;
  }

  function setCurves(id, names) {
    const plot = plots.get(id);
    for (const name of names) {
      if (!plot.curves.has(name)) plot.curves.set(name, { times: [], values: [] });
    }
    for (const name of [...plot.curves.keys()]) if (!names.includes(name)) plot.curves.delete(name);
    plot.names = names;
    plot.isNew = true;
    draw(id);
  }

  function add(id, points, nowS) {
    const plot = plots.get(id);
    plot.startS ??= nowS;
    for (const [name, flat] of Object.entries(points)) {
      const curve = plot.curves.get(name);
      if (!curve) continue;
      for (let at = 0; at < flat.length; at += 2) {
        curve.times.push(flat[at]);
        curve.values.push(flat[at + 1]);
      }
      if (curve.times.length > MOST_POINTS * 1.1) {
        curve.times.splice(0, curve.times.length - MOST_POINTS);
        curve.values.splice(0, curve.values.length - MOST_POINTS);
      }
    }
    plot.nowS = nowS;
    if (!plot.paused) draw(id);
  }

  function setWindow(id, windowS) {
    plots.get(id).windowS = windowS;
    draw(id);
  }

  // The curves with these names use the axis on the right. `over` is the name of the
  // curve on the x axis, or empty if the x axis is the time.
  function setAxes(id, right, over) {
    Object.assign(plots.get(id), { right, over, isNew: true });
    draw(id);
  }

  function setPaused(id, paused) {
    plots.get(id).paused = paused;
    draw(id);
  }

  function clear(id) {
    const plot = plots.get(id);
    for (const curve of plot.curves.values()) curve.times.length = curve.values.length = 0;
    plot.startS = plot.nowS || null;
    draw(id);
  }

  // Returns the first index with this time or a later time.
  function indexOf(times, time) {
    let low = 0;
    let high = times.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (times[middle] < time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  // Returns the smallest and the largest value in each column of pixels. The line looks the same.
  function thinned(curve, fromS, startS, columns) {
    const first = Math.max(0, indexOf(curve.times, fromS) - 1);
    const count = curve.times.length - first;
    const points = [];
    const step = Math.max(1, Math.ceil(count / columns));
    for (let at = first; at < curve.times.length; at += step) {
      let low = at;
      let high = at;
      const end = Math.min(at + step, curve.times.length);
      for (let one = at; one < end; one++) {
        if (curve.values[one] < curve.values[low]) low = one;
        if (curve.values[one] > curve.values[high]) high = one;
      }
      for (const one of low === high ? [low] : [Math.min(low, high), Math.max(low, high)]) {
        points.push([curve.times[one] - startS, curve.values[one]]);
      }
    }
    return points;
  }

  // Returns points: y is a value of the curve, and x is the last value of `over` at the same time.
  function paired(curve, over, fromS) {
    const points = [];
    let at = indexOf(over.times, fromS) - 1;
    for (let one = indexOf(curve.times, fromS); one < curve.times.length; one++) {
      while (at + 1 < over.times.length && over.times[at + 1] <= curve.times[one]) at++;
      if (at >= 0) points.push([over.values[at], curve.values[one]]);
    }
    return points;
  }

  function pointsOf(plot, name, width) {
    const [curve, over] = [plot.curves.get(name), plot.curves.get(plot.over)];
    const fromS = plot.nowS - plot.windowS;
    if (over) return name === plot.over ? [] : paired(curve, over, fromS);
    return thinned(curve, fromS, plot.startS ?? 0, Math.max(width, 200));
  }

  function seriesOf(plot, width) {
    return plot.names.map((name, index) => ({
      id: name,
      yAxisIndex: plot.right.includes(name) ? 1 : 0,
      name,
      type: "line",
      showSymbol: false,
      animation: false,
      lineStyle: { width: 2 },
      itemStyle: { color: colour(`--zb-curve-${(index % COLOURS) + 1}`) },
      emphasis: { disabled: true },
      data: pointsOf(plot, name, width),
    }));
  }

  function axis() {
    const muted = colour("--zb-muted");
    return {
      type: "value",
      axisLabel: { color: muted, hideOverlap: true },
      axisLine: { show: true, lineStyle: { color: colour("--zb-line") } },
      splitLine: { lineStyle: { color: colour("--zb-line") } },
      nameTextStyle: { color: muted },
    };
  }

  function shown(value) {
    return Number.isFinite(value) ? String(+value.toPrecision(6)) : String(value);
  }

  // The x axis is the time, or the values of a curve.
  function xAxisOf(plot) {
    if (plot.curves.has(plot.over)) return { ...axis(), scale: true, min: null, max: null };
    const end = plot.nowS - (plot.startS ?? plot.nowS);
    const right = Math.max(end, plot.windowS);
    return { ...axis(), scale: false, min: right - plot.windowS, max: right, axisLabel: {
      color: colour("--zb-muted"), showMinLabel: false, showMaxLabel: false,
      formatter: (value) => `${+value.toFixed(2)} s`,
    } };
  }

  function tooltip(plot) {
    return {
      trigger: plot.curves.has(plot.over) ? "item" : "axis",
      renderMode: "richText", // so that the names of topics are never HTML
      backgroundColor: colour("--zb-surface"),
      borderColor: colour("--zb-line"),
      textStyle: { color: colour("--zb-text"), fontSize: 12 },
      axisPointer: { lineStyle: { color: colour("--zb-muted") }, label: { show: false } },
      formatter: (found) => {
        const all = [found].flat();
        const x = all[0].value[0];
        return [plot.curves.has(plot.over) ? `${plot.over}  ${shown(x)}` : `${x.toFixed(2)} s`]
          .concat(all.map((one) => `${one.seriesName}  ${shown(one.value[1])}`))
          .join("\n");
      },
    };
  }

  function draw(id) {
    const plot = plots.get(id);
    const chart = chartOf(id);
    if (!chart) {
      if (document.getElementById(`c${id}`)) setTimeout(() => draw(id), 30);
      return;
    }
    chart.setOption(
      {
        animation: false,
        grid: { left: 14, right: 22, top: 18, bottom: 10, containLabel: true },
        xAxis: xAxisOf(plot),
        yAxis: ["left", "right"].map((position) => ({ ...axis(), scale: true, position })),
        tooltip: tooltip(plot),
        dataZoom: [{ type: "inside", disabled: !plot.paused, filterMode: "none" }],
        series: seriesOf(plot, chart.getWidth()),
      },
      plot.isNew ? { replaceMerge: ["series", "xAxis"] } : {},
    );
    plot.isNew = false;
  }

  // Returns CSV with a line for each time at which a curve has a value.
  function csv(plot) {
    const lines = new Map();
    plot.names.forEach((name, index) => {
      const { times, values } = plot.curves.get(name);
      times.forEach((time, at) => {
        if (!lines.has(time)) lines.set(time, Array(plot.names.length).fill(""));
        lines.get(time)[index] = values[at];
      });
    });
    const rows = [...lines.keys()].sort((a, b) => a - b);
    const body = rows.map((time) => [time.toFixed(6), ...lines.get(time)].join(","));
    return [["time", ...plot.names].join(","), ...body, ""].join("\n");
  }

  function save(id) {
    zbot.save("plot.csv", csv(plots.get(id)), "text/csv");
  }

  // The drawing contains colours, so it must be drawn again when the theme changes.
  document.addEventListener("DOMContentLoaded", () => {
    const watcher = new MutationObserver(() => [...plots.keys()].forEach(draw));
    watcher.observe(document.body, { attributeFilter: ["class"] });
  });

  return { add, clear, csv, plots, save, setAxes, setCurves, setPaused, setWindow, start };
})();
