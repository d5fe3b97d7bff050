// The camera. It turns about the point that it follows, with world z up. Vectors are arrays of three numbers.

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const scaled = (a, by) => [a[0] * by, a[1] * by, a[2] * by];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => scaled(a, 1 / (Math.hypot(...a) || 1));

/** Half the angle of view, rad. */
const HALF_ANGLE = (14 * Math.PI) / 180;
/** Largest ratio of width to height over which the angle of view is spread: webs are wide and flat. */
const WIDEST = 1.55;

/** The width over which a view spans its angle, px. */
const span = (width, height) => Math.min(width, WIDEST * height);

class Camera {
  /** A camera for runs launched along `axis`. They reach `across` m horizontally and `up` m vertically from their middle. */
  constructor(axis, across, up) {
    this.axis = axis;
    this.across = across;
    this.up = up;
    this.reach = Math.hypot(across, up) || 1;
    this.home();
  }

  /** Moves back to the first view. */
  home() {
    this.look("three-quarter");
  }

  /** The distance, m, from which the whole net is seen in this direction at all times. */
  get homeDistance() {
    const high = this.up * Math.cos(this.elevation) + this.across * Math.abs(Math.sin(this.elevation));
    return (1.08 * Math.max(this.across, WIDEST * high, this.reach / 10)) / Math.tan(HALF_ANGLE);
  }

  /** Turns to a named direction: `side`, `axis` or `three-quarter`, with the net in the middle of the view. */
  look(name) {
    const rise = Math.asin(Math.min(1, Math.max(-1, this.axis[2])));
    // a vertical axis has no azimuth
    const course = Math.hypot(this.axis[0], this.axis[1]) > 1e-6 ? Math.atan2(this.axis[1], this.axis[0]) : 0;
    this.pan = [0, 0, 0];
    if (name === "axis") [this.azimuth, this.elevation] = [course - (rise > 1.5 ? Math.PI / 2 : 0), rise];
    else if (name === "side") [this.azimuth, this.elevation] = [course - Math.PI / 2, 0];
    else [this.azimuth, this.elevation] = [course - Math.PI / 2 + 0.55, 0.36];
    this.distance = this.homeDistance;
  }

  /** The unit vectors to the right, up, and towards the eye. */
  get frame() {
    const [a, e] = [this.azimuth, this.elevation];
    const back = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
    const right = [-Math.sin(a), Math.cos(a), 0];
    return { right, up: cross(back, right), back };
  }

  turn(dx, dy) {
    const limit = Math.PI / 2;
    this.azimuth -= 0.008 * dx;
    this.elevation = Math.min(limit, Math.max(-limit, this.elevation + 0.008 * dy));
  }

  zoom(factor) {
    this.distance = Math.min(100 * this.reach, Math.max(this.reach / 80, this.distance * factor));
  }

  /** Length of a pixel at the target's distance in a view of this size, m. */
  pixel(width, height) {
    return (2 * this.distance * Math.tan(HALF_ANGLE)) / span(width, height);
  }

  /** Moves the target by pixels of a view of this size. */
  slide(dx, dy, width, height) {
    const metres = this.pixel(width, height);
    const { right, up } = this.frame;
    this.pan = add(this.pan, add(scaled(right, -dx * metres), scaled(up, dy * metres)));
  }

  /** The matrix from world to clip space, column by column, for a view of this size at `target`. */
  matrix(target, width, height) {
    const { right, up, back } = this.frame;
    const eye = add(add(target, this.pan), scaled(back, this.distance));
    const focus = span(width, height) / Math.tan(HALF_ANGLE);
    const [fx, fy] = [focus / width, focus / height];
    const near = this.distance / 50,
      far = 3 * this.distance + 60 * this.reach;
    const [p, q] = [(far + near) / (near - far), (2 * far * near) / (near - far)];
    const rows = [
      [right, fx],
      [up, fy],
    ].map(([along, f]) => [...scaled(along, f), -f * dot(along, eye)]);
    const depth = [...back, -dot(back, eye)];
    const matrix = new Float32Array(16);
    for (let column = 0; column < 4; column++) {
      matrix.set(
        [rows[0][column], rows[1][column], p * depth[column] + (column === 3 ? q : 0), -depth[column]],
        4 * column,
      );
    }
    this.near = near;
    return matrix;
  }
}
