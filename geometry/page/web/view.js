// The picture in three dimensions: one draw call for elements, one for their edges, one for outlines of faces.

const faceVertexShader = `
in vec4 elementColor;
in vec3 elementNormal;
uniform vec4 cut;
flat out vec3 paint;
flat out vec3 facing;
out float beyondCut;
void main() {
  paint = elementColor.rgb;
  facing = normalMatrix * elementNormal;
  beyondCut = dot(cut.xyz, position) - cut.w;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

// Light comes from above the left shoulder of the viewer. Back sides are paler, to tell the inside of a cut solid.
const faceFragmentShader = `
flat in vec3 paint;
flat in vec3 facing;
in float beyondCut;
out vec4 result;
void main() {
  if (beyondCut > 0.0) discard;
  vec3 n = normalize(facing);
  float lit = dot(n, normalize(vec3(-0.3, 0.45, 1.0)));
  float light = 0.6 + 0.45 * max(lit, 0.0);
  vec3 shaded = light * paint;
  if (!gl_FrontFacing) shaded = (0.5 + 0.35 * abs(n.z)) * mix(paint, vec3(0.55), 0.55);
  result = vec4(shaded, 1.0);
}`;

const lineVertexShader = `
uniform vec4 cut;
out float beyondCut;
void main() {
  beyondCut = dot(cut.xyz, position) - cut.w;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const lineFragmentShader = `
uniform vec4 lineColor;
in float beyondCut;
out vec4 result;
void main() {
  if (beyondCut > 0.0) discard;
  result = lineColor;
}`;

const mostElementsWithSmoothLines = 300000; // smoothing makes drawing three times as slow without a graphics card
const mostMilliseconds = 80; // for a picture while it is turned; beyond that it gets rough
const restMilliseconds = 250; // until all elements are drawn again

const eyeDistance = 20; // in radii of the mesh; the projection is parallel, so it only has to be outside

const uncut = new THREE.Vector4(0, 0, 0, 1);
const isoDirection = new THREE.Vector3(0.62, -0.74, 0.55).normalize();

function faceMaterial(cut) {
  return new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3, vertexShader: faceVertexShader, fragmentShader: faceFragmentShader,
    side: THREE.DoubleSide, uniforms: { cut },
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1, // lines on elements stay in front
  });
}

function lineMaterial(cut) {
  return new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3, vertexShader: lineVertexShader, fragmentShader: lineFragmentShader,
    transparent: true, depthWrite: false, uniforms: { cut, lineColor: { value: new THREE.Vector4() } },
  });
}

/** Thick lines for what must be seen: faint where elements hide them. */
function markerLines(width) {
  const line = (options) => {
    const material = new THREE.LineMaterial({ linewidth: width, transparent: true, ...options });
    return new THREE.LineSegments2(new THREE.LineSegmentsGeometry(), material);
  };
  const seen = line({}), hidden = line({ depthTest: false, opacity: 0.3 });
  seen.add(hidden);
  for (const lines of [seen, hidden]) Object.assign(lines, { renderOrder: 2, frustumCulled: false });
  seen.visible = false;
  return seen;
}

function setMarkerColor(lines, color) {
  for (const part of [lines, ...lines.children]) part.material.color.set(color);
}

/** Replaces the lines; `ends` has six numbers for each of them. */
function setMarkerLines(lines, ends) {
  lines.geometry.dispose();
  const geometry = new THREE.LineSegmentsGeometry();
  lines.visible = ends.length > 0;
  if (lines.visible) geometry.setPositions(ends);
  for (const part of [lines, ...lines.children]) part.geometry = geometry;
}

