// Meshes of bodies about the origin: positions and normals, triangle by triangle.

/** A cylinder of diameter 1 and height 1 about the origin: positions and normals, triangle by triangle. */
function cylinder(sides) {
  const mesh = [];
  const at = (side) => [Math.cos((2 * Math.PI * side) / sides), Math.sin((2 * Math.PI * side) / sides)];
  for (let side = 0; side < sides; side++) {
    const [a, b] = [at(side), at(side + 1)];
    for (const [[x, y], z] of [
      [a, -0.5],
      [b, -0.5],
      [b, 0.5],
      [a, -0.5],
      [b, 0.5],
      [a, 0.5],
    ])
      mesh.push(x / 2, y / 2, z, x, y, 0);
    for (const z of [-0.5, 0.5])
      for (const [x, y] of [[0, 0], a, b]) mesh.push(x / 2, y / 2, z, 0, 0, 2 * z);
  }
  return new Float32Array(mesh);
}

/** A cube of side 1 about the origin, in the format of `cylinder`. */
function cube() {
  const mesh = [];
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [-0.5, 0.5]) {
      for (const [u, v] of [[-1, -1], [1, -1], [1, 1], [-1, -1], [1, 1], [-1, 1]]) {
        const [place, normal] = [[0, 0, 0], [0, 0, 0]];
        [place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3]] = [side, u / 2, v / 2];
        normal[axis] = 2 * side;
        mesh.push(...place, ...normal);
      }
    }
  }
  return new Float32Array(mesh);
}

/** A sphere of diameter 1 about the origin, in the format of `cylinder`. */
function sphere(sides) {
  const mesh = [];
  const at = (side, ring) => {
    const [turn, tilt] = [(2 * Math.PI * side) / sides, (2 * Math.PI * ring) / sides - Math.PI / 2];
    return [Math.cos(turn) * Math.cos(tilt), Math.sin(turn) * Math.cos(tilt), Math.sin(tilt)];
  };
  for (let ring = 0; ring < sides / 2; ring++) {
    for (let side = 0; side < sides; side++) {
      const [a, b, c, d] = [at(side, ring), at(side + 1, ring), at(side + 1, ring + 1), at(side, ring + 1)];
      for (const normal of [a, b, c, a, c, d]) mesh.push(...scaled(normal, 0.5), ...normal);
    }
  }
  return new Float32Array(mesh);
}

