// The player: one clock and one camera for all views.

/** Time that the whole run takes at the first speed, s. */
const WATCHED_S = 8;

class Player {
  /**
   * Plays several views in step and builds the controls in `host`.
   *
   * The page uses `seek(time)`, `play()`, `pause()`, `onTime(callback)`, `time` and `playing`; its tests read
   * `framesPerSecond`.
   */
  constructor(views, host) {
    this.views = views;
    this.host = host;
    this.duration = Math.max(...views.map(({ data }) => data.duration));
    // a step of one frame is a step of the view with the most frames
    this.times = views
      .map(({ data }) => data.times)
      .reduce((most, times) => (times.length > most.length ? times : most));
    this.time = 0;
    this.playing = false;
    this.framesPerSecond = 0;
    this.listeners = [];
    this.requested = 0;
    const most = (what) => Math.max(...views.map(({ data }) => data[what]));
    const camera = new Camera(views[0].data.axis, most("across"), most("up"));
    // the limits of the colours, N: those of the pictures, or of the design with the highest tension
    const edges = views.map(({ data }) => data.tension.edges).reduce((most, one) => (one.at(-1) > most.at(-1) ? one : most));
    this.scales = {
      log: { low: edges[0], high: edges.at(-1) },
      linear: { low: 0, high: Math.max(...views.map(({ data }) => data.tension.linearTop)) },
    };
    this.look = {
      camera,
      follow: "web",
      stay: [0, 0, 0],
      mode: "log",
      labels: true,
      canopies: true,
      scale: this.scales.log,
      edges,
    };
    // a link class has one colour in all views
    this.look.classes = [...new Set(views.flatMap(({ data }) => data.classes.map(({ name }) => name)))];
    this.start = this.usualSpeed();
    this.speed = this.start;
    host.classList.add("replay-controls");
    this.restyle();
    this.controls = new Controls(this, host);
    this.colourBy("log");
    for (const view of views) {
      view.stale = () => this.redraw();
      grasp(this, view.host);
      view.host.addEventListener("keydown", (event) => pressed(this, event));
      view.host.tabIndex = 0;
      view.host.setAttribute("role", "group");
      view.host.setAttribute("aria-label", "The net in three dimensions. Press ? for its keys.");
    }
    host.addEventListener("keydown", (event) => pressed(this, event));
    const restyle = () => {
      this.restyle();
      this.redraw();
    };
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", restyle);
    // show the web at its largest first; the first play starts at time 0
    this.untouched = true;
    this.seek(this.largest());
    this.untouched = true;
  }

  /** The time at which the first web is largest, s; the end where it only shrinks or has no area. */
  largest() {
    const { areas, times } = this.views[0].data;
    const place = areas.reduce((largest, area, frame) => (area > areas[largest] ? frame : largest), 0);
    return place > 0 ? times[place] : this.duration;
  }

  /** The rounded speed at which the run takes about `WATCHED_S`, as simulated time over real time. */
  usualSpeed() {
    const wanted = this.duration / WATCHED_S;
    if (!(wanted > 0)) return 1;
    return wanted > 1 ? Math.round(wanted) : 1 / Math.max(1, Math.round(1 / wanted));
  }

  /** Calls back with the time, s, whenever it changes, and once now. */
  onTime(callback) {
    this.listeners.push(callback);
    callback(this.time);
  }

  seek(time) {
    this.untouched = false;
    this.time = Math.min(this.duration, Math.max(0, time));
    this.redraw();
  }

  play() {
    if (this.playing) return;
    if (this.untouched || this.time >= this.duration) this.seek(0);
    this.playing = true;
    this.untouched = false;
    this.last = null;
    this.redraw();
  }

