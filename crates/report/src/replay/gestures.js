// Keys, mouse, pen and touch for a player.

/** Handles a key press if the key is one of the player's. */
function pressed(player, event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const tag = event.target.tagName;
  // a select handles arrows and letters itself, a button the space key
  if (tag === "SELECT" || (tag === "BUTTON" && event.key === " ")) return;
  const turn = player.views[0].data.frames > 1 ? 1 : 0;
  const acts = {
    " ": () => player.toggle(),
    ArrowLeft: () => player.step(event.shiftKey ? -10 * turn : -turn),
    ArrowRight: () => player.step(event.shiftKey ? 10 * turn : turn),
    Home: () => player.seek(0),
    End: () => player.seek(player.duration),
    "+": () => player.zoom(1 / 1.2),
    "=": () => player.zoom(1 / 1.2),
    "-": () => player.zoom(1.2),
    f: () => player.follow({ web: "tractors", tractors: "nothing", nothing: "web" }[player.look.follow]),
    1: () => player.lookFrom("side"),
    2: () => player.lookFrom("axis"),
    3: () => player.lookFrom("three-quarter"),
    r: () => player.reset(),
    "?": () => player.controls.showHelp(),
  };
  const act = acts[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (act === undefined) return;
  event.preventDefault();
  event.stopPropagation();
  act();
}

/** Adds pointer and wheel handlers that turn, move and zoom a view. */
function grasp(player, host) {
  const touching = new Map();
  const { camera } = player.look;
  const middle = () => {
    const all = [...touching.values()];
    const x = all.reduce((sum, at) => sum + at.x, 0) / all.length,
      y = all.reduce((sum, at) => sum + at.y, 0) / all.length;
    return { x, y, spread: all.length > 1 ? Math.hypot(all[0].x - all[1].x, all[0].y - all[1].y) : 0 };
  };
  host.addEventListener("pointerdown", (event) => {
    if (event.button > 2) return;
    host.setPointerCapture(event.pointerId);
    touching.set(event.pointerId, { x: event.clientX, y: event.clientY, slides: event.button > 0 || event.shiftKey });
    host.classList.add("held");
  });
  host.addEventListener("pointermove", (event) => {
    const held = touching.get(event.pointerId);
    if (held === undefined) return;
    const before = middle();
    [held.x, held.y] = [event.clientX, event.clientY];
    const now = middle();
    const [dx, dy] = [now.x - before.x, now.y - before.y];
    if (touching.size > 1 || held.slides) camera.slide(dx, dy, host.clientWidth, host.clientHeight);
    else camera.turn(dx, dy);
    if (before.spread > 0 && now.spread > 0) camera.zoom(before.spread / now.spread);
    player.redraw();
  });
  const leave = (event) => {
    touching.delete(event.pointerId);
    if (touching.size === 0) host.classList.remove("held");
  };
  host.addEventListener("pointerup", leave);
  host.addEventListener("pointercancel", leave);
  host.addEventListener("contextmenu", (event) => event.preventDefault());
  // zoom only in a focused view, so that a wheel that scrolls the page past the replay goes on scrolling
  host.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey && document.activeElement !== host) return;
      event.preventDefault();
      player.zoom(Math.exp(0.0015 * event.deltaY * (event.deltaMode === 1 ? 16 : 1)));
    },
    { passive: false },
  );
}
