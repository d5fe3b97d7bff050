// Draws the figures in the colours of the reader's theme, keeps their time axes together, and prints them on white.
(() => {
  "use strict";
  const figures = JSON.parse(document.getElementById("figure-data").textContent);
  const root = document.documentElement;
  const element = (figure) => document.getElementById(figure.id);
  const CURVES = 8;

  /** The page's own colours, so that page.css alone decides on them. */
  function palette() {
    const style = getComputedStyle(root);
    const colour = (name) => style.getPropertyValue(`--${name}`).trim();
    return {
      ink: colour("ink"), soft: colour("soft"), grid: colour("grid"), rule: colour("rule"), card: colour("card"),
      shade: colour("shade"), accent: colour("accent"),
      curves: Array.from({ length: CURVES }, (_, place) => colour(`curve-${place}`)),
    };
  }

  function trace(curve, unit, colours) {
    const line = {
      solid: { dash: "solid", width: 1.8 }, dash: { dash: "6px,4px", width: 1.4 }, companion: { dash: "2px,2px", width: 1.3 },
    };
    const reference = curve.colour === null;
    // past the palette's end colours come again, with another dash
    const again = !reference && curve.colour >= CURVES && curve.style === "solid";
    return {
      type: "scatter", mode: "lines", name: curve.name, x: curve.x, y: curve.y,
      line: {
        ...line[curve.style], ...(again ? { dash: "8px,2px,2px,2px" } : {}),
        color: reference ? colours.soft : colours.curves[curve.colour % CURVES],
      },
      ...(reference ? { hoverinfo: "skip" } : { hovertemplate: `%{y:.4~g} ${unit}` }),
      // a companion comes and goes with the line it belongs to
      ...(reference ? {} : { legendgroup: String(curve.colour) }), showlegend: curve.style !== "companion",
    };
  }

  function layout(figure, colours) {
    const axis = {
      gridcolor: colours.grid, linecolor: colours.rule, zerolinecolor: colours.rule, tickcolor: colours.rule,
      ticks: "outside", ticklen: 4, automargin: true, tickfont: { size: 12 },
    };
    const shapes = figure.shaded === null ? [] : [{
      type: "rect", xref: "x", yref: "paper", x0: figure.shaded[0], x1: figure.shaded[1], y0: 0, y1: 1,
      fillcolor: colours.shade, line: { width: 0 }, layer: "below",
    }];
    return {
      paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
      font: { family: getComputedStyle(document.body).fontFamily, size: 12.5, color: colours.ink },
      margin: { l: 56, r: 12, t: 28, b: 40 },
      xaxis: { ...axis, title: { text: "time, s", standoff: 8 }, hoverformat: ".4~f", unifiedhovertitle: { text: "%{x} s" },
        showspikes: true, spikemode: "across", spikethickness: 1, spikedash: "solid", spikecolor: colours.soft },
      yaxis: { ...axis, title: { text: figure.yTitle, standoff: 8 }, rangemode: "tozero" },
      hovermode: "x unified",
      hoverlabel: { bgcolor: colours.card, bordercolor: colours.rule, font: { color: colours.ink, size: 12 } },
      legend: { orientation: "h", tracegroupgap: 0, x: 0, xanchor: "left", y: -0.2, yanchor: "top", itemwidth: 30, font: { size: 12 } },
      showlegend: figure.curves.length > 1,
      modebar: { bgcolor: "rgba(0,0,0,0)", color: colours.soft, activecolor: colours.accent },
      shapes, uirevision: "kept",
    };
  }

  const config = (figure) => ({
    responsive: true, displaylogo: false,
    modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d", "zoomIn2d", "zoomOut2d"],
    toImageButtonOptions: { format: "svg", filename: figure.id },
  });

  function draw() {
    const colours = palette();
    for (const figure of figures) {
      const traces = figure.curves.map((curve) => trace(curve, figure.unit, colours));
      Plotly.react(element(figure), traces, layout(figure, colours), config(figure));
    }
  }

  /** A stretch of time chosen in one figure is shown in all. */
  function keepTogether() {
    let following = false;
    for (const figure of figures) {
      element(figure).on("plotly_relayout", async (change) => {
        const from = change["xaxis.range[0]"];
        const range = from !== undefined ? { "xaxis.range": [from, change["xaxis.range[1]"]] }
          : change["xaxis.autorange"] ? { "xaxis.autorange": true } : null;
        if (range === null || following) return;
        following = true;
        await Promise.all(figures.filter((other) => other !== figure).map((other) => Plotly.relayout(element(other), range)));
        following = false;
      });
    }
  }

  draw();
  keepTogether();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
  addEventListener("beforeprint", () => { root.classList.add("paper"); draw(); });
  addEventListener("afterprint", () => { root.classList.remove("paper"); draw(); });
})();
