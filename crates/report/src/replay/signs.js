// The signs over a view: a ruler in metres, and the wind as an arrow.

/** Longest ruler, px. */
const RULER = 110;
/** Half the length of the arrow of a wind across the view, px. */
const ARROW = 22;

class Signs {
  /** The signs of a view in `host`; `wind` is a velocity in m/s, or null for still air. */
  constructor(host, wind) {
    this.ruler = host.appendChild(make("div", { class: "replay-ruler", title: "at the middle of the view" }));
    const speed = wind === null ? 0 : Math.hypot(...wind);
    this.wind = speed > 0 ? scaled(wind, 1 / speed) : null;
    if (this.wind === null) return;
    const name = `wind ${Number(speed.toPrecision(2))} m/s`;
    const svg = drawing("svg", { viewBox: "-28 -28 56 56", "aria-hidden": "true" });
    this.arrow = svg.appendChild(drawing("path", {}));
    const title = `${name} at the muzzle at the start`;
    this.sign = host.appendChild(make("div", { class: "replay-wind", title, role: "img", "aria-label": title }, svg, name));
  }

  remove() {
    this.ruler.remove();
    this.sign?.remove();
  }

  /** Fits the ruler to the zoom and turns the arrow with the camera. */
  place(camera, width, height) {
    const pixel = camera.pixel(width, height);
    // steps of the series are at most 2.5 apart, so this is its largest number that is no longer than the ruler
    const metres = niceStep((RULER * pixel) / 2.5, 1);
    const text = `${Number(metres.toPrecision(1))} m`;
    if (this.ruler.textContent !== text) this.ruler.textContent = text;
    this.ruler.style.width = `${(metres / pixel).toFixed(1)}px`;
    if (this.wind === null) return;
    const { right, up, back } = camera.frame;
    const [x, y, towards] = [dot(right, this.wind), -dot(up, this.wind), dot(back, this.wind)];
    this.arrow.setAttribute("d", Math.hypot(x, y) < 0.12 ? endOn(towards > 0) : arrow(x, y));
  }
}

/** An arrow through the origin; a wind across the view has the full length. */
function arrow(x, y) {
  const [tx, ty] = [ARROW * x, ARROW * y];
  const long = Math.hypot(tx, ty);
  // the head keeps its size, but is no longer than the arrow
  const head = Math.min(9, 1.6 * long) / long;
  const barb = (side) => `${(tx - head * (tx + side * 0.55 * ty)).toFixed(1)} ${(ty - head * (ty - side * 0.55 * tx)).toFixed(1)}`;
  const tip = `${tx.toFixed(1)} ${ty.toFixed(1)}`;
  return `M${(-tx).toFixed(1)} ${(-ty).toFixed(1)}L${tip}M${barb(1)}L${tip}L${barb(-1)}`;
}

/** An arrow seen from its end: a dot where it comes nearer, a cross where it goes away, in a ring. */
function endOn(nearer) {
  const ring = "M-9 0a9 9 0 1 0 18 0a9 9 0 1 0 -18 0";
  return `${ring}${nearer ? "M-1.5 0a1.5 1.5 0 1 0 3 0a1.5 1.5 0 1 0 -3 0" : "M-6 -6L6 6M-6 6L6 -6"}`;
}

