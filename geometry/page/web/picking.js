// Which element is at a point of the window: a ray against every triangle that is shown. A million triangles take about
// 20 ms, so no tree is needed.

/** The ray of a point of the window in [-1, 1] x [-1, 1]. */
function rayAt(camera, x, y) {
  const from = new THREE.Vector3(x, y, -1).unproject(camera);
  const to = new THREE.Vector3(x, y, 1).unproject(camera);
  return { from: from.toArray(), along: to.sub(from).toArray() };
}

/** How far along the ray it meets a triangle, or Infinity. */
function meetingOf(ray, p, a, b, c) {
  const [ox, oy, oz] = ray.from, [dx, dy, dz] = ray.along;
  const x1 = p[b] - p[a], y1 = p[b + 1] - p[a + 1], z1 = p[b + 2] - p[a + 2];
  const x2 = p[c] - p[a], y2 = p[c + 1] - p[a + 1], z2 = p[c + 2] - p[a + 2];
  const px = dy * z2 - dz * y2, py = dz * x2 - dx * z2, pz = dx * y2 - dy * x2;
  const determinant = x1 * px + y1 * py + z1 * pz;
  if (determinant === 0) return Infinity;
  const tx = ox - p[a], ty = oy - p[a + 1], tz = oz - p[a + 2];
  const u = (tx * px + ty * py + tz * pz) / determinant;
  if (u < 0 || u > 1) return Infinity;
  const qx = ty * z1 - tz * y1, qy = tz * x1 - tx * z1, qz = tx * y1 - ty * x1;
  const v = (dx * qx + dy * qy + dz * qz) / determinant;
  if (v < 0 || u + v > 1) return Infinity;
  const t = (x2 * qx + y2 * qy + z2 * qz) / determinant;
  return t >= 0 ? t : Infinity;
}

function isCutOff(cut, ray, t) {
  const at = ray.from.map((from, axis) => from + t * ray.along[axis]);
  return cut.x * at[0] + cut.y * at[1] + cut.z * at[2] > cut.w;
}

/** The first visible element along a ray, or -1. */
function elementAlong(view, ray) {
  const { triangles, isVisible, mesh } = view, v = triangles.vertices;
  let nearest = Infinity, found = -1;
  for (let t = 0; t < triangles.count; ++t) {
    if (!isVisible[triangles.element[t]]) continue;
    const at = meetingOf(ray, mesh.positions, 3 * v[3 * t], 3 * v[3 * t + 1], 3 * v[3 * t + 2]);
    if (at >= nearest || isCutOff(view.cut.value, ray, at)) continue;
    nearest = at;
    found = triangles.element[t];
  }
  return found;
}

function isHidden(view, point, direction) {
  const from = point.map((x, axis) => x + 1e-3 * view.radius * direction[axis]);
  return elementAlong(view, { from, along: direction.map((x) => 2 * eyeDistance * view.radius * x) }) >= 0;
}

/** The direction from which most of the points are seen: the present one, if no other is better. */
function clearestDirection(view, points) {
  const corners = [[1, -1], [-1, -1], [1, 1], [-1, 1]].flatMap(([x, y]) => [[x, y, 0.8], [x, y, -0.8]]);
  const axes = [[0, 0, 1], [0, 0, -1], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]];
  let best = null, fewest = Infinity;
  for (const candidate of [null, ...corners, ...axes]) {
    const direction = candidate ? new THREE.Vector3(...candidate).normalize() : view.direction();
    const hidden = points.filter((point) => isHidden(view, point, direction.toArray())).length;
    if (hidden >= fewest) continue;
    fewest = hidden;
    best = candidate && direction;
  }
  return best ?? undefined;
}

/** Calls `use` with the element at each click, -1 beside the mesh. A drag is no click. */
function onElementClick(view, use) {
  let start = null;
  view.canvas.addEventListener("pointerdown", (event) => (start = event.button === 0 ? event : null));
  view.canvas.addEventListener("pointerup", (event) => {
    if (!start || Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) > 4) return;
    const box = view.canvas.getBoundingClientRect();
    const x = 2 * (event.clientX - box.left) / box.width - 1, y = 1 - 2 * (event.clientY - box.top) / box.height;
    use(elementAlong(view, rayAt(view.camera, x, y)));
  });
}
