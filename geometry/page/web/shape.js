// What is drawn for the elements: triangles, and the sides between them.

/** Triangles of an element of up to four corners and their middles, as places in [corners, middles]. */
const piecesOfElement = {
  3: [[0, 1, 2]],
  4: [[0, 1, 2], [0, 2, 3]],
  "4 other diagonal": [[0, 1, 3], [1, 2, 3]],
  "3 curved": [[0, 4, 6], [4, 1, 5], [6, 5, 2], [4, 5, 6]],
  "4 curved": [[0, 4, 7], [4, 1, 5], [5, 2, 6], [7, 6, 3], [4, 5, 6], [4, 6, 7]],
};

function squaredDistance(positions, a, b) {
  const x = positions[3 * a] - positions[3 * b];
  const y = positions[3 * a + 1] - positions[3 * b + 1];
  const z = positions[3 * a + 2] - positions[3 * b + 2];
  return x * x + y * y + z * z;
}

function piecesOf(mesh, element, corners) {
  if (mesh.middles) return piecesOfElement[corners.length + " curved"];
  if (corners.length === 3) return piecesOfElement[3];
  const [a, b, c, d] = corners;
  const isAlongAc = squaredDistance(mesh.positions, a, c) <= squaredDistance(mesh.positions, b, d);
  return piecesOfElement[isAlongAc ? 4 : "4 other diagonal"];
}

/** The vertex at a place of [corners, middles]: middle i is at place 4 + i; a curved triangle uses 4, 5 and 6. */
function vertexOfPiece(mesh, element, corners, place) {
  if (place < 4) return corners[place];
  return mesh.middles[element * mesh.cornersPerElement + place - 4];
}

/** Three vertices for each triangle, and its element. */
function trianglesOf(mesh) {
  const most = mesh.elementCount * (mesh.middles ? 6 : mesh.cornersPerElement - 2);
  const vertices = new Uint32Array(3 * most), element = new Uint32Array(most);
  let count = 0;
  for (let e = 0; e < mesh.elementCount; ++e) {
    const corners = cornersOf(mesh, e);
    for (const piece of piecesOf(mesh, e, corners)) {
      for (let i = 0; i < 3; ++i) vertices[3 * count + i] = vertexOfPiece(mesh, e, corners, piece[i]);
      element[count++] = e;
    }
  }
  return { count, vertices: vertices.subarray(0, 3 * count), element: element.subarray(0, count) };
}

/**
 * Each side of the mesh once: ends, middle (if curved) and the elements on both sides (-1: none).
 *
 * Sides are found in lists by their lower vertex: a hash table of objects would take seconds for large meshes.
 * A side of more than two elements appears more than once, as do the edges of the model there.
 */
function sidesOf(mesh) {
  const most = mesh.elementCount * mesh.cornersPerElement;
  const from = new Uint32Array(most), to = new Uint32Array(most), middle = new Uint32Array(mesh.middles ? most : 0);
  const first = new Int32Array(most), second = new Int32Array(most).fill(-1);
  const head = new Int32Array(mesh.vertexCount).fill(-1), next = new Int32Array(most);
  let count = 0;
  for (let e = 0; e < mesh.elementCount; ++e) {
    const begin = e * mesh.cornersPerElement, size = cornerCount(mesh, e);
    for (let i = 0; i < size; ++i) {
      const a = mesh.corners[begin + i], b = mesh.corners[begin + (i + 1) % size];
      const low = Math.min(a, b), high = Math.max(a, b);
      let side = head[low];
      while (side >= 0 && (to[side] !== high || second[side] >= 0)) side = next[side];
      if (side >= 0) {
        second[side] = e;
        continue;
      }
      from[count] = low;
      to[count] = high;
      if (mesh.middles) middle[count] = mesh.middles[begin + i];
      first[count] = e;
      next[count] = head[low];
      head[low] = count++;
    }
  }
  return { count, from, to, middle, first, second };
}

/** Whether a side lies on an edge of the model: it has one element, or those of two faces. */
function isOutline(mesh, sides, side) {
  const other = sides.second[side];
  return other < 0 || mesh.face[other] !== mesh.face[sides.first[side]];
}

