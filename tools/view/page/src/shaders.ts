// Shaders that draw each sphere and each spring as a square of two triangles. The fragment shader evaluates the curved surface
// for each pixel. The surface is therefore exact at any zoom, and tens of thousands of swimmers can be drawn. The square is drawn
// once per bead or spring (instance). Coordinates are relative to the camera, which is at the origin and looks along -z.

const light = `
vec3 lit(vec3 colour, vec3 normal) {
  float lamp = max(dot(normal, normalize(vec3(-0.4, 0.6, 0.8))), 0.0);
  return colour * (0.42 + 0.58 * lamp) + 0.12 * pow(lamp, 24.0);
}
float depth(vec3 place, mat4 projection) {
  vec4 clip = projection * vec4(place, 1.0);
  return 0.5 * clip.z / clip.w + 0.5;
}`;

// Square that contains the outline of a sphere of radius r at distance d from the camera. The square is perpendicular to the line
// from the camera to the centre of the sphere. The outline has the radius r d / sqrt(d^2 - r^2) in the plane of the square.
export const beadVertex = `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform float picked;
in vec3 position;
in vec3 centre;
in float radius, swimmer;
in vec3 colour;
out vec3 seen, middle, paint;
out float size, isPicked;
void main() {
  middle = (modelViewMatrix * vec4(centre, 1.0)).xyz;
  float d = max(length(middle), 1.01 * radius);
  vec3 ahead = normalize(middle);
  vec3 side = normalize(cross(ahead, abs(ahead.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 above = cross(side, ahead);
  float outline = radius * d / sqrt(d * d - radius * radius);
  seen = middle + outline * (position.x * side + position.y * above);
  paint = colour;
  size = radius;
  isPicked = swimmer == picked ? 1.0 : 0.0;
  gl_Position = projectionMatrix * vec4(seen, 1.0);
}`;

// Intersection of the camera's ray with a sphere of radius r. The ray's point nearest to the centre has the distance m = |miss|
// from the centre. The ray hits the sphere at the distance sqrt(r^2 - m^2) before this point.
export const beadFragment = `
precision highp float;
uniform mat4 projectionMatrix;
in vec3 seen, middle, paint;
in float size, isPicked;
out vec4 fragment;
${light}
void main() {
  vec3 ray = normalize(seen);
  float nearest = dot(middle, ray);
  vec3 miss = middle - nearest * ray;
  float inside = size * size - dot(miss, miss);
  if (inside < 0.0) discard;
  vec3 hit = (nearest - sqrt(inside)) * ray;
  vec3 normal = (hit - middle) / size;
  bool rim = isPicked > 0.5 && dot(normal, -ray) < 0.5;
  fragment = vec4(rim ? vec3(0.86, 0.0, 0.5) : lit(paint, normal), 1.0);
  gl_FragDepth = depth(hit, projectionMatrix);
}`;

// An arrow points along y in its own coordinates, from -0.5 to 0.5. It is scaled to its width and length, and turned to
// the velocity.
export const arrowVertex = `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
in vec3 centre, velocity, colour;
in vec2 size;
out vec3 seen, paint;
void main() {
  vec3 ahead = normalize(velocity);
  vec3 side = normalize(cross(ahead, abs(ahead.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 turned = mat3(side, ahead, cross(side, ahead)) * (size.xyx * position);
  seen = (modelViewMatrix * vec4(centre + turned, 1.0)).xyz;
  paint = colour;
  gl_Position = projectionMatrix * vec4(seen, 1.0);
}`;

export const arrowFragment = `
precision highp float;
in vec3 seen, paint;
out vec4 fragment;
${light}
void main() {
  fragment = vec4(lit(paint, normalize(cross(dFdx(seen), dFdy(seen)))), 1.0);
}`;

// A spring is drawn as a flat strip between two beads. The strip faces the camera and is shaded as a cylinder.
export const springVertex = `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
in vec3 from, to;
in float radius;
out vec3 seen, sideways;
out float across;
void main() {
  vec3 a = (modelViewMatrix * vec4(from, 1.0)).xyz, b = (modelViewMatrix * vec4(to, 1.0)).xyz;
  vec3 end = position.y < 0.0 ? a : b;
  sideways = cross(b - a, end);
  sideways = length(sideways) > 0.0 ? normalize(sideways) : vec3(1.0, 0.0, 0.0);
  across = position.x;
  seen = end + 0.18 * radius * across * sideways;
  gl_Position = projectionMatrix * vec4(seen, 1.0);
}`;

export const springFragment = `
precision highp float;
uniform mat4 projectionMatrix;
in vec3 seen, sideways;
in float across;
out vec4 fragment;
${light}
void main() {
  vec3 normal = across * normalize(sideways) - sqrt(1.0 - across * across) * normalize(seen);
  fragment = vec4(lit(vec3(0.5, 0.53, 0.58), normal), 1.0);
  gl_FragDepth = depth(seen, projectionMatrix);
}`;