class View {
  constructor(mesh, canvas) {
    this.mesh = mesh;
    this.canvas = canvas;
    this.isLarge = mesh.elementCount > mostElementsWithSmoothLines;
    this.renderer = new THREE.WebGLRenderer(
      { canvas, antialias: !this.isLarge, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.camera = new THREE.OrthographicCamera();
    this.camera.up.set(0, 0, 1);
    this.scene = new THREE.Scene();
    this.cut = { value: uncut };
    this.triangles = trianglesOf(mesh);
    this.sides = sidesOf(mesh);
    this.makeShapes();
    this.makeControls();
    this.measure();
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
    this.look(isoDirection);
    requestAnimationFrame(() => this.frame());
  }

  makeShapes() {
    const { count, index, positions, owner, copies } = withOwnVertices(this.mesh, this.triangles);
    this.copies = copies;
    this.fullIndex = index;
    this.owner = owner;
    this.colors = new Uint8Array(4 * count);
    const position = new THREE.BufferAttribute(positions, 3);
    this.colorAttribute = new THREE.BufferAttribute(this.colors, 4, true).setUsage(THREE.DynamicDrawUsage);
    const faces = new THREE.BufferGeometry();
    faces.setAttribute("position", position);
    faces.setAttribute("elementColor", this.colorAttribute);
    faces.setAttribute("elementNormal", new THREE.BufferAttribute(normalsByVertex(this.mesh, owner), 4, true));
    faces.setIndex(new THREE.BufferAttribute(index.slice(), 1).setUsage(THREE.DynamicDrawUsage));
    this.faces = new THREE.Mesh(faces, faceMaterial(this.cut));
    const coarse = new THREE.BufferGeometry();
    for (const [name, attribute] of Object.entries(faces.attributes)) coarse.setAttribute(name, attribute);
    this.coarse = new THREE.Mesh(coarse, this.faces.material);
    this.coarse.visible = false;
    const perSide = this.mesh.middles ? 4 : 2;
    this.edges = this.lineObject(position, perSide * this.sides.count);
    let outlines = 0;
    for (let s = 0; s < this.sides.count; ++s) outlines += isOutline(this.mesh, this.sides, s) ? 1 : 0;
    this.outlines = this.lineObject(position, perSide * outlines);
    this.stuck = markerLines(4);
    this.halo = markerLines(7);
    this.selection = markerLines(3);
    for (const object of [
      this.faces, this.coarse, this.edges, this.outlines, this.stuck, this.halo, this.selection]) {
      object.frustumCulled = false; // three would measure the box again after each change
      this.scene.add(object);
    }
  }

  lineObject(position, ends) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", position);
    const index = new THREE.BufferAttribute(new Uint32Array(ends), 1).setUsage(THREE.DynamicDrawUsage);
    geometry.setIndex(index);
    const lines = new THREE.LineSegments(geometry, lineMaterial(this.cut));
    lines.renderOrder = 1;
    return lines;
  }

  makeControls() {
    const controls = new THREE.TrackballControls(this.camera, this.canvas);
    controls.staticMoving = true; // stops where the pointer stops
    controls.rotateSpeed = 3;
    controls.zoomSpeed = 5; // an eighth for each step of a wheel
    controls.keys = ["", "", ""];
    controls.addEventListener("change", () => this.moved());
    this.controls = controls;
  }

  /** The box around the mesh and the failed places, relative to the centre. */
  measure() {
    this.low = [Infinity, Infinity, Infinity];
    this.high = [-Infinity, -Infinity, -Infinity];
    const add = (value, axis) => {
      if (value < this.low[axis]) this.low[axis] = value;
      if (value > this.high[axis]) this.high[axis] = value;
    };
    const p = this.mesh.positions;
    for (let i = 0; i < p.length; ++i) add(p[i], i % 3);
    for (const end of this.mesh.faces.flatMap((face) => (face.stuck ?? []).flatMap((s) => [s.from, s.to])))
      end.forEach((value, axis) => add(value - this.mesh.centre[axis], axis));
    const size = this.low.map((low, axis) => this.high[axis] - low);
    this.radius = Math.hypot(...size) / 2 || 1;
    this.middle = new THREE.Vector3(...this.low.map((low, axis) => (low + this.high[axis]) / 2));
    this.isPlanar = size[2] < 1e-9 * this.radius;
  }

  resize() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    const half = 1.08 * this.radius, wide = Math.max(width / height, 1), tall = Math.max(height / width, 1);
    Object.assign(this.camera, { left: -half * wide, right: half * wide, top: half * tall, bottom: -half * tall });
    Object.assign(this.camera, { near: 0, far: 2 * eyeDistance * this.radius });
    this.camera.updateProjectionMatrix();
    // TrackballControls moves by parts of the distance to the eye; this makes the mesh follow the pointer.
    this.controls.panSpeed = width / (eyeDistance * this.radius);
    this.controls.handleResize();
    this.draw();
  }

