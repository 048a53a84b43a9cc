// Live charts in place of the pictures: pointing reads values, dragging or +/- zooms, a click moves
// the replay there. The data stand beside each figure as JSON (charts_json.h).
(() => {
  const height = 210, font = "12px sans-serif";
  const groups = new Map();  // charts that share their time axis, by estimate

  const unpackedTimes = (packed) =>
    Array.from(new Uint32Array(packedBytes(packed.data)), (steps) => packed.offset + steps * packed.unit);
  const unpackedValues = (packed) => Array.from(unpacked(packed), (value) => Number.isNaN(value) ? null : value);

  function chartsOf(id) {
    const charts = JSON.parse(document.getElementById(id).textContent);
    for (const chart of charts) {
      chart.xs = chart.xs.map(unpackedTimes);
      for (const line of chart.lines) line.y = unpackedValues(line.y);
      for (const band of chart.bands) {
        band.low = unpackedValues(band.low);
        band.high = unpackedValues(band.high);
      }
    }
    return charts;
  }

  function nearestKnown(values, index) {
    for (let reach = 0; reach < values.length; reach++) {
      if (values[index - reach] != null) return index - reach;
      if (values[index + reach] != null) return index + reach;
    }
    return index;
  }

  // The least and greatest of what is drawn between two abscissae.
  function extent(chart, from, to) {
    let low = Infinity, high = -Infinity;
    const take = (x, values) => {
      for (let i = 0; i < x.length; i++) {
        if (x[i] < from || x[i] > to || values[i] == null) continue;
        low = Math.min(low, values[i]);
        high = Math.max(high, values[i]);
      }
    };
    for (const line of chart.lines) take(chart.xs[line.x], line.y);
    for (const band of chart.bands) {
      take(chart.xs[band.x], band.low);
      take(chart.xs[band.x], band.high);
    }
    return low <= high ? [low, high] : [0, 1];
  }

  function verticalRange(chart) {
    return (plot) => {
      const [low, high] = extent(chart, plot.scales.x.min ?? -Infinity, plot.scales.x.max ?? Infinity);
      const room = Math.max(0.06 * (high - low), 1e-6 * Math.max(Math.abs(low), Math.abs(high)), 1e-9);
      return [low - room, high + room];
    };
  }

  function drawBand(plot, x, band) {
    const context = plot.ctx;
    const at = (i, y) => [plot.valToPos(x[i], "x", true), plot.valToPos(y, "y", true)];
    context.fillStyle = band.colour;
    context.globalAlpha = band.opacity;
    let start = 0;
    while (start < x.length) {
      while (start < x.length && band.low[start] == null) start++;
      let end = start;
      while (end < x.length && band.low[end] != null) end++;
      context.beginPath();
      for (let i = start; i < end; i++) context.lineTo(...at(i, band.high[i]));
      for (let i = end - 1; i >= start; i--) context.lineTo(...at(i, band.low[i]));
      context.fill();
      start = end;
    }
  }

  function drawBehind(chart) {
    return (plot) => {
      const context = plot.ctx, box = plot.bbox;
      context.save();
      context.beginPath();
      context.rect(box.left, box.top, box.width, box.height);
      context.clip();
      context.fillStyle = "#999999";
      context.globalAlpha = 0.25;
      for (const [from, to] of chart.spans) {
        const left = plot.valToPos(from, "x", true);
        context.fillRect(left, box.top, plot.valToPos(to, "x", true) - left, box.height);
      }
      for (const band of chart.bands) drawBand(plot, chart.xs[band.x], band);
      context.restore();
    };
  }

  function legendNotes(chart) {
    const notes = chart.bands.map((band) => [band.name, band.colour, band.opacity]);
    if (chart.spans.length > 0) notes.push([chart.spans_name, "#999999", 0.25]);
    const line = document.createElement("p");
    line.className = "keys";
    for (const [name, colour, opacity] of notes) {
      if (!name) continue;
      const mark = document.createElement("span");
      mark.className = "mark";
      mark.style.background = colour;
      mark.style.opacity = opacity + 0.2;
      line.append(mark, name);
    }
    return line;
  }

  function options(chart, group, width) {
    const logarithmic = chart.y.logarithmic === true;
    const number = (plot, value) => value == null ? "–" : String(Number(value.toPrecision(6)));
    // Charts of a group zoom together; what follows from that comes back here with nothing new.
    const scaled = (plot, key) => {
      const {min, max} = plot.scales.x;
      placeMarker(plot);
      if (key !== "x" || !group.built || (group.min === min && group.max === max)) return;
      Object.assign(group, {min, max});
      for (const other of group.plots) if (other !== plot) other.setScale("x", {min, max});
    };
    return {
      width, height,
      cursor: {
        sync: {key: group.key, setSeries: false},
        drag: {x: true, y: false},
        dataIdx: (plot, series, index) =>
          series === 0 ? index : nearestKnown(plot.data[series], index),
      },
      scales: {
        x: {time: false},
        y: logarithmic ? {distr: 3} : {range: verticalRange(chart)},
      },
      axes: [
        {label: chart.x.label, labelSize: 22, size: 34, labelFont: font, font},
        {label: chart.y.label, labelSize: 22, size: 56, labelFont: font, font},
      ],
      series: [{label: chart.x.label, value: number}].concat(chart.lines.map((line) => ({
        label: line.name, stroke: line.colour, width: line.width,
        dash: line.dashes ? line.dashes.split(" ").map(Number) : undefined,
        points: {show: false}, value: number,
      }))),
      hooks: {drawAxes: [drawBehind(chart)], setScale: [scaled], setSize: [placeMarker]},
    };
  }

  function placeMarker(plot) {
    const time = plot.replayTime;
    if (time == null || !plot.marker) return;
    const left = plot.valToPos(time, "x");
    const inside = left >= 0 && left <= plot.over.clientWidth;
    plot.marker.style.display = inside ? "block" : "none";
    plot.marker.style.transform = `translateX(${left}px)`;
  }

  function zoomByKeys(plot, all) {
    return (event) => {
      const {min, max} = plot.scales.x, span = max - min, middle = (min + max) / 2;
      const show = (from, to) => {
        plot.setScale("x", {min: Math.max(from, all[0]), max: Math.min(to, all[1])});
        event.preventDefault();
      };
      if (event.key === "+" || event.key === "=") show(middle - span / 4, middle + span / 4);
      else if (event.key === "-") show(middle - span, middle + span);
      else if (event.key === "0") show(all[0], all[1]);
      else if (event.key === "ArrowLeft") show(Math.max(min - span / 4, all[0]), Math.max(min - span / 4, all[0]) + span);
      else if (event.key === "ArrowRight") show(Math.min(max + span / 4, all[1]) - span, Math.min(max + span / 4, all[1]));
    };
  }

  function build(figure, chart) {
    const key = figure.dataset.estimate || figure.id;
    if (!groups.has(key)) groups.set(key, {key, plots: [], built: false});
    const group = groups.get(key);
    const place = document.createElement("div");
    place.className = "chart";
    place.tabIndex = 0;
    place.setAttribute("role", "group");
    place.setAttribute("aria-label", chart.title +
      ". Live chart: arrows move, plus and minus zoom, 0 shows all; the picture below it in print says the same.");
    const title = document.createElement("p");
    title.className = "title";
    title.textContent = chart.title;
    place.append(title);
    figure.querySelector(".live").append(place);
    const tables = chart.lines.map((line) => [chart.xs[line.x], line.y]);
    const values = tables.length > 1 ? uPlot.join(tables) : tables[0];
    const plot = new uPlot(options(chart, group, place.clientWidth), values, place);
    place.append(legendNotes(chart));
    const all = [values[0][0], values[0][values[0].length - 1]];
    place.addEventListener("keydown", zoomByKeys(plot, all));
    if (figure.dataset.estimate) {
      plot.marker = document.createElement("div");
      plot.marker.className = "now";
      plot.over.append(plot.marker);
      plot.over.addEventListener("click", (event) => document.dispatchEvent(new CustomEvent("seek", {
        detail: {estimate: Number(figure.dataset.estimate), time: plot.posToVal(event.offsetX, "x")},
      })));
    }
    new ResizeObserver(() => {
      if (place.clientWidth > 0 && place.clientWidth !== plot.width) plot.setSize({width: place.clientWidth, height});
    }).observe(place);
    group.plots.push(plot);
  }

  document.addEventListener("moment", (event) => {
    const group = groups.get(String(event.detail.estimate));
    if (!group) return;
    for (const plot of group.plots) {
      plot.replayTime = event.detail.time;
      placeMarker(plot);
    }
  });

  // A figure at a time, those in sight first, so that the page stays open to its reader.
  const waiting = typeof uPlot === "undefined" ? [] : [...document.querySelectorAll("figure[data-charts]")];
  function buildNext() {
    const figure = waiting.shift();
    if (!figure) {
      for (const group of groups.values()) group.built = true;
      document.documentElement.dataset.charts = "ready";
      return;
    }
    figure.classList.add("is-live");
    for (const chart of chartsOf(figure.dataset.charts)) if (chart.lines.length > 0) build(figure, chart);
    setTimeout(buildNext, 0);
  }
  buildNext();
})();
