// Links curves and replay to one time, and follows the reader's theme.
(async () => {
  "use strict";
  const packed = document.getElementById("replay-data");
  const decoded = packed === null ? null : NetcastReplay.decode(packed);
  // `replay` below reports a failure
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

  /** Moves a replay that is out of sight into a corner of the window until its own place is in sight. */
  function popOut() {
    const stage = document.querySelector(".replay-stage"), card = stage.querySelector(".replay-card");
    const box = stage.getBoundingClientRect();
    if (card.classList.contains("floating") || (box.bottom > 120 && box.top < innerHeight - 120)) return;
    // keep the height, so that the page does not scroll
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

  // the replay is at the top of the page
  const player = decoded === null ? null : await replay();
  performance.mark("replay");
  await charts.show();
  performance.mark("curves");
  // for the tests of the page, and for readers at the browser's console
  window.netcast = { player, charts };
})();
