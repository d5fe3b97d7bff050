// Charts over time in the colours of the reader's theme. They share one time axis and one cursor.

/**
 * The figures of the page. The element of each holds a `.chart` with a `.plot` of the figure's id, and a `.key`.
 *
 * `show()` draws them, `setTime(s)` moves the cursors, `onSeek(callback)` calls back with the time that a reader picks.
 */
class Charts {
  static CURVES = 8;
  /** Size of a figure on paper, px; page.css has the same height. */
  static PAPER = { width: 320, height: 118 };
  /** The dashes of curves whose colours repeat, by round of the palette; page.css has the same as `.dash-1` to `.dash-3`. */
  static DASHES = ["solid", "9px,4px", "3px,3px", "11px,3px,3px,3px"];

  /** Which of the dashes a curve has by its place in the palette. */
  dash(place) {
    return Math.floor(place / Charts.CURVES) % Charts.DASHES.length;
  }

  constructor(figures) {
    this.charts = figures.map((figure) => {
      const plot = document.getElementById(figure.id);
      const cursor = plot.parentElement.appendChild(document.createElement("div"));
      cursor.className = "cursor";
      const key = plot.closest("figure").querySelector(".key");
      return { figure, plot, cursor, key, hidden: new Set(), drawn: false };
    });
    this.time = null;
    this.seekers = [];
    this.following = false;
  }

  /** Draws the figures one by one and lets the page respond in between. */
  async show() {
    const pause = () => new Promise((resume) => setTimeout(resume));
    // show the page first: parsing the library takes longest of all
    await pause();
    const library = document.createElement("script");
    library.textContent = document.getElementById("library").textContent;
    document.head.append(library);
    for (const chart of this.charts) {
      this.makeKey(chart);
      this.draw(chart);
      this.connect(chart);
      await pause();
    }
  }

  /** Redraws the drawn figures in the current colours. */
  redraw() {
    for (const chart of this.charts.filter(({ drawn }) => drawn)) this.draw(chart);
  }

