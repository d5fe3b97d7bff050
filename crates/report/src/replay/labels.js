// The labels over a view: feature points, tractors, metres along the launch axis.

class Labels {
  /** The labels of a view, most important first: where two would overlap, only the earlier is shown. */
  constructor(view, host) {
    this.host = host;
    this.axis = view.data.axis;
    this.overlay = host.appendChild(document.createElement("div"));
    this.overlay.className = "replay-labels";
    this.overlay.setAttribute("aria-hidden", "true");
    const { points, tractors, axis } = view.data;
    const middle = (nodes) => scaled(nodes.map((node) => view.place(node)).reduce(add), 1 / nodes.length);
    const metres = (mark) => `${Number(mark.toPrecision(3))} m`.replace("-", "−");
    this.labels = [
      ...points.map(({ name, nodes }) => this.label(name, "point", `feature point ${name}`, () => middle(nodes))),
      ...tractors.map((node, place) =>
        this.label(`T${place + 1}`, "tractor", `tractor ${place + 1}`, () => view.place(node)),
      ),
      ...view.marks.map((mark) => this.label(metres(mark), "mark", "along the launch axis", () => scaled(axis, mark))),
    ];
  }

  label(text, kind, title, at) {
    const element = this.overlay.appendChild(document.createElement("span"));
    element.className = `replay-label ${kind}`;
    element.title = title;
    const name = element.appendChild(document.createElement("span"));
    name.textContent = text;
    return { element, name, at, kind, size: null };
  }

  /** Measures the readout and the signs again before the next placing. */
  crowded() {
    this.kept = null;
  }

  /** The boxes of the readout, the ruler and the wind, which no label may cover: left, top, right, bottom, px. */
  boxes() {
    const signs = [...this.host.querySelectorAll(".replay-state, .replay-title, .replay-ruler, .replay-wind")];
    return signs.map(({ offsetLeft: l, offsetTop: t, offsetWidth: w, offsetHeight: h }) => [l - 4, t - 2, l + w + 4, t + h + 2]);
  }

  /** Places each label on the first free side of its point. Without one, a feature point shows its dot alone. */
  place(m, width, height, look) {
    this.kept ??= this.boxes();
    const taken = [...this.kept];
    // hide the marks of an axis seen from its end: they cover each other
    const endOn = Math.abs(dot(look.camera.frame.back, this.axis)) > 0.97;
    for (const label of this.labels) {
      const { element, name, kind } = label;
      const [x, y, z] = label.at();
      const w = m[3] * x + m[7] * y + m[11] * z + m[15];
      const left = (0.5 + (0.5 * (m[0] * x + m[4] * y + m[8] * z + m[12])) / w) * width;
      const top = (0.5 - (0.5 * (m[1] * x + m[5] * y + m[9] * z + m[13])) / w) * height;
      label.size ??= [name.offsetWidth, name.offsetHeight];
      const [wide, high] = label.size;
      const GAP = 6;
      const sides = [
        [GAP, -high - 2],
        [GAP, 2],
        [-GAP - wide, -high - 2],
        [-GAP - wide, 2],
      ];
      const side = sides.find(([dx, dy]) => {
        const [l, t] = [left + dx, top + dy];
        return (
          l > 0 &&
          t > 0 &&
          l + wide < width &&
          t + high < height &&
          taken.every(([tl, tt, tr, tb]) => l > tr || l + wide < tl || t > tb || t + high < tt)
        );
      });
      const seen =
        look.labels && !(endOn && kind === "mark") && w > 0 && left > 0 && left < width && top > 0 && top < height;
      element.style.visibility = seen && (side || kind === "point") ? "visible" : "hidden";
      name.style.visibility = seen && side ? "visible" : "hidden";
      if (!seen) continue;
      element.style.transform = `translate(${left.toFixed(1)}px, ${top.toFixed(1)}px)`;
      if (!side) continue;
      name.style.transform = `translate(${side[0]}px, ${side[1]}px)`;
      taken.push([left + side[0], top + side[1], left + side[0] + wide, top + side[1] + high]);
    }
  }
}
