// What keys, mouse, pen and fingers do to a player.

/** Acts on a key, where it is one of the player's. */
function pressed(player, event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const tag = event.target.tagName;
  // selects keep their arrows and letters, buttons their space
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

/** Lets a view be turned, moved and zoomed by hand. */
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
  // a page that is scrolled past the replay goes on scrolling: the wheel zooms once the replay is in hand
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
