// The controls of a player: buttons, choices, clock, key of the colours.

const SPEEDS = [1000, 500, 200, 100, 50, 20, 10, 5, 2, 1].map((slower) => 1 / slower);

const HELP = [
  ["drag", "turn"],
  ["Shift drag", "move; also: right button, two fingers"],
  ["wheel", "zoom, after a click into the view; also: + −, pinch, Ctrl wheel"],
  ["Space", "play, pause"],
  ["← →", "one frame; with Shift, ten"],
  ["Home End", "start, end"],
  ["F", "follow the web, the tractors, nothing"],
  ["1 2 3", "side, along the axis, three-quarter"],
  ["R", "reset the camera"],
];

const ICONS = {
  play: "M3 1.5v13l11-6.5z",
  pause: "M3 2h3.6v12H3zM9.4 2H13v12H9.4z",
  back: "M3 2h2.4v12H3zM14 2v12L6.6 8z",
  on: "M10.6 2H13v12h-2.4zM2 2v12l7.4-6z",
};

/** Makes an element with attributes and children; an attribute that is a function becomes a listener. */
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value !== null) element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

/** Makes an element of a drawing. */
function drawing(tag, attributes) {
  const element = document.createElementNS("http" + "://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}

function icon(name) {
  const svg = drawing("svg", { viewBox: "0 0 16 16", "aria-hidden": "true" });
  svg.appendChild(drawing("path", { d: ICONS[name] }));
  return svg;
}

const force = (newtons) =>
  newtons >= 1e6
    ? `${Number((newtons / 1e6).toPrecision(3))} MN`
    : newtons >= 1e3
      ? `${Number((newtons / 1e3).toPrecision(3))} kN`
      : `${Number(newtons.toPrecision(3))} N`;

class Controls {
  /** Builds the controls of a player in `host`. */
  constructor(player, host) {
    this.player = player;
    const button = (name, text, click, more = {}) =>
      make("button", { type: "button", "aria-label": name, title: name, click, ...more }, text);
    const choice = (name, options, chosen, change) => {
      const select = make(
        "select",
        { "aria-label": name, change: () => change(select.value) },
        ...options.map(([value, text]) =>
          make("option", { value, ...(value === chosen ? { selected: "" } : {}) }, text),
        ),
      );
      return select;
    };
    const named = (name, element) => make("label", {}, make("span", {}, name), element);
    const toggle = (name, key) => {
      const made = button(
        `Show ${name}`,
        name,
        () => {
          player.look[key] = !player.look[key];
          made.setAttribute("aria-pressed", player.look[key]);
          player.redraw();
        },
        { "aria-pressed": "true" },
      );
      return made;
    };

    this.playButton = button("Play", icon("play"), () => player.toggle(), {
      class: "replay-play",
    });
    this.slider = make("input", {
      type: "range",
      min: 0,
      max: player.duration,
      step: "any",
      value: 0,
      "aria-label": "Time",
      input: () => {
        player.pause();
        player.seek(Number(this.slider.value));
      },
    });
    this.clock = make("output", { class: "replay-time" });
    const speeds = [...new Set([...SPEEDS, player.start])]
      .sort((one, other) => one - other)
      .map((speed) => [
        String(speed),
        speed >= 1 ? (speed === 1 ? "real time" : `${speed} ×`) : `1/${Math.round(1 / speed)}`,
      ]);
    const looks = [
      ["three-quarter", "three-quarter"],
      ["side", "side"],
      ["axis", "axis"],
    ];
    this.followChoice = choice(
      "Follow",
      [
        ["web", "the web"],
        ["tractors", "the tractors"],
        ["nothing", "nothing"],
      ],
      "web",
      (what) => player.follow(what),
    );
    const colours = [
      ["log", "tension"],
      ["linear", "tension, linear"],
      ["class", "link class"],
    ];
    this.colourChoice = choice("Colour of the ropes", colours, "log", (mode) => player.colourBy(mode));
    const canopies = player.views.some(({ data }) => data.canopies.length > 0);
    this.legend = make("div", { class: "replay-legend" });
    this.help = make(
      "dl",
      { class: "replay-help", hidden: "" },
      ...[...HELP, ["rounding", this.rounding()]].map(([keys, meaning]) =>
        make("div", {}, make("dt", {}, keys), make("dd", {}, meaning)),
      ),
    );
    this.helpButton = button("Keys and gestures", "?", () => this.showHelp(), { "aria-expanded": "false" });

    host.append(
      make(
        "div",
        { class: "replay-transport" },
        button("Frame back", icon("back"), () => player.step(-1)),
        this.playButton,
        button("Frame on", icon("on"), () => player.step(1)),
        this.slider,
        this.clock,
      ),
      make(
        "div",
        { class: "replay-tools" },
        make(
          "div",
          { class: "replay-group", role: "group", "aria-label": "Camera" },
          ...looks.map(([name, text]) => button(`Look: ${text}`, text, () => player.lookFrom(name))),
          button("Reset the camera", "reset", () => player.reset()),
        ),
        named(
          "speed",
          choice("Speed", speeds, String(player.start), (speed) => {
            player.speed = Number(speed);
          }),
        ),
        named("follow", this.followChoice),
        named("colour", this.colourChoice),
        make(
          "div",
          { class: "replay-group", role: "group", "aria-label": "Shown" },
          toggle("labels", "labels"),
          ...(canopies ? [toggle("canopies", "canopies")] : []),
          this.helpButton,
        ),
      ),
      this.help,
      this.legend,
    );
  }

  /** The rounding of positions and tensions in words. */
  rounding() {
    const { views } = this.player;
    const step = Math.max(...views.map(({ data }) => data.step));
    const ratio = 10 ** (Math.max(...views.map(({ data }) => data.tension.decades)) / 254) - 1;
    const [millimetres, percent] = [500 * step, 50 * ratio].map((value) => Number(value.toPrecision(2)));
    return `positions to ${millimetres} mm, tensions to ${percent} %`;
  }

  /** Updates clock, slider and button. */
  show() {
    const { time, duration, playing } = this.player;
    const decimals = Math.min(6, Math.max(1, 3 - Math.floor(Math.log10(duration || 1) + 1)));
    this.clock.textContent = `${time.toFixed(decimals)} s`;
    this.slider.value = time;
    this.slider.setAttribute("aria-valuetext", this.clock.textContent);
    this.slider.style.setProperty("--share", `${(100 * time) / (duration || 1)}%`);
    const name = playing ? "Pause" : "Play";
    if (this.playButton.title === name) return;
    this.playButton.title = name;
    this.playButton.setAttribute("aria-label", name);
    this.playButton.replaceChildren(icon(name.toLowerCase()));
  }

  /** Shows the key of the current colours. */
  showLegend() {
    const { player } = this;
    const {
      mode,
      scale: { high },
    } = player.look;
    const swatch = (kind, colour, text) => {
      const made = make("span", { class: `replay-swatch ${kind}` }, text);
      if (colour) made.style.setProperty("--colour", `var(--${colour})`);
      return made;
    };
    if (mode === "class") {
      const ropes = new Set(
        player.views.flatMap(({ data }) => data.classes.filter(({ is_rope }) => is_rope).map(({ name }) => name)),
      );
      this.legend.replaceChildren(
        ...player.look.classes.map((name, place) => swatch("", ropes.has(name) ? `curve-${place % 8}` : "soft", name)),
      );
    } else {
      const { edges, bands } = player.look;
      // a mark at every third limit is ten times the one before
      const marks =
        mode === "log"
          ? edges.map((edge, place) => [place / (edges.length - 1), edge]).filter((_, place) => place % 3 === 0)
          : [0, 1, 2, 3, 4].map((part) => [part / 4, (high * part) / 4]);
      const scale = make(
        "div",
        { class: "replay-scale", role: "img", "aria-label": `Tension, from ${force(marks[0][1])} to ${force(high)}` },
        ...marks.map(([place, value]) => {
          const mark = make("span", {}, force(value));
          mark.style.setProperty("--place", place);
          return mark;
        }),
      );
      if (mode === "log") scale.style.setProperty("--bands", bands);
      const note =
        mode === "log"
          ? `Tension per rope; each mark is ten times the one before.${player.views.length > 1 ? "" : " The pictures have this scale too."}`
          : `Tension per rope; 0.5 % of the tensions exceed the scale. The highest is ${force(Math.max(...player.views.map(({ data }) => data.tension.max)))}.`;
      this.legend.replaceChildren(swatch("", "slack", "slack"), scale, make("span", { class: "replay-note" }, note));
    }
    if (player.views.some(({ data }) => data.referenceArea))
      this.legend.append(swatch("sheet", "accent", "shaded: open 80 % or more"));
  }

  showHelp() {
    this.help.hidden = !this.help.hidden;
    this.helpButton.setAttribute("aria-expanded", !this.help.hidden);
  }
}