  pause() {
    this.playing = false;
    this.redraw();
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  step(frames) {
    this.pause();
    const { times, time } = this;
    const slack = 1e-9 * (this.duration || 1);
    const now =
      frames > 0 ? times.findLastIndex((at) => at <= time + slack) : times.findIndex((at) => at >= time - slack);
    const from = now < 0 ? (frames > 0 ? 0 : times.length - 1) : now;
    this.seek(times[Math.min(times.length - 1, Math.max(0, from + frames))]);
  }

  redraw() {
    if (this.requested === 0) this.requested = requestAnimationFrame((now) => this.drawn(now));
  }

  /** Advances the clock and draws a frame of the screen. */
  drawn(now) {
    this.requested = 0;
    if (this.playing) {
      if (this.last !== null && now > this.last) {
        const seconds = (now - this.last) / 1e3;
        this.count(now);
        this.time = Math.min(this.duration, this.time + seconds * this.speed);
        if (this.time >= this.duration) this.playing = false;
      }
      this.last = now;
      this.counted ??= { since: now, frames: 0 };
    } else {
      this.counted = null;
    }
    for (const view of this.views) view.draw(this.time, this.look);
    this.controls.show();
    if (this.time !== this.notified) {
      this.notified = this.time;
      for (const callback of this.listeners) callback(this.time);
    }
    if (this.playing) this.redraw();
  }

  /** Measures the frames per second over half a second or more. */
  count(now) {
    this.counted.frames++;
    const seconds = (now - this.counted.since) / 1e3;
    if (seconds < 0.5) return;
    this.framesPerSecond = this.counted.frames / seconds;
    this.host.dataset.fps = this.framesPerSecond.toFixed(1);
    this.counted = null;
  }

  /** Reads the colours from the page's style. */
  restyle() {
    const style = getComputedStyle(this.host);
    const canvas = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    const parsed = (text) => {
      canvas.clearRect(0, 0, 1, 1);
      canvas.fillStyle = text;
      canvas.fillRect(0, 0, 1, 1);
      return [...canvas.getImageData(0, 0, 1, 1).data].map((part) => part / 255);
    };
    const colour = (name) => style.getPropertyValue(`--${name}`).trim();
    const stops = colour("tension-map")
      .split(",")
      .map((stop) => parsed(stop.trim()));
    const shade = (share) => {
      const at = share * (stops.length - 1),
        stop = Math.min(stops.length - 2, Math.floor(at));
      return stops[stop].map((part, which) => part + (at - stop) * (stops[stop + 1][which] - part));
    };
    // on the logarithmic scale a colour for each bin, as in the pictures
    const { edges, mode } = this.look;
    const bins = edges.length - 1;
    const binAt = (share) => {
      const tension = edges[0] * (edges[bins] / edges[0]) ** share;
      return edges.slice(1, bins).filter((edge) => tension >= edge).length;
    };
    const shares = Array.from({ length: 256 }, (_, place) => (place + 0.5) / 256);
    const map = shares.map((share) => shade(mode === "log" ? binAt(share) / (bins - 1) : share));
    const band = (bin) => `rgb(${shade(bin / (bins - 1)).slice(0, 3).map((part) => Math.round(255 * part))})`;
    const bands = edges.slice(1).map((_, bin) => `${band(bin)} ${(100 * bin) / bins}% ${(100 * (bin + 1)) / bins}%`);
    this.look.bands = bands.join(", ");
    const faint = (name, alpha) => [...parsed(colour(name)).slice(0, 3), alpha];
    this.look.colours = {
      map,
      classes: Array.from({ length: 8 }, (_, place) => parsed(colour(`curve-${place}`))),
      slack: parsed(colour("slack")),
      member: faint("soft", 0.55),
      scenery: faint("soft", 0.3),
      open: faint("accent", 0.13),
      canopy: faint("canopy", 0.4),
      tractor: parsed(colour("tractor")),
      payload: parsed(colour("payload")),
      sensor: parsed(colour("sensor")),
    };
  }

  /** Colours the ropes by tension on a `log` or `linear` scale, or by link `class`. */
  colourBy(mode) {
    this.look.mode = mode;
    this.look.scale = this.scales[mode] ?? this.scales.log;
    this.restyle();
    this.controls.colourChoice.value = mode;
    this.controls.showLegend();
    this.redraw();
  }

  /** Follows the middle of the `web` or of the `tractors`, or `nothing`. */
  follow(what) {
    const { look } = this;
    if (what === "nothing") {
      // keep the current target
      const view = this.views[0];
      const middles = look.follow === "tractors" ? view.data.tractorMiddles : view.data.middles;
      if (look.follow !== "nothing") look.stay = [0, 1, 2].map((axis) => view.atMoment(middles, 3, axis));
    }
    look.follow = what;
    this.controls.followChoice.value = what;
    this.redraw();
  }

  lookFrom(name) {
    this.look.camera.look(name);
    this.redraw();
  }

  reset() {
    this.look.camera.home();
    this.follow("web");
  }

  zoom(factor) {
    this.look.camera.zoom(factor);
    this.redraw();
  }
}