  /** Redraws when the reader's theme changes; for print, redraws in ink on white and opens all folded parts. */
  followReader() {
    const { classList } = document.documentElement;
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.redraw());
    let folded = [];
    addEventListener("beforeprint", () => {
      classList.add("paper");
      folded = [...document.querySelectorAll("details:not([open])")];
      for (const details of folded) details.open = true;
      this.redraw();
    });
    addEventListener("afterprint", () => {
      classList.remove("paper");
      for (const details of folded) details.open = false;
      this.redraw();
      for (const { plot } of this.charts.filter(({ drawn }) => drawn)) Plotly.Plots.resize(plot);
    });
  }

  onSeek(callback) {
    this.seekers.push(callback);
  }

  /** Moves all cursors to a time, s. */
  setTime(time) {
    this.time = time;
    for (const chart of this.charts.filter(({ visible }) => visible)) this.place(chart);
    // charts out of sight follow once the clock stops
    clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      for (const chart of this.charts.filter(({ drawn }) => drawn)) this.place(chart);
    }, 200);
  }

  draw(chart) {
    const colours = this.palette();
    const traces = chart.figure.curves.map((curve, place) => this.trace(chart, curve, place, colours));
    Plotly.react(chart.plot, traces, this.layout(chart.figure, colours), this.config(chart.figure));
    chart.drawn = true;
  }

  /** The colours of the page, read from its style, so that only page.css defines them. */
  palette() {
    const style = getComputedStyle(document.documentElement);
    const colour = (name) => style.getPropertyValue(`--${name}`).trim();
    return {
      ink: colour("ink"), soft: colour("soft"), grid: colour("grid"), rule: colour("rule"), card: colour("card"),
      shade: colour("shade"), accent: colour("accent"),
      curves: Array.from({ length: Charts.CURVES }, (_, place) => colour(`curve-${place}`)),
    };
  }

  trace({ figure, hidden }, curve, place, colours) {
    const line = {
      solid: { dash: "solid", width: 1.8 }, dash: { dash: "6px,4px", width: 1.4 },
      companion: { dash: "2px,2px", width: 1.3 },
    };
    const reference = curve.colour === null;
    const again = !reference && curve.style === "solid" ? { dash: Charts.DASHES[this.dash(curve.colour)] } : {};
    return {
      type: "scatter", mode: "lines", name: curve.name, x: curve.x, y: curve.y, visible: !hidden.has(place),
      line: {
        ...line[curve.style], ...again,
        color: reference ? colours.soft : colours.curves[curve.colour % Charts.CURVES],
      },
      ...(reference ? { hoverinfo: "skip" } : { hovertemplate: `%{y:.4~g} ${figure.unit}` }),
    };
  }

  layout(figure, colours) {
    // on paper the size is known, and two figures stand side by side on A4
    const paper = document.documentElement.classList.contains("paper");
    const axis = {
      gridcolor: colours.grid, linecolor: colours.rule, zerolinecolor: colours.rule, tickcolor: colours.rule,
      ticks: "outside", ticklen: 4, automargin: true, tickfont: { size: paper ? 8.5 : 12 },
    };
    const title = paper ? { standoff: 2, font: { size: 9 } } : { standoff: 8, font: { size: 13 } };
    const shapes = figure.shaded === null ? [] : [{
      type: "rect", xref: "x", yref: "paper", x0: figure.shaded[0], x1: figure.shaded[1], y0: 0, y1: 1,
      fillcolor: colours.shade, line: { width: 0 }, layer: "below",
    }];
    return {
      paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
      font: { family: getComputedStyle(document.body).fontFamily, size: paper ? 9 : 12.5, color: colours.ink },
      ...(paper ? { ...Charts.PAPER, autosize: false } : { autosize: true }),
      margin: paper ? { l: 34, r: 6, t: 6, b: 24 } : { l: 56, r: 12, t: 28, b: 40 },
      xaxis: { ...axis, title: { ...title, text: "time, s" }, hoverformat: ".4~f",
        unifiedhovertitle: { text: "%{x} s" }, showspikes: true, spikemode: "across", spikethickness: 1, spikedash: "solid", spikecolor: colours.soft },
      yaxis: { ...axis, title: { ...title, text: figure.yTitle }, rangemode: "tozero" },
      // a drag moves the cursor; the toolbar has zoom and pan
      hovermode: "x unified", dragmode: false, showlegend: false,
      hoverlabel: { bgcolor: colours.card, bordercolor: colours.rule, font: { color: colours.ink, size: 12 } },
      modebar: { bgcolor: "rgba(0,0,0,0)", color: colours.soft, activecolor: colours.accent },
      shapes, uirevision: "kept",
    };
  }

  config(figure) {
    return {
      responsive: true, displaylogo: false,
      modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d", "zoomIn2d", "zoomOut2d"],
      toImageButtonOptions: { format: "svg", filename: figure.id },
    };
  }

  /** Fills the key: names of curves with their values at the cursor. A press hides a curve or shows it again. */
  makeKey(chart) {
    const { figure, plot, key, hidden } = chart;
    chart.values = [];
    const sizes = figure.curves.flatMap(({ y }) => y).map((value) => Math.abs(value ?? 0));
    const largest = sizes.reduce((most, size) => Math.max(most, size), 0);
    // a value too small to be seen in the figure counts as 0
    chart.digits = (value) => String(Math.abs(value) < 1e-5 * largest ? 0 : Number(value.toPrecision(3)));
    figure.curves.forEach((curve, place) => {
      // a companion is shown and hidden with the line before it
      if (curve.style === "companion") return;
      const companion = figure.curves[place + 1]?.style === "companion" ? place + 1 : null;
      const places = companion === null ? [place] : [place, companion];
      const entry = key.appendChild(document.createElement("button"));
      entry.type = "button";
      entry.setAttribute("aria-pressed", "true");
      entry.className = curve.style === "solid" ? `dash-${this.dash(curve.colour ?? 0)}` : curve.style;
      const colour = curve.colour === null ? "soft" : `curve-${curve.colour % Charts.CURVES}`;
      entry.style.setProperty("--colour", `var(--${colour})`);
      entry.append(curve.name);
      const value = entry.appendChild(document.createElement("output"));
      if (curve.colour !== null) chart.values.push({ curve, companion: figure.curves[companion], value });
      entry.addEventListener("click", () => {
        const shown = hidden.has(place);
        for (const one of places) shown ? hidden.delete(one) : hidden.add(one);
        entry.setAttribute("aria-pressed", shown);
        Plotly.restyle(plot, { visible: shown }, places);
      });
    });
  }

  connect(chart) {
    const { plot } = chart;
    plot.on("plotly_afterplot", () => this.place(chart));
    plot.on("plotly_relayout", (change) => this.keepTogether(chart, change));
    new IntersectionObserver(([entry]) => {
      chart.visible = entry.isIntersecting;
      if (chart.visible) this.place(chart);
    }, { rootMargin: "10%" }).observe(plot);

    let pressed = null;
    const seek = (event) => {
      const axis = plot._fullLayout.xaxis;
      const x = event.clientX - plot.getBoundingClientRect().left - axis._offset;
      const time = Charts.recorded(chart.figure, axis.p2l(x));
      for (const callback of this.seekers) callback(time);
    };
    plot.addEventListener("pointerdown", (event) => {
      const { xaxis, yaxis, dragmode } = plot._fullLayout;
      const box = plot.getBoundingClientRect();
      const [x, y] = [event.clientX - box.left - xaxis._offset, event.clientY - box.top - yaxis._offset];
      if (event.button !== 0 || x < 0 || x > xaxis._length || y < 0 || y > yaxis._length) return;
      pressed = { x: event.clientX, y: event.clientY, drags: !dragmode };
      if (pressed.drags) {
        plot.setPointerCapture(event.pointerId);
        seek(event);
      }
    }, true);
    plot.addEventListener("pointermove", (event) => { if (pressed?.drags) seek(event); });
    plot.addEventListener("pointerup", (event) => {
      const still = pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) < 4;
      if (still && !pressed.drags) seek(event);
      pressed = null;
    });
    plot.addEventListener("pointercancel", () => { pressed = null; });
  }

  /** Applies the time range that is chosen in one figure to all figures. */
  async keepTogether(chart, change) {
    const from = change["xaxis.range[0]"];
    const range = from !== undefined ? { "xaxis.range": [from, change["xaxis.range[1]"]] }
      : change["xaxis.autorange"] ? { "xaxis.autorange": true } : null;
    if (range === null || this.following) return;
    this.following = true;
    const others = this.charts.filter((other) => other !== chart && other.drawn);
    await Promise.all(others.map(({ plot }) => Plotly.relayout(plot, range)));
    this.following = false;
  }

  /** Moves a figure's cursor and shows the values of its curves there, without a new layout. */
  place({ figure, plot, cursor, values, digits }) {
    const { xaxis, yaxis } = plot._fullLayout;
    const x = this.time === null ? -1 : xaxis.l2p(this.time);
    cursor.hidden = !(x >= -0.5 && x <= xaxis._length + 0.5);
    if (this.time === null) return;
    cursor.style.transform = `translate(${(xaxis._offset + x).toFixed(2)}px, ${yaxis._offset}px)`;
    cursor.style.height = `${yaxis._length}px`;
    for (const { curve, companion, value } of values) {
      const own = Charts.valueAt(curve, this.time), other = companion && Charts.valueAt(companion, this.time);
      const text = own === null ? "" : `${digits(own)}${other == null ? "" : ` (${digits(other)})`} ${figure.unit}`;
      if (value.textContent !== text) value.textContent = text;
    }
  }

  /** The record time of a figure nearest to `time`, s. */
  static recorded({ curves }, time) {
    const { x } = curves.find(({ colour }) => colour !== null) ?? curves[0];
    return x.reduce((nearest, one) => Math.abs(one - time) < Math.abs(nearest - time) ? one : nearest, x[0] ?? time);
  }

  /** A curve's value at a time, interpolated between its points; null where it has none. */
  static valueAt({ x, y }, time) {
    if (x.length === 0 || time < x[0] || time > x[x.length - 1]) return null;
    let from = 0, to = x.length - 1;
    while (to - from > 1) {
      const middle = (from + to) >> 1;
      if (x[middle] <= time) from = middle; else to = middle;
    }
    if (y[from] === null || y[to] === null || from === to) return y[from];
    return y[from] + (y[to] - y[from]) * (time - x[from]) / (x[to] - x[from]);
  }
}
