// What the page uses of three.js; bundle.sh makes three.min.js of it.
export {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  GLSL3,
  LineSegments,
  Mesh,
  OrthographicCamera,
  Quaternion,
  Scene,
  ShaderMaterial,
  Uint32BufferAttribute,
  Vector2,
  Vector3,
  Vector4,
  WebGLRenderer,
} from "three";
export { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
export { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
export { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
export { TrackballControls } from "three/examples/jsm/controls/TrackballControls.js";
