// Replays all designs on one clock and with one camera, and lays their curves over each other.
(async () => {
  "use strict";
  const { designs, dashes, figures } = JSON.parse(document.getElementById("comparison-data").textContent);

  /** Figures with a curve a design, told apart by colour and dash. */
  class Overlays extends Charts {
    trace(chart, curve, place, colours) {
      const trace = super.trace(chart, curve, place, colours);
      return { ...trace, line: { ...trace.line, dash: dashes[curve.colour % dashes.length] } };
    }

    makeKey(chart) {
      super.makeKey(chart);
      const entries = chart.key.querySelectorAll("button");
      chart.figure.curves.forEach(({ colour }, place) => entries[place].classList.add(`dash-${colour % dashes.length}`));
    }
  }
  // every design has a colour of its own
  Charts.CURVES = designs.length;

  const charts = new Overlays(figures);
  charts.onSeek((time) => charts.setTime(time));
  charts.followReader();

  /** A design's run on its stage; null where there is none, or none that this browser can show. */
  async function stage(host) {
    const element = document.getElementById(`replay-${host.dataset.design}`);
    host.dataset.state = element === null ? "There is no replay of this design." : "unpacking …";
    if (element === null) return null;
    try {
      return new NetcastReplay.View(host, await NetcastReplay.decode(element));
    } catch (error) {
      host.dataset.state = `The replay cannot be shown in this browser: ${error.message}`;
      return null;
    }
  }

  async function replay() {
    const views = (await Promise.all([...document.querySelectorAll(".view")].map(stage))).filter((view) => view !== null);
    if (views.length === 0) return null;
    const player = new NetcastReplay.Player(views, document.getElementById("replay-controls"));
    player.onTime((time) => charts.setTime(time));
    charts.onSeek((time) => { player.pause(); player.seek(time); });
    return player;
  }

  // what is seen first comes first
  const player = await replay();
  performance.mark("replay");
  await charts.show();
  performance.mark("curves");
  // for those who look into the page, and for its tests
  window.netcast = { player, charts };
})();
