// The programs of the graphics processor. A rope segment is a rectangle with a width in pixels; its edges fade over one
// pixel. Each has six vertices in one long list, without instancing: software renderers draw instances one by one.

const THICK = `
uniform mat4 uCamera; uniform vec2 uSize; uniform float uNear;
out float vAcross; out float vHalf;
const int CORNERS[6] = int[6](0, 1, 2, 2, 1, 3);
/** Places this vertex of the rectangle from a to b, extended by cap pixels; corners 0, 1 are at a, 2, 3 at b. */
void thick(vec3 from, vec3 to, float width, float cap) {
  int corner = CORNERS[gl_VertexID % 6];
  vec4 a = uCamera * vec4(from, 1.0), b = uCamera * vec4(to, 1.0);
  vHalf = 0.5 * width;
  if (a.w < uNear && b.w < uNear) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  // cut off the part behind the eye, which has no place on the screen
  if (a.w < uNear) a = mix(a, b, (uNear - a.w) / (b.w - a.w));
  if (b.w < uNear) b = mix(b, a, (uNear - b.w) / (a.w - b.w));
  vec2 pa = 0.5 * uSize * a.xy / a.w, pb = 0.5 * uSize * b.xy / b.w, along = pb - pa;
  along = length(along) > 1e-4 ? normalize(along) : vec2(1.0, 0.0);
  bool end = corner > 1;
  vec4 here = end ? b : a;
  float reach = vHalf + 0.75, side = (corner & 1) == 1 ? reach : -reach;
  vAcross = side;
  vec2 place = (end ? pb + cap * along : pa - cap * along) + side * vec2(-along.y, along.x);
  gl_Position = vec4(2.0 * place / uSize * here.w, here.z, here.w);
}`;

const COVERAGE = `
in float vAcross; in float vHalf;
/** Coverage of the pixel; a line thinner than a pixel is fainter instead. */
float coverage() {
  float shown = max(vHalf, 0.5);
  return clamp(shown + 0.5 - abs(vAcross), 0.0, 1.0) * min(1.0, vHalf / 0.5);
}`;

const HEAD = `#version 300 es
precision highp float; precision highp int; precision highp usampler2D;`;

