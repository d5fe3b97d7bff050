// Decodes a packed run; pack.rs describes the layout. It pauses often, so that the page stays responsive.

/** Width of the textures of positions and tensions, texels. */
const ROW = 1024;

/** Makes a function that lets the page respond if it has waited for 12 ms or more. */
function breather() {
  let since = performance.now();
  return async () => {
    if (performance.now() - since < 12) return;
    await new Promise((resume) => setTimeout(resume));
    since = performance.now();
  };
}

/** The inflated bytes of base64 text, as a promise. */
async function inflate(text) {
  const pause = breather();
  const { readable, writable } = new DecompressionStream("deflate");
  const inflated = new Response(readable).arrayBuffer();
  const writer = writable.getWriter();
  const PIECE = 1 << 18;
  const write = async () => {
    for (let at = 0; at < text.length; at += PIECE) {
      const letters = atob(text.slice(at, at + PIECE));
      const bytes = new Uint8Array(letters.length);
      for (let place = 0; place < letters.length; place++) bytes[place] = letters.charCodeAt(place);
      await writer.write(bytes);
      await pause();
    }
    await writer.close();
  };
  const [buffer] = await Promise.all([inflated, write()]);
  return buffer;
}

/**
 * Decodes the run in an element; returns a promise.
 *
 * `positions[frame]` holds three grid coordinates for each node, `tensions[frame]` one code for each segment. Both fill
 * whole rows of a texture.
 */
async function decode(element) {
  const buffer = await inflate(element.textContent.trim());
  const length = new DataView(buffer).getUint32(0, true);
  const meanings = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  const { frames, nodes, segments } = meanings;
  let at = 4 + length;
  const take = (count) => new Uint8Array(buffer, (at += count) - count, count);

  const data = {
    frames,
    nodes,
    segments,
    times: meanings.times_s,
    duration: meanings.times_s[frames - 1],
    origin: meanings.origin_m,
    step: meanings.step_m,
    axis: meanings.axis,
    ground: meanings.ground_m,
    tension: {
      max: meanings.tension_max_n,
      decades: meanings.tension_decades,
      linearTop: meanings.tension_linear_top_n,
      edges: meanings.tension_edges_n,
    },
    wind: meanings.wind_m_s,
    classes: meanings.classes,
    areas: meanings.areas_m2,
    referenceArea: meanings.reference_area_m2,
    /** A web is open from this share of the flat web's area. */
    openFrom: meanings.open_share,
    outline: meanings.outline,
    tractors: meanings.tractors,
    points: meanings.points,
    canopies: meanings.canopies,
    bodies: meanings.bodies,
    aside: meanings.aside,
    ends: new Uint32Array(buffer.slice(at, at + 8 * segments)),
    positions: [],
    tensions: [],
  };
  at += 8 * segments;
  data.classOf = take(segments);
  const [low, high] = [take(3 * nodes * frames), take(3 * nodes * frames)];

  const pause = breather();
  const rows = Math.max(1, Math.ceil(nodes / ROW));
  let last = null,
    before = null;
  for (let frame = 0, code = 0; frame < frames; frame++) {
    const places = new Uint16Array(3 * ROW * rows);
    for (let axis = 0; axis < 3; axis++) {
      for (let place = axis; place < 3 * nodes; place += 3, code++) {
        const folded = low[code] | (high[code] << 8);
        const expected = last === null ? 0 : before === null ? last[place] : 2 * last[place] - before[place];
        places[place] = expected + ((folded >>> 1) ^ -(folded & 1));
      }
    }
    data.positions.push(places);
    [before, last] = [last, places];
    await pause();
  }
  const tensionRows = Math.max(1, Math.ceil(segments / ROW));
  for (let frame = 0; frame < frames; frame++) {
    const codes = new Uint8Array(ROW * tensionRows);
    codes.set(take(segments));
    data.tensions.push(codes);
  }
  await survey(data, pause);
  return data;
}

/**
 * Adds what the camera needs: the middles of web and tractors in each frame, m; the net's largest distances from the
 * middle, m; the box around the muzzle and all middles, m. It ignores the nodes in `aside`, which no rope reaches.
 */
async function survey(data, pause) {
  const { frames, nodes, origin, step } = data;
  data.middles = new Float64Array(3 * frames);
  data.tractorMiddles = new Float64Array(3 * frames);
  data.across = data.up = 0;
  data.travel = [0, 0];
  [data.low, data.high] = [[0, 0, 0], [0, 0, 0]];
  const aside = new Set(data.aside);
  const web = Uint32Array.from({ length: nodes }, (_, node) => node).filter((node) => !aside.has(node));
  const tractors = data.tractors.length > 0 ? data.tractors : web;
  for (let frame = 0; frame < frames; frame++) {
    const places = data.positions[frame];
    const low = [65535, 65535, 65535],
      high = [0, 0, 0];
    for (const node of web) {
      for (let axis = 0; axis < 3; axis++) {
        const value = places[3 * node + axis];
        if (value < low[axis]) low[axis] = value;
        if (value > high[axis]) high[axis] = value;
      }
    }
    let along = 0;
    const middle = low.map((value, axis) => (value + high[axis]) / 2);
    for (let axis = 0; axis < 3; axis++) {
      const at = origin[axis] + step * middle[axis];
      data.middles[3 * frame + axis] = at;
      data.low[axis] = Math.min(data.low[axis], at);
      data.high[axis] = Math.max(data.high[axis], at);
      let sum = 0;
      for (const node of tractors) sum += places[3 * node + axis];
      data.tractorMiddles[3 * frame + axis] = origin[axis] + (step * sum) / tractors.length;
      along += at * data.axis[axis];
    }
    for (const node of web) {
      const at = 3 * node;
      const [x, y, z] = [places[at] - middle[0], places[at + 1] - middle[1], places[at + 2] - middle[2]];
      data.across = Math.max(data.across, step * Math.sqrt(x * x + y * y));
      data.up = Math.max(data.up, step * Math.abs(z));
    }
    data.travel = [Math.min(data.travel[0], along), Math.max(data.travel[1], along)];
    await pause();
  }
  data.reach = Math.hypot(data.across, data.up) || 1;
}

/** The frames before and after a time, and the time's share of the interval between them. */
function frameAt(data, time) {
  let from = 0,
    to = data.frames - 1;
  while (to - from > 1) {
    const middle = (from + to) >> 1;
    if (data.times[middle] <= time) from = middle;
    else to = middle;
  }
  if (data.frames === 1) return { frame: 0, next: 0, between: 0 };
  const share = (time - data.times[from]) / (data.times[to] - data.times[from]);
  return { frame: from, next: to, between: Math.min(1, Math.max(0, share)) };
}
