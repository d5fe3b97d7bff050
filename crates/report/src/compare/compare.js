// Replays all designs with one clock and one camera, and overlays their curves.
(async () => {
  "use strict";
  const { designs, dashes, figures } = JSON.parse(document.getElementById("comparison-data").textContent);

  /** Figures with one curve for each design, distinguished by colour and dash. */
  class Overlays extends Charts {
    dash(place) {
      return place % dashes.length;
    }
  }
  // one colour for each design
  Charts.CURVES = designs.length;
  Charts.DASHES = dashes;

  const charts = new Overlays(figures);
  charts.onSeek((time) => charts.setTime(time));
  charts.followReader();

  /** The view of a design's run; null where the run is missing or this browser cannot show it. */
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

  // the replay is above the curves
  const player = await replay();
  performance.mark("replay");
  await charts.show();
  performance.mark("curves");
  // for the tests of the page, and for readers at the browser's console
  window.netcast = { player, charts };
})();
