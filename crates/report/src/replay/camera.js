// The camera: turns about what it follows, with world z up. Vectors are arrays of three.

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const scaled = (a, by) => [a[0] * by, a[1] * by, a[2] * by];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => scaled(a, 1 / (Math.hypot(...a) || 1));

/** Half the angle that a view spans across. */
const HALF_ANGLE = (14 * Math.PI) / 180;
/** A view wider than this for its height spans the angle over so much of its width: webs are wide and flat. */
const WIDEST = 1.55;

/** The pixels over which a view spans its angle. */
const span = (width, height) => Math.min(width, WIDEST * height);

class Camera {
  /** A camera for runs that are launched along `axis` and reach so far about their middle, over the ground and up, m. */
  constructor(axis, across, up) {
    this.axis = axis;
    this.across = across;
    this.up = up;
    this.reach = Math.hypot(across, up) || 1;
    this.home();
  }

  /** Back to where it began. */
  home() {
    this.look("three-quarter");
  }

  /** The distance from which all that ever is about the middle is seen in this direction. */
  get homeDistance() {
    const high = this.up * Math.cos(this.elevation) + this.across * Math.abs(Math.sin(this.elevation));
    return (1.08 * Math.max(this.across, WIDEST * high, this.reach / 10)) / Math.tan(HALF_ANGLE);
  }

  /** Takes one of the named directions: `side`, `axis`, `three-quarter`. The middle moves back into the middle. */
  look(name) {
    const rise = Math.asin(Math.min(1, Math.max(-1, this.axis[2])));
    // straight up has no azimuth of its own
    const course = Math.hypot(this.axis[0], this.axis[1]) > 1e-6 ? Math.atan2(this.axis[1], this.axis[0]) : 0;
    this.pan = [0, 0, 0];
    if (name === "axis") [this.azimuth, this.elevation] = [course - (rise > 1.5 ? Math.PI / 2 : 0), rise];
    else if (name === "side") [this.azimuth, this.elevation] = [course - Math.PI / 2, 0];
    else [this.azimuth, this.elevation] = [course - Math.PI / 2 + 0.55, 0.36];
    this.distance = this.homeDistance;
  }

  /** Right, up, and towards the eye. */
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

  /** Length of a pixel at what is looked at, in a view of this size, m. */
  pixel(width, height) {
    return (2 * this.distance * Math.tan(HALF_ANGLE)) / span(width, height);
  }

  /** Moves what is looked at by pixels of a view of this size. */
  slide(dx, dy, width, height) {
    const metres = this.pixel(width, height);
    const { right, up } = this.frame;
    this.pan = add(this.pan, add(scaled(right, -dx * metres), scaled(up, dy * metres)));
  }

  /** From the world to clip space, column by column, looking at `target` in a view of this size. */
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