const SHADERS = {
  ropes: [
    `${HEAD}
uniform usampler2D uSegments, uBefore, uAfter, uTensionBefore, uTensionAfter;
uniform sampler2D uColours, uClassColours;
uniform float uBetween, uStep, uWidth, uDistance, uDecades, uLow, uHigh;
uniform vec3 uOrigin; uniform vec4 uSlack, uMember; uniform int uMode;
out vec4 vColour;
${THICK}
ivec2 cell(int index) { return ivec2(index % ${ROW}, index / ${ROW}); }
vec3 position(uint node) {
  ivec2 at = cell(int(node));
  return uOrigin + uStep * mix(vec3(texelFetch(uBefore, at, 0).xyz), vec3(texelFetch(uAfter, at, 0).xyz), uBetween);
}
/** log10 of the tension over the run's largest; -1000 for a slack segment. */
float tension(uint before, uint after) {
  // a segment that breaks keeps its last tension until the break
  float code = after == 255u ? float(before) : mix(float(before), float(after), uBetween);
  return code < 0.5 ? -1e3 : uDecades * (max(code, 1.0) - 254.0) / 253.0;
}
void main() {
  ivec2 at = cell(gl_VertexID / 6);
  uint before = texelFetch(uTensionBefore, at, 0).x, after = texelFetch(uTensionAfter, at, 0).x;
  // a broken segment is not drawn
  if (before == 255u) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  // two nodes, link class, and 1 where the segment is not a rope
  uvec4 segment = texelFetch(uSegments, at, 0);
  float width = uWidth, pull = tension(before, after);
  bool member = segment.w > 0u, slack = pull < -100.0;
  if (member) { vColour = uMember; width *= 0.6; }
  else if (uMode == 2) vColour = texelFetch(uClassColours, ivec2(segment.z, 0), 0);
  else if (slack) { vColour = uSlack; width *= 0.75; }
  else {
    float share = uMode == 0 ? (pull - uLow) / (uHigh - uLow) : pow(10.0, pull - uHigh);
    vColour = texture(uColours, vec2(clamp(share, 0.002, 0.998), 0.5));
  }
  vec3 a = position(segment.x), b = position(segment.y);
  // nearer ropes are wider
  float depth = (uCamera * vec4(0.5 * (a + b), 1.0)).w;
  width *= clamp(uDistance / max(depth, 1e-3), 0.7, 2.5);
  thick(a, b, width, 0.5 * width);
}`,
    `${HEAD}
in vec4 vColour; out vec4 colour;
${COVERAGE}
void main() {
  float alpha = vColour.a * coverage();
  if (alpha < 0.04) discard;
  colour = vec4(vColour.rgb * alpha, alpha);
}`,
  ],

  lines: [
    `${HEAD}
layout(location = 0) in vec3 aFrom; layout(location = 1) in vec3 aTo; layout(location = 2) in vec2 aLook;
uniform float uWidth;
out vec3 vPlace; out float vStrength; out float vFades;
${THICK}
void main() {
  vPlace = CORNERS[gl_VertexID % 6] > 1 ? aTo : aFrom;
  vStrength = aLook.x; vFades = aLook.y;
  thick(aFrom, aTo, uWidth, 0.0);
}`,
    `${HEAD}
in vec3 vPlace; in float vStrength; in float vFades; out vec4 colour;
uniform vec4 uColour; uniform vec3 uSeen; uniform float uSight;
${COVERAGE}
void main() {
  float fade = vFades > 0.5 ? 1.0 - smoothstep(0.35 * uSight, uSight, distance(vPlace, uSeen)) : 1.0;
  float alpha = uColour.a * vStrength * fade * coverage();
  if (alpha < 0.01) discard;
  colour = vec4(uColour.rgb * alpha, alpha);
}`,
  ],

  bodies: [
    `${HEAD}
layout(location = 0) in vec3 aPlace; layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec3 aMiddle; layout(location = 3) in vec3 aSize; layout(location = 4) in vec3 aColour;
layout(location = 5) in vec3 aX; layout(location = 6) in vec3 aY; layout(location = 7) in vec3 aZ;
uniform mat4 uCamera; uniform float uMetresAPixel, uDistance, uLeast;
out vec3 vNormal; out vec3 vColour;
void main() {
  float depth = max((uCamera * vec4(aMiddle, 1.0)).w, 1e-3);
  // draw the true size unless it is too small to be seen
  float grow = max(1.0, uLeast * uMetresAPixel * depth / uDistance / max(aSize.x, 1e-6));
  mat3 turned = mat3(aX, aY, aZ);
  vec3 place = aMiddle + turned * (aSize * grow * aPlace);
  vNormal = turned * aNormal; vColour = aColour;
  gl_Position = uCamera * vec4(place, 1.0);
}`,
    `${HEAD}
in vec3 vNormal; in vec3 vColour; out vec4 colour;
uniform vec3 uLight;
void main() {
  float light = 0.62 + 0.38 * dot(normalize(vNormal), uLight);
  colour = vec4(vColour * light, 1.0);
}`,
  ],

  sheets: [
    `${HEAD}
layout(location = 0) in vec3 aPlace;
uniform mat4 uCamera;
void main() { gl_Position = uCamera * vec4(aPlace, 1.0); }`,
    `${HEAD}
uniform vec4 uColour; out vec4 colour;
void main() { colour = vec4(uColour.rgb * uColour.a, uColour.a); }`,
  ],
};

/** Compiles a program; returns it with the locations of its uniforms. */
function program(gl, [vertex, fragment]) {
  const made = gl.createProgram();
  for (const [kind, source] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS) && !gl.isContextLost()) {
    const logs = [
      gl.getProgramInfoLog(made),
      ...gl.getAttachedShaders(made).map((shader) => gl.getShaderInfoLog(shader)),
    ];
    throw new Error(logs.filter(Boolean).join("\n"));
  }
  const uniforms = {};
  for (let place = 0; place < gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS); place++) {
    const { name } = gl.getActiveUniform(made, place);
    uniforms[name] = gl.getUniformLocation(made, name);
  }
  return { made, uniforms };
}