  /** Looks at `target` (default: the middle) from `direction`. */
  look(direction, target = this.middle, zoom = 1) {
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(direction, eyeDistance * this.radius);
    const isFromAbove = Math.abs(direction.z) > 0.999;
    this.camera.up.set(0, isFromAbove ? 1 : 0, isFromAbove ? 0 : 1);
    this.camera.up.projectOnPlane(direction).normalize(); // TrackballControls moves along it
    this.camera.zoom = zoom;
    this.camera.lookAt(target);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  direction() {
    return this.camera.position.clone().sub(this.controls.target).normalize();
  }

  /** Shows a ball, from another direction if one is given. */
  zoomTo(target, radius, direction) {
    const up = this.camera.up.clone();
    const zoom = Math.min(this.radius / Math.max(radius, 1e-6 * this.radius), 1e5);
    this.look(direction ?? this.direction(), target, zoom);
    if (direction) return;
    this.camera.up.copy(up);
    this.controls.update();
    this.draw();
  }

  /** Turns around the target by angles in the window. */
  turn(right, up) {
    const eye = this.camera.position.clone().sub(this.controls.target);
    const side = new THREE.Vector3().crossVectors(this.camera.up, eye).normalize();
    const turning = new THREE.Quaternion().setFromAxisAngle(this.camera.up.clone().normalize(), -right)
      .multiply(new THREE.Quaternion().setFromAxisAngle(side, up));
    this.camera.position.copy(this.controls.target).add(eye.applyQuaternion(turning));
    this.camera.up.applyQuaternion(turning);
    this.camera.lookAt(this.controls.target);
    this.moved();
  }

  zoomBy(factor) {
    this.camera.zoom *= factor;
    this.camera.updateProjectionMatrix();
    this.moved();
  }

  setColors(quantity) {
    for (let v = 0; v < this.owner.length; ++v) {
      if (this.owner[v] < 0) continue;
      const color = elementColor(quantity, this.owner[v]);
      this.colors[4 * v] = color[0];
      this.colors[4 * v + 1] = color[1];
      this.colors[4 * v + 2] = color[2];
    }
    this.colorAttribute.needsUpdate = true;
    this.draw();
  }

  /** Draws only the elements that `isVisible` marks, and their sides. */
  setVisible(isVisible) {
    this.isVisible = isVisible;
    const index = this.faces.geometry.index;
    let count = 0;
    for (let t = 0; t < this.triangles.count; ++t) {
      if (!isVisible[this.triangles.element[t]]) continue;
      for (let i = 0; i < 3; ++i) index.array[count++] = this.fullIndex[3 * t + i];
    }
    this.faces.geometry.setDrawRange(0, count);
    index.needsUpdate = true;
    this.edgesAreCurrent = false;
    this.coarse.geometry.setIndex(null);
    this.setLines(this.outlines, true);
    this.showEdges(this.edges.visible);
  }

  /** Edges are brought up to date only when they are shown: large meshes have millions of them. */
  showEdges(isShown) {
    this.edges.visible = isShown;
    if (isShown && !this.edgesAreCurrent) {
      this.setLines(this.edges, false);
      this.edgesAreCurrent = true;
    }
    this.draw();
  }

  setLines(lines, outlinesOnly) {
    const index = lines.geometry.index, { sides, isVisible } = this;
    let count = 0;
    for (let s = 0; s < sides.count; ++s) {
      const other = sides.second[s];
      if (!isVisible[sides.first[s]] && (other < 0 || !isVisible[other])) continue;
      if (outlinesOnly && !isOutline(this.mesh, sides, s)) continue;
      index.array[count++] = sides.from[s];
      if (this.mesh.middles) {
        index.array[count++] = sides.middle[s];
        index.array[count++] = sides.middle[s];
      }
      index.array[count++] = sides.to[s];
    }
    lines.geometry.setDrawRange(0, count);
    index.needsUpdate = true;
  }

  /** Hides what lies above `at` along an axis (0, 1, 2), or below if flipped. Axis -1: nothing. */
  setCut(axis, at, isFlipped) {
    const sign = isFlipped ? -1 : 1;
    this.cut.value = axis < 0 ? uncut
      : new THREE.Vector4(...[0, 1, 2].map((i) => (i === axis ? sign : 0)), sign * at);
    this.draw();
  }

  /** Takes the colours of lines from the style sheet. */
  useScheme() {
    const style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(name).trim();
    const rgb = color("--mesh-edge").match(/[0-9a-f]{2}/gi).map((hex) => parseInt(hex, 16) / 255);
    this.edges.material.uniforms.lineColor.value.set(...rgb, 0.38);
    this.outlines.material.uniforms.lineColor.value.set(...rgb, 0.95);
    setMarkerColor(this.stuck, "#ff1f1f");
    setMarkerColor(this.halo, "#ffffff");
    setMarkerColor(this.selection, color("--select"));
    this.draw();
  }

  draw() {
    this.isOutdated = true;
  }

  /** The camera has moved, and may go on moving. */
  moved() {
    this.restsAt = performance.now() + restMilliseconds;
    this.draw();
  }

  frame() {
    this.controls.update();
    const isMoving = performance.now() < this.restsAt;
    if (this.isOutdated && isMoving && this.isSlow) this.drawCoarse();
    else if (this.isOutdated || (this.coarse.visible && !isMoving)) this.drawNow();
    requestAnimationFrame(() => this.frame());
  }

  drawNow() {
    this.faces.visible = true;
    this.coarse.visible = false;
    const began = performance.now();
    this.render();
    if (!this.isLarge) return;
    this.waitForPicture();
    this.isSlow = performance.now() - began > mostMilliseconds;
  }

  drawCoarse() {
    if (!this.coarse.geometry.index)
      this.coarse.geometry.setIndex(new THREE.BufferAttribute(coarseTriangles(this), 1));
    const hasEdges = this.edges.visible;
    this.faces.visible = this.edges.visible = false;
    this.coarse.visible = true;
    this.render();
    this.edges.visible = hasEdges;
  }

  render() {
    this.isOutdated = false;
    this.renderer.render(this.scene, this.camera);
    drawAxes(this.camera);
  }

  /** Reading a pixel waits until all is drawn. */
  waitForPicture() {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }
}

/** Arrows along x, y and z as the camera sees them, those that point away first. */
function drawAxes(camera) {
  const turned = camera.quaternion.clone().invert();
  const axes = [["x", "#e0453a", [1, 0, 0]], ["y", "#3c9d40", [0, 1, 0]], ["z", "#3b7de0", [0, 0, 1]]].map(
    ([name, color, direction]) => ({ name, color, to: new THREE.Vector3(...direction).applyQuaternion(turned) }));
  axes.sort((a, b) => a.to.z - b.to.z);
  document.getElementById("axes").innerHTML = axes.map(({ name, color, to }) =>
    `<line x2="${24 * to.x}" y2="${-24 * to.y}" stroke="${color}"/>
     <text x="${33 * to.x}" y="${-33 * to.y}" fill="${color}">${name}</text>`).join("");
}
