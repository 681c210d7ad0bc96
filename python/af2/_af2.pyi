"""What the extension module has. Programs use the package af2, which says what all of this means."""

import os
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

Place = Tuple[float, float, float]
_Path = Union[str, "os.PathLike[str]"]

version: str


class InputError(ValueError): ...
class GeometryError(RuntimeError): ...
class InternalError(RuntimeError): ...


class StuckPlace:
    start: Place
    end: Place
    uv: Tuple[float, float]
    level: int
    refusals: List[Tuple[int, str]]


class LayersAlongEdge:
    edge: int
    asked: int
    fewest: int
    most: int
    segments: int
    fewer: int
    thinner: int
    thinnest: float
    place: Place


class OddLoop:
    loop: int
    segments: int


class FaceReport:
    id: int
    name: str
    surface: str
    chart: str
    status: str
    elements: int
    seconds: float
    area: float
    reason: str
    cause: str
    attempts: List[str]
    stuck: List[StuckPlace]
    without_rule: Dict[str, int]
    acts: Dict[str, int]
    layers: List[LayersAlongEdge]
    layer_elements: int
    odd_loops: List[OddLoop]
    triangles: int
    first_triangle: Place
    deviation: Optional[float]
    congruent_to: int


class FaceGroup:
    name: str
    kind: str
    faces: List[int]
    inward: List[int]


class EdgeGroup:
    name: str
    number: int
    edges: List[int]


class HealedChange:
    what: str
    count: int
    place: Optional[Place]


class Healing:
    tolerance: float
    changes: List[HealedChange]
    undone: List[str]


class Imprinting:
    tolerance: float
    parts: int
    interfaces: int
    changes: List[str]
    undone: str


class MergedGroup:
    faces: List[int]
    smooth_edges: List[int]
    narrow_edges: List[int]
    deviation: float


class KeptFace:
    face: int
    reason: str


class Merging:
    angle: float
    narrow: float
    groups: List[MergedGroup]
    vertices: List[int]
    chains: List[List[int]]
    kept: List[KeptFace]


class Deviation:
    largest: float
    place: Place
    face: int
    edge: int


class PeriodicPair:
    first: int
    second: int
    transform: NDArray[np.float64]
    vertices: NDArray[np.int32]


class StageSeconds:
    edges: float
    surface: float
    optimize: float


class MeshQuality:
    min: float
    p1: float
    mean: float
    worst_face: int
    worst_place: Place
    min_angle: float
    max_angle: float
    free_edges: int
    edge_ratio: Dict[str, Any]


class Progress:
    work_done: float
    work_total: float
    faces_done: int
    faces: int
    elements: int
    fraction: float


class ModelMesh:
    name: str
    faces: List[FaceReport]
    groups: List[FaceGroup]
    boundaries: List[EdgeGroup]
    rule_names: List[str]
    unit: str
    file_unit: str
    notes: List[str]
    findings: List[str]
    healing: Optional[Healing]
    imprinting: Optional[Imprinting]
    merging: Optional[Merging]
    deviation: Optional[Deviation]
    periodic: List[PeriodicPair]
    seconds: StageSeconds


class Step:
    face: int
    start: Place
    end: Place
    level: int
    applied: bool
    rule: Optional[int]
    score: float
    elements: int
    front_edges: int
    refusals: List[Tuple[int, str]]


class FaceEntry:
    id: int
    name: str
    surface: str
    area: float
    edges: List[int]


class EdgeEntry:
    id: int
    curve: str
    length: float
    start: Place
    end: Place
    faces: List[int]


class Parts:
    faces: List[FaceEntry]
    edges: List[EdgeEntry]
    groups: List[FaceGroup]
    boundaries: List[EdgeGroup]


class Defect:
    kind: str
    face: int
    edge: int
    vertex: int
    extent: float
    place: Place
    detail: str


class PartContact:
    kind: str
    parts: Tuple[str, str]
    area: float
    length: float
    volume: float
    place: Place
    equal_faces: List[Tuple[int, int]]


class PartContacts:
    parts: int
    pairs: List[PartContact]
    not_compared: int


class SuggestedEdit:
    what: str
    replacement: str
    line: int
    column: int
    end_line: int
    end_column: int


class Diagnostic:
    code: str
    severity: str
    message: str
    help: str
    rule: str
    edits: List[SuggestedEdit]
    file: str
    line: int
    column: int
    notes: List[str]


class TestFailure:
    expected: str
    got: str
    line: int


class TestResult:
    title: str
    passed: bool
    failures: List[TestFailure]
    rule: str
    score: float
    is_property: bool
    samples: int
    explanation: str
    file: str
    line: int


class MeshableModel:
    kind: str
    notes: List[str]
    unit: str
    file_unit: str
    def parts(self, size: float) -> Parts: ...
    def defects(self, size: float) -> List[Defect]: ...
    def named(self, names: Sequence[Tuple[str, Sequence[int]]]) -> "MeshableModel": ...
    def contacts(self) -> PartContacts: ...


class RuleFile:
    name: str
    titles: List[str]
    makes_quads: bool
    is_usable: bool
    diagnostics: List[Diagnostic]
    def proven_errors(self) -> List[Diagnostic]: ...
    def test(self, filter: str) -> List[TestResult]: ...
    def evaluate(self, rule: str, level: int, match: Mapping[str, Tuple[float, float]],
                 points: Sequence[Tuple[float, float]],
                 segments: Sequence[Tuple[Tuple[float, float], Tuple[float, float]]],
                 environment: Mapping[str, float]) -> Dict[str, Any]: ...


class MeshData:
    points: NDArray[np.float64]
    elements: NDArray[np.int32]
    first_corners: NDArray[np.int32]
    midsides: NDArray[np.int32]
    straightened: NDArray[np.int32]
    segments: NDArray[np.int32]
    segment_edges: NDArray[np.int32]
    segment_uses: NDArray[np.int32]
    face: NDArray[np.int32]
    rule: NDArray[np.uint16]
    level: NDArray[np.uint8]
    changed: NDArray[np.bool_]
    wanted_sizes: NDArray[np.float64]
    scores: NDArray[np.float32]
    quality: NDArray[np.float64]
    quads: int
    mesh: ModelMesh
    fingerprint: str
    status: str
    measures: MeshQuality
    def snap(self, points: Any, faces: Sequence[int], threads: int) -> Tuple[NDArray[Any], ...]: ...
    def evaluate(self, face: int, uv: Any) -> Tuple[NDArray[Any], ...]: ...
    def write(self, path: _Path, edges: bool, groups: Sequence[str], compress: bool, factor: float) -> None: ...
    def write_report(self, path: _Path, reason: str) -> None: ...


def read(path: _Path) -> MeshableModel: ...
def planar(domain: Dict[str, Any]) -> MeshableModel: ...
def triangles(surface: Dict[str, Any]) -> MeshableModel: ...
def surface(surface: Dict[str, Any]) -> MeshableModel: ...
def mesh(model: MeshableModel, rules: RuleFile, asked: Dict[str, Any], name: str) -> MeshData: ...
def load_rules(path: _Path, check: bool) -> RuleFile: ...
def rules_from_text(name: str, text: str, check: bool) -> RuleFile: ...
def shipped_rules(name: str) -> RuleFile: ...
def shipped_files() -> List[str]: ...
def pretty(diagnostics: Sequence[Diagnostic]) -> str: ...
def chart_names() -> str: ...
def parts(mesh: ModelMesh, count: int, all_lines: bool) -> List[Dict[str, Any]]: ...
def length_units() -> Dict[str, float]: ...
def mesh_formats() -> List[Tuple[str, str]]: ...
