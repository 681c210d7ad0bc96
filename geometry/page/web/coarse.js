// A rough picture of a large mesh, drawn while it is turned on a machine that would need long for all elements.

const cellsAlongBox = 96;

/** By vertex: the first vertex in the same cell of a grid over the box of the mesh. */
function firstInCells(view) {
  const p = view.mesh.positions, size = Math.max(...view.low.map((low, axis) => view.high[axis] - low)) || 1;
  const first = new Int32Array((cellsAlongBox + 1) ** 3).fill(-1);
  const result = new Uint32Array(view.mesh.vertexCount);
  for (let v = 0; v < result.length; ++v) {
    let cell = 0;
    for (let axis = 0; axis < 3; ++axis)
      cell = cell * (cellsAlongBox + 1) + Math.floor((p[3 * v + axis] - view.low[axis]) / size * cellsAlongBox);
    if (first[cell] < 0) first[cell] = v;
    result[v] = first[cell];
  }
  return result;
}

/** The visible triangles whose corners lie in three cells, moved to the first vertices there. */
function coarseTriangles(view) {
  const { triangles, isVisible } = view, v = triangles.vertices;
  view.firstInCell ??= firstInCells(view);
  const result = [];
  for (let t = 0; t < triangles.count; ++t) {
    if (!isVisible[triangles.element[t]]) continue;
    const a = view.firstInCell[v[3 * t]], b = view.firstInCell[v[3 * t + 1]], c = view.firstInCell[v[3 * t + 2]];
    if (a !== b && b !== c && c !== a) result.push(a, b, c);
  }
  return new Uint32Array(result);
}
