// What the page shows: arrays in base64, and everything else as JSON.

const arrayTypes = { Float32: Float32Array, Int32: Int32Array, Uint32: Uint32Array, Uint8: Uint8Array };

function bytesOf(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** An array of the page, or null if the mesh has none of that name. */
function readArray(name) {
  const node = document.getElementById("array-" + name);
  if (!node) return null;
  const bytes = bytesOf(node.textContent.trim());
  node.remove(); // its text needs more memory than the array
  return new arrayTypes[node.dataset.type](bytes.buffer);
}

/** The mesh by element: corners, face (its id), rule (-1: changed by optimization), level and so on. */
function readMesh() {
  const mesh = JSON.parse(document.getElementById("info").textContent);
  for (const name of ["positions", "corners", "middles", "face", "rule", "level", "quality", "score"])
    mesh[name] = readArray(name);
  mesh.vertexCount = mesh.positions.length / 3;
  mesh.faceIndex = new Map(mesh.faces.map((face, index) => [face.id, index]));
  return mesh;
}

const noVertex = 0xffffffff;

function cornerCount(mesh, element) {
  if (mesh.cornersPerElement === 3) return 3;
  return mesh.corners[4 * element + 3] === noVertex ? 3 : 4;
}

/** The numbers of the corners of an element. */
function cornersOf(mesh, element) {
  const begin = element * mesh.cornersPerElement;
  return mesh.corners.subarray(begin, begin + cornerCount(mesh, element));
}

/** A vertex in the coordinates of the model; positions are relative to the centre, to keep their digits. */
function vertexAt(mesh, vertex) {
  return mesh.centre.map((c, axis) => c + mesh.positions[3 * vertex + axis]);
}

function digits(value) {
  if (value === null || Number.isNaN(value)) return "none";
  if (!Number.isFinite(value)) return "infinite";
  if (Number.isInteger(value)) return String(value);
  const size = Math.abs(value);
  return size >= 1e6 || (size > 0 && size < 1e-4) ? value.toExponential(3) : String(Number(value.toPrecision(5)));
}

function counted(count, one, many = one + "s") {
  return `${count.toLocaleString("en")} ${count === 1 ? one : many}`;
}
