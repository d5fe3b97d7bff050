// Brings curves and replay together: one time for both, the reader's theme, and white paper.
(async () => {
  "use strict";
  const held = document.getElementById("replay-data");
  const decoded = held === null ? null : NetcastReplay.decode(held);
  // a failure is told below
  decoded?.catch(() => {});

  const charts = new Charts(JSON.parse(document.getElementById("figure-data").textContent));
  charts.onSeek((time) => charts.setTime(time));
  charts.followReader();

  async function replay() {
    const host = document.getElementById("replay-view"), controls = document.getElementById("replay-controls");
    try {
      const view = new NetcastReplay.View(host, await decoded);
      const player = new NetcastReplay.Player([view], controls);
      player.onTime((time) => charts.setTime(time));
      await new Promise(requestAnimationFrame);
      charts.onSeek((time) => { player.pause(); player.seek(time); popOut(); });
      return player;
    } catch (error) {
      host.textContent = `The replay cannot be shown in this browser: ${error.message}`;
      host.classList.add("failed");
      return null;
    }
  }

  /** Who seeks in a figure while the replay is out of sight gets it in a corner of the window, until it is in sight. */
  function popOut() {
    const stage = document.querySelector(".replay-stage"), card = stage.querySelector(".replay-card");
    const box = stage.getBoundingClientRect();
    if (card.classList.contains("floating") || (box.bottom > 120 && box.top < innerHeight - 120)) return;
    // the page keeps its place
    stage.style.minHeight = `${box.height}px`;
    card.classList.add("floating");
    const close = document.createElement("button");
    close.className = "replay-close";
    close.type = "button";
    close.textContent = "×";
    close.setAttribute("aria-label", "Put the replay back into its place");
    card.append(close);
    const margin = { rootMargin: "-120px" };
    const seen = new IntersectionObserver(([entry]) => { if (entry.isIntersecting) putBack(); }, margin);
    const putBack = () => {
      seen.disconnect();
      close.remove();
      card.classList.remove("floating");
      stage.style.minHeight = "";
    };
    close.addEventListener("click", putBack);
    seen.observe(stage);
  }

  // what is seen first comes first
  const player = decoded === null ? null : await replay();
  performance.mark("replay");
  await charts.show();
  performance.mark("curves");
  // for those who look into the page, and for its tests
  window.netcast = { player, charts };
})();