/**
 * Gives each element a vertex of its own, the last one of its triangles. WebGL takes flat values (colour and normal)
 * from the last vertex of a triangle, so elements need no vertices of their own except for that one. Vertices that are
 * taken already are copied to the end.
 */
function withOwnVertices(mesh, triangles) {
  const owner = new Int32Array(mesh.vertexCount + triangles.count).fill(-1);
  const copies = [];
  const index = new Uint32Array(triangles.vertices.length);
  for (let t = 0; t < triangles.count; ++t) {
    const e = triangles.element[t], v = triangles.vertices;
    let last = 2;
    while (last >= 0 && owner[v[3 * t + last]] !== -1 && owner[v[3 * t + last]] !== e) --last;
    const turn = last < 0 ? 2 : last;
    index[3 * t] = v[3 * t + (turn + 1) % 3];
    index[3 * t + 1] = v[3 * t + (turn + 2) % 3];
    index[3 * t + 2] = v[3 * t + turn];
    if (last < 0) {
      index[3 * t + 2] = mesh.vertexCount + copies.length;
      copies.push(v[3 * t + turn]);
    }
    owner[index[3 * t + 2]] = e;
  }
  const count = mesh.vertexCount + copies.length;
  const positions = new Float32Array(3 * count);
  positions.set(mesh.positions);
  copies.forEach((v, i) => {
    for (let axis = 0; axis < 3; ++axis)
      positions[3 * (mesh.vertexCount + i) + axis] = mesh.positions[3 * v + axis];
  });
  return { count, index, positions, owner: owner.subarray(0, count), copies };
}

/** The normal of an element, from its diagonals or two sides; not of unit length. */
function normalOf(mesh, element) {
  const corners = cornersOf(mesh, element), p = mesh.positions;
  const [a, b, c, d] = corners.length === 4 ? corners : [corners[0], corners[0], corners[1], corners[2]];
  const x1 = p[3 * c] - p[3 * a], y1 = p[3 * c + 1] - p[3 * a + 1], z1 = p[3 * c + 2] - p[3 * a + 2];
  const x2 = p[3 * d] - p[3 * b], y2 = p[3 * d + 1] - p[3 * b + 1], z2 = p[3 * d + 2] - p[3 * b + 2];
  return [y1 * z2 - z1 * y2, z1 * x2 - x1 * z2, x1 * y2 - y1 * x2];
}

/** Normals by vertex, those of the elements that own them, in bytes. */
function normalsByVertex(mesh, owner) {
  const normals = new Int8Array(4 * owner.length);
  for (let v = 0; v < owner.length; ++v) {
    if (owner[v] < 0) continue;
    const n = normalOf(mesh, owner[v]);
    const scale = 127 / (Math.hypot(n[0], n[1], n[2]) || 1);
    for (let axis = 0; axis < 3; ++axis) normals[4 * v + axis] = Math.round(scale * n[axis]);
  }
  return normals;
}

/** The smallest and the largest angle between the straight sides of an element, in degrees. */
function anglesOf(mesh, element) {
  const corners = cornersOf(mesh, element), size = corners.length, p = mesh.positions;
  let least = 360, most = 0;
  for (let i = 0; i < size; ++i) {
    const o = 3 * corners[i], a = 3 * corners[(i + 1) % size], b = 3 * corners[(i + size - 1) % size];
    const x1 = p[a] - p[o], y1 = p[a + 1] - p[o + 1], z1 = p[a + 2] - p[o + 2];
    const x2 = p[b] - p[o], y2 = p[b + 1] - p[o + 1], z2 = p[b + 2] - p[o + 2];
    const cross = Math.hypot(y1 * z2 - z1 * y2, z1 * x2 - x1 * z2, x1 * y2 - y1 * x2);
    const angle = Math.atan2(cross, x1 * x2 + y1 * y2 + z1 * z2) * 180 / Math.PI;
    least = Math.min(least, angle);
    most = Math.max(most, angle);
  }
  return [least, most];
}
