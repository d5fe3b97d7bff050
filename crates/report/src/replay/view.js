// Draws one net on one canvas: ropes, canopies, bodies, the shaded outline, the ground or the muzzle plane, and labels.

/** The smallest of ..., 1, 2, 5, 10, ... that divides a length into at most `parts` parts. */
function niceStep(length, parts) {
  const rough = Math.max(length, 1e-9) / parts,
    decade = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((step) => step * decade).find((step) => step >= rough * (1 - 1e-9));
}

/** The world axes of a body, interpolated between its orientations in two frames, [x, y, z, w] each. */
function turnedAxes(now, next, between) {
  // a quaternion and its negative are the same orientation: take the one with the shorter rotation
  const sign = now.reduce((sum, part, place) => sum + part * next[place], 0) < 0 ? -1 : 1;
  const mixed = now.map((part, place) => part + between * (sign * next[place] - part));
  const length = Math.hypot(...mixed);
  const [x, y, z, w] = mixed.map((part) => part / length);
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
    [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
    [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
  ];
}

class View {
  /**
   * Shows a decoded run in `host`. `options.title` appears in a corner, for pages with several views.
   *
   * A Player has to draw the view. Without WebGL 2 the host shows a message and the rest of the page works.
   */
  constructor(host, data, options = {}) {
    this.host = host;
    this.data = data;
    /** Requests a redraw; the player sets it. */
    this.stale = () => {};
    host.classList.add("replay-view");
    this.canvas = host.appendChild(document.createElement("canvas"));
    if (options.title) this.note("replay-title", options.title);
    this.state = this.note("replay-state", "");
    this.tick = niceStep(Math.max(data.travel[1] - data.travel[0], data.reach), 8);
    /** The ends of the drawn launch axis, m along it. */
    this.axisEnds = [data.travel[0], data.travel[1] + data.reach / 4];
    const [first, last] = [Math.ceil(this.axisEnds[0] / this.tick), Math.floor(this.axisEnds[1] / this.tick)];
    this.marks = Array.from({ length: last - first + 1 }, (_, place) => (first + place) * this.tick);
    this.labels = new Labels(this, host);
    this.signs = new Signs(host, data.wind);
    this.gl = this.canvas.getContext("webgl2", { alpha: true, antialias: true, premultipliedAlpha: true });
    if (this.gl === null) {
      this.canvas.remove();
      this.labels.overlay.remove();
      this.signs.remove();
      this.note("replay-missing", "The replay needs WebGL 2, which this browser does not offer here.");
    } else {
      this.build();
      this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
      this.canvas.addEventListener("webglcontextrestored", () => {
        this.build();
        this.stale();
      });
    }
    this.visible = true;
    new ResizeObserver(() => {
      this.labels.crowded();
      this.stale();
    }).observe(host);
    new IntersectionObserver(([entry]) => {
      this.visible = entry.isIntersecting;
      this.stale();
    }).observe(host);
  }

  note(className, text) {
    const note = this.host.appendChild(document.createElement("div"));
    note.className = className;
    note.textContent = text;
    return note;
  }

  /** Loads the constant data into the memory of the graphics processor. */
  build() {
    const { gl, data } = this;
    this.programs = Object.fromEntries(Object.entries(SHADERS).map(([name, sources]) => [name, program(gl, sources)]));
    this.frames = this.turns(gl.RGB16UI, gl.RGB_INTEGER, gl.UNSIGNED_SHORT, data.positions);
    this.pulls = this.turns(gl.R8UI, gl.RED_INTEGER, gl.UNSIGNED_BYTE, data.tensions);
    this.colours = this.texture(gl.LINEAR);
    this.classColours = this.texture(gl.LINEAR);
    this.painted = null;

    const rows = Math.max(1, Math.ceil(data.segments / ROW)),
      segments = new Uint32Array(4 * ROW * rows);
    data.classOf.forEach((kind, segment) => {
      const [from, to] = data.ends.subarray(2 * segment);
      segments.set([from, to, kind, data.classes[kind]?.is_rope === false ? 1 : 0], 4 * segment);
    });
    this.segments = this.texture(gl.NEAREST);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, ROW, rows);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, ROW, rows, gl.RGBA_INTEGER, gl.UNSIGNED_INT, segments);
    const lines = this.scenery();
    this.lineVertices = lines.length / 8;
    this.lines = this.arrays([{ values: new Float32Array(lines), sizes: [3, 3, 2] }]);
    this.bodyBuffer = gl.createBuffer();
    const meshes = { cylinder: cylinder(20), box: cube(), sphere: sphere(20) };
    this.bodies = Object.entries(meshes).map(([shape, values]) => ({
      shape,
      vertices: values.length / 6,
      arrays: this.arrays([
        { values, sizes: [3, 3] },
        { buffer: this.bodyBuffer, sizes: [3, 3, 3, 3, 3, 3], each: true },
      ]),
    }));
    this.sheetBuffer = gl.createBuffer();
    this.sheets = this.arrays([{ buffer: this.sheetBuffer, sizes: [3] }]);
  }

  /** Makes and binds a texture with this filter between its texels. */
  texture(filter) {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, filter);
    for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
    return texture;
  }

  /** Two textures that hold the two current frames. */
  turns(inner, format, type, frames) {
    const { gl } = this;
    const height = frames[0].length / ROW / (format === gl.RGB_INTEGER ? 3 : 1);
    const slots = [0, 1].map(() => {
      const texture = this.texture(gl.NEAREST);
      gl.texStorage2D(gl.TEXTURE_2D, 1, inner, ROW, height);
      return { texture, frame: -1 };
    });
    return { slots, frames, height, format, type };
  }

  /** Makes a vertex array. A buffer interleaves attributes of the given sizes; with `each` they advance by instance. */
  arrays(buffers) {
    const { gl } = this;
    const made = gl.createVertexArray();
    gl.bindVertexArray(made);
    let location = 0;
    for (const { values, buffer = gl.createBuffer(), sizes, each = false } of buffers) {
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      if (values) gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
      const stride = 4 * sizes.reduce((sum, one) => sum + one);
      let offset = 0;
      for (const size of sizes) {
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, size, gl.FLOAT, false, stride, offset);
        gl.vertexAttribDivisor(location, each ? 1 : 0);
        offset += 4 * size;
        location++;
      }
    }
    gl.bindVertexArray(null);
    return made;
  }

  /**
   * The plane of the grid: a point, two directions, its spans along each, m, and the distance at which it fades, m. It
   * is the ground below the whole flight where there is ground, and else the muzzle plane.
   */
  floor() {
    const { data } = this;
    if (data.ground === null) {
      const [one, other] = this.axes();
      const sight = 1.4 * data.reach;
      return { level: [0, 0, 0], flat: [one, other], spans: [0, 1].map(() => [-sight, sight]), sight };
    }
    const sight = 1.4 * Math.max(data.reach, data.high[2] - data.ground);
    const spans = [0, 1].map((axis) => [data.low[axis] - sight, data.high[axis] + sight]);
    return { level: [0, 0, data.ground], flat: [[1, 0, 0], [0, 1, 0]], spans, sight };
  }

  /** The vertices of the grid and of the launch axis with its marks: from, to, strength, and 1 where the line fades. */
  scenery() {
    const { data } = this;
    const [one, other, axis] = this.axes();
    const { level, flat, spans, sight } = this.floor();
    this.sight = sight;
    const widest = Math.max(...spans.map(([from, to]) => to - from));
    const grid = Math.max(niceStep(2 * data.reach, 12), niceStep(widest, 60));
    const cells = spans.map(([from, to]) => [Math.floor(from / grid), Math.ceil(to / grid)]);
    const lines = [];
    const line = (from, to, strength, fades) => {
      for (let vertex = 0; vertex < 6; vertex++) lines.push(...from, ...to, strength, fades);
    };
    for (const along of [0, 1]) {
      const [[first, last], [start, end]] = [cells[1 - along], cells[along]];
      for (let place = first; place <= last; place++) {
        const aside = add(level, scaled(flat[1 - along], place * grid));
        const at = (step) => add(aside, scaled(flat[along], step * grid));
        // in pieces, so that the line fades along its length
        for (let piece = start; piece < end; piece++) line(at(piece), at(piece + 1), place === 0 ? 1 : 0.6, 1);
      }
    }
    const [low, high] = this.axisEnds;
    line(scaled(axis, low), scaled(axis, high), 1.4, 0);
    for (const mark of this.marks) {
      const at = scaled(axis, mark),
        half = this.tick / 16;
      line(add(at, scaled(one, -half)), add(at, scaled(one, half)), 1.4, 0);
      line(add(at, scaled(other, -half)), add(at, scaled(other, half)), 1.4, 0);
    }
    return lines;
  }

  /** Two unit vectors normal to the launch axis, and the axis. */
  axes() {
    const axis = this.data.axis;
    const one = unit(cross(Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [0, 1, 0], axis));
    return [one, cross(axis, one), axis];
  }

  /** The position of a node at the current time, m. */
  place(node) {
    const { data, moment } = this;
    const [now, next] = [data.positions[moment.frame], data.positions[moment.next]];
    return [0, 1, 2].map((axis) => {
      const at = 3 * node + axis;
      return data.origin[axis] + data.step * (now[at] + moment.between * (next[at] - now[at]));
    });
  }

  /** Interpolates a value at the current time; a frame has `width` values, of which `part` is taken. */
  atMoment(values, width = 1, part = 0) {
    const { frame, next, between } = this.moment;
    const [now, then] = [values[width * frame + part], values[width * next + part]];
    return now === null || then === null ? null : now + between * (then - now);
  }

  /** Area of the outline over the area of the flat web at the current time. */
  get openShare() {
    const area = this.atMoment(this.data.areas);
    return area === null || !this.data.referenceArea ? null : area / this.data.referenceArea;
  }

  /** Draws the net at a time, s, with the player's camera, colours and options. */
  draw(time, look) {
    this.moment = frameAt(this.data, time);
    this.say();
    if (this.gl === null || !this.visible) return;
    const { gl, host } = this;
    const ratio = Math.min(2, devicePixelRatio || 1);
    const [width, height] = [host.clientWidth, host.clientHeight];
    if (width === 0 || height === 0 || gl.isContextLost()) return;
    const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (this.canvas.width !== wide || this.canvas.height !== high)
      [this.canvas.width, this.canvas.height] = [wide, high];

    const followed = { web: this.data.middles, tractors: this.data.tractorMiddles }[look.follow];
    const target = followed ? [0, 1, 2].map((axis) => this.atMoment(followed, 3, axis)) : look.stay;
    const matrix = look.camera.matrix(target, width, height);
    // the ground fades away from the target, the muzzle plane away from the muzzle
    const [x, y] = add(target, look.camera.pan);
    const seen = this.data.ground === null ? [0, 0, 0] : [x, y, this.data.ground];
    const scene = { matrix, ratio, size: [wide, high], look, seen };
    gl.viewport(0, 0, wide, high);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);

    gl.depthMask(false);
    this.drawLines(scene);
    gl.depthMask(true);
    this.drawBodies(scene);
    this.drawRopes(scene);
    gl.depthMask(false);
    this.drawSheets(scene);
    gl.depthMask(true);
    gl.bindVertexArray(null);
    this.signs.place(look.camera, width, height);
    this.labels.place(matrix, width, height, look);
  }

  use(name, { matrix, size, look }) {
    const { gl } = this;
    const { made, uniforms } = this.programs[name];
    gl.useProgram(made);
    gl.uniformMatrix4fv(uniforms.uCamera, false, matrix);
    if (uniforms.uSize) gl.uniform2fv(uniforms.uSize, size);
    if (uniforms.uNear) gl.uniform1f(uniforms.uNear, look.camera.near);
    return uniforms;
  }

  /** Binds the textures of the frames before and after the current time, and loads those that are missing. */
  bindFrames(store, unitBefore, unitAfter) {
    const { gl } = this;
    const { frame, next } = this.moment;
    for (const [wanted, other, place] of [
      [frame, next, unitBefore],
      [next, frame, unitAfter],
    ]) {
      const slot =
        store.slots.find((slot) => slot.frame === wanted) ?? store.slots.find((slot) => slot.frame !== other);
      gl.activeTexture(gl.TEXTURE0 + place);
      gl.bindTexture(gl.TEXTURE_2D, slot.texture);
      if (slot.frame !== wanted) {
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, ROW, store.height, store.format, store.type, store.frames[wanted]);
        slot.frame = wanted;
      }
    }
  }

  drawRopes(scene) {
    const { gl, data } = this;
    const { look, ratio } = scene;
    const uniforms = this.use("ropes", scene);
    this.bindFrames(this.frames, 0, 1);
    this.bindFrames(this.pulls, 2, 3);
    this.paint(look);
    for (const [place, texture] of [this.colours, this.classColours, this.segments].entries()) {
      gl.activeTexture(gl.TEXTURE4 + place);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    }
    const samplers = ["uBefore", "uAfter", "uTensionBefore", "uTensionAfter", "uColours", "uClassColours", "uSegments"];
    for (const [place, name] of samplers.entries()) gl.uniform1i(uniforms[name], place);
    gl.uniform1f(uniforms.uBetween, this.moment.between);
    gl.uniform1f(uniforms.uStep, data.step);
    gl.uniform3fv(uniforms.uOrigin, data.origin);
    // a dense net has thinner lines
    const crowd = Math.sqrt(2500 / Math.max(2500, data.segments));
    gl.uniform1f(uniforms.uWidth, ratio * (0.9 + 0.9 * crowd));
    gl.uniform1f(uniforms.uDistance, look.camera.distance);
    gl.uniform1f(uniforms.uDecades, data.tension.decades);
    gl.uniform1f(uniforms.uLow, Math.log10(look.scale.low / data.tension.max));
    gl.uniform1f(uniforms.uHigh, Math.log10(look.scale.high / data.tension.max));
    gl.uniform1i(uniforms.uMode, ["log", "linear", "class"].indexOf(look.mode));
    gl.uniform4fv(uniforms.uSlack, look.colours.slack);
    gl.uniform4fv(uniforms.uMember, look.colours.member);
    gl.bindVertexArray(null);
    gl.drawArrays(gl.TRIANGLES, 0, 6 * data.segments);
  }

  /** Loads the colours of tensions and link classes into their textures if the theme has changed. */
  paint({ colours, classes }) {
    if (this.painted === colours) return;
    const { gl } = this;
    const bytes = (list) => new Uint8Array(list.flatMap((colour) => colour.map((part) => Math.round(255 * part))));
    const rows = [
      [this.colours, colours.map],
      [
        this.classColours,
        this.data.classes.map(({ name }) => colours.classes[classes.indexOf(name) % colours.classes.length]),
      ],
    ];
    gl.activeTexture(gl.TEXTURE4);
    for (const [texture, row] of rows) {
      if (row.length === 0) continue;
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, row.length, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes(row));
    }
    this.painted = colours;
  }

  drawLines(scene) {
    const { gl } = this;
    const uniforms = this.use("lines", scene);
    gl.uniform4fv(uniforms.uColour, scene.look.colours.scenery);
    gl.uniform3fv(uniforms.uSeen, scene.seen);
    gl.uniform1f(uniforms.uSight, this.sight);
    gl.uniform1f(uniforms.uWidth, scene.ratio);
    gl.bindVertexArray(this.lines);
    gl.drawArrays(gl.TRIANGLES, 0, this.lineVertices);
  }

  drawBodies(scene) {
    const { gl, data } = this;
    const { look, ratio, size } = scene;
    if (data.bodies.length === 0) return;
    const uniforms = this.use("bodies", scene);
    const { right, up, back } = look.camera.frame;
    gl.uniform1f(uniforms.uMetresAPixel, look.camera.pixel(...size));
    gl.uniform1f(uniforms.uDistance, look.camera.distance);
    gl.uniform1f(uniforms.uLeast, 6 * ratio);
    gl.uniform3fv(uniforms.uLight, unit(add(add(scaled(right, -0.4), scaled(up, 0.7)), scaled(back, 0.6))));
    const { frame, next, between } = this.moment;
    for (const { shape, vertices, arrays } of this.bodies) {
      const alike = data.bodies.filter((body) => body.shape === shape);
      const bodies = alike.flatMap(({ kind, node, size_m, turned }) => {
        const at = (moment) => turned.slice(4 * moment, 4 * moment + 4);
        const axes = turned ? turnedAxes(at(frame), at(next), between) : this.axes();
        const size = size_m.map((size) => Math.max(size, 1e-6));
        return [this.place(node), size, look.colours[kind].slice(0, 3), ...axes].flat();
      });
      gl.bindBuffer(gl.ARRAY_BUFFER, this.bodyBuffer);
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(bodies), gl.DYNAMIC_DRAW);
      gl.bindVertexArray(arrays);
      gl.drawArraysInstanced(gl.TRIANGLES, 0, vertices, alike.length);
    }
  }

  /** Draws the canopies, and the outline while the web is open. */
  drawSheets(scene) {
    const { gl, data } = this;
    const { look } = scene;
    const fan = (middle, rim) =>
      rim.flatMap((corner, place) => [...middle, ...corner, ...rim[(place + 1) % rim.length]]);
    const sheets = [];
    if (this.openShare >= data.openFrom && data.outline.length > 2) {
      const rim = data.outline.map((nodes) =>
        scaled(nodes.map((node) => this.place(node)).reduce(add), 1 / nodes.length),
      );
      sheets.push([fan(scaled(rim.reduce(add), 1 / rim.length), rim), look.colours.open]);
    }
    if (look.canopies && data.canopies.length > 0) {
      const corners = data.canopies.flat().flatMap((node) => this.place(node));
      sheets.push([corners, look.colours.canopy]);
    }
    if (sheets.length === 0) return;
    const uniforms = this.use("sheets", scene);
    gl.bindVertexArray(this.sheets);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.sheetBuffer);
    for (const [corners, colour] of sheets) {
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(corners), gl.DYNAMIC_DRAW);
      gl.uniform4fv(uniforms.uColour, colour);
      gl.drawArrays(gl.TRIANGLES, 0, corners.length / 3);
    }
  }

  /** A share in whole per cent; one that is below the limit does not read like the limit. */
  static percent(share, limit) {
    const whole = (100 * share).toFixed(0);
    const misses = share < limit && Number(whole) >= Math.round(100 * limit);
    return misses ? (Math.floor(1000 * share) / 10).toFixed(1) : whole;
  }

  /** Shows in a corner how far the web is open. */
  say() {
    const area = this.atMoment(this.data.areas),
      share = this.openShare;
    if (area === null) return;
    const isOpen = share !== null && share >= this.data.openFrom;
    const open = share === null ? "" : ` · ${View.percent(share, isOpen ? 1 : this.data.openFrom)} % of flat`;
    const text = `${area.toFixed(area < 9.995 ? 2 : 1)} m²${open}`;
    if (text.length !== this.state.textContent.length) this.labels.crowded();
    this.state.textContent = text;
    this.state.classList.toggle("open", isOpen);
  }
}
