# What type checkers read of the module. A test (tests/python/types_test.py) compares it with the module: names, keyword
# arguments and the types of their defaults. Defaults are those of the library, which help() shows.
from collections.abc import Callable, Iterator, Sequence
from os import PathLike
from typing import Any, Literal

import numpy
from numpy.typing import NDArray

_Path = str | PathLike[str]
_CaptureOrPath = _Path | Capture
_Side = _CaptureOrPath | list[_CaptureOrPath] | tuple[_CaptureOrPath, ...]
_Progress = Callable[[str, int, int], object]
_Intrinsics = tuple[float, float, float, float]

__version__: str

class Error(Exception):
    source: str
    problem: str
    remedy: str

class UsageError(Error): ...

class Capture:
    @property
    def path(self) -> PathLike[str]: ...
    @property
    def format(self) -> str: ...
    @property
    def depth_frames(self) -> int: ...
    @property
    def color_frames(self) -> int: ...
    @property
    def depth_unit_m(self) -> float: ...
    @property
    def intrinsics(self) -> _Intrinsics: ...
    @property
    def notes(self) -> list[str]: ...
    def depth(self, i: int) -> NDArray[numpy.uint16]: ...
    def color(self, i: int) -> NDArray[numpy.uint8]: ...
    def color_of(self, i: int) -> NDArray[numpy.uint8] | None: ...
    def infrared_of(self, i: int, imager: Literal['left', 'right'] = ...) -> NDArray[numpy.uint16] | None: ...
    def __len__(self) -> int: ...

class Finding:
    @property
    def id(self) -> int: ...
    @property
    def kind(self) -> Literal['added', 'removed', 'appearance']: ...
    @property
    def box(self) -> tuple[int, int, int, int]: ...
    @property
    def area_px(self) -> int: ...
    @property
    def pixels(self) -> NDArray[numpy.uint32]: ...
    @property
    def centroid(self) -> tuple[float, float]: ...
    @property
    def position_m(self) -> tuple[float, float, float] | None: ...
    @property
    def size_mm(self) -> tuple[float, float] | None: ...
    @property
    def height_mm(self) -> float | None: ...
    @property
    def above_surroundings_mm(self) -> float | None: ...
    @property
    def top_above_surroundings_mm(self) -> float | None: ...
    @property
    def top_is_least(self) -> bool: ...
    @property
    def background_jump(self) -> bool: ...
    @property
    def score(self) -> float | None: ...
    @property
    def p_value(self) -> float | None: ...
    @property
    def moved_from(self) -> int | None: ...
    @property
    def evidence(self) -> tuple[str, ...]: ...
    @property
    def class_name(self) -> str | None: ...
    @property
    def probability(self) -> float | None: ...

class Detection:
    @property
    def findings(self) -> tuple[Finding, ...]: ...
    @property
    def method(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def changed(self) -> NDArray[numpy.uint8]: ...
    @property
    def initial_m(self) -> NDArray[numpy.float32]: ...
    @property
    def final_m(self) -> NDArray[numpy.float32]: ...
    @property
    def left_out(self) -> NDArray[numpy.uint8] | None: ...
    @property
    def least_mm(self) -> NDArray[numpy.float32] | None: ...
    @property
    def json(self) -> str: ...
    def as_dict(self) -> dict[str, Any]: ...
    def save(self, out: _Path, *, overwrite: bool = ...) -> list[str]: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[Finding]: ...

class Noise:
    @property
    def std_mm(self) -> NDArray[numpy.float32]: ...
    @property
    def welch_p(self) -> NDArray[numpy.float32]: ...
    def as_dict(self) -> dict[str, Any]: ...

def open(
    path: _Path,
    *,
    intrinsics: _Intrinsics | None = ...,
    no_depth: list[int] = ...,
    depth_unit: float | None = ...,
    topic: str | None = ...,
) -> Capture: ...
def info(
    capture: _CaptureOrPath,
    *,
    intrinsics: _Intrinsics | None = ...,
    no_depth: list[int] = ...,
    depth_unit: float | None = ...,
    topic: str | None = ...,
    progress: _Progress | None = ...,
) -> dict[str, Any]: ...
def detect(
    before: _Side,
    after: _Side,
    *,
    out: _Path | None = ...,
    overwrite: bool = ...,
    method: str = ...,
    ignore: list[_Path] = ...,
    within: list[tuple[int, int, int, int]] = ...,
    plan: _Path | None = ...,
    frames: int = ...,
    false_findings: float = ...,
    threshold: float = ...,
    clip: float = ...,
    sigmas: float = ...,
    min_blob: int = ...,
    join: float = ...,
    octree_cell: float = ...,
    octree_far: float = ...,
    octree_above: float = ...,
    octree_below: float = ...,
    icp_iterations: int = ...,
    icp_distance: float = ...,
    height_error: float = ...,
    inspected: float = ...,
    shake: bool = ...,
    loose_reach: float = ...,
    classify: bool = ...,
    classifier: _Path | None = ...,
    model: _Path | None = ...,
    labels: _Path | None = ...,
    model_width: int = ...,
    model_height: int = ...,
    model_mean: float = ...,
    model_scale: float = ...,
    class_certainty: float = ...,
    intrinsics: _Intrinsics | None = ...,
    no_depth: list[int] = ...,
    depth_unit: float | None = ...,
    topic: str | None = ...,
    progress: _Progress | None = ...,
) -> Detection: ...
def noise(
    capture: _CaptureOrPath,
    *,
    out: _Path | None = ...,
    overwrite: bool = ...,
    frames: int = ...,
    welch_frames: int = ...,
    alpha: float = ...,
    bin: float = ...,
    intrinsics: _Intrinsics | None = ...,
    no_depth: list[int] = ...,
    depth_unit: float | None = ...,
    topic: str | None = ...,
    progress: _Progress | None = ...,
) -> Noise: ...
def export(
    capture: _CaptureOrPath,
    to: Literal['ply', 'pcd', 'open3d', 'mcap'],
    out: _Path,
    *,
    overwrite: bool = ...,
    intrinsics: _Intrinsics | None = ...,
    no_depth: list[int] = ...,
    depth_unit: float | None = ...,
    topic: str | None = ...,
    progress: _Progress | None = ...,
) -> list[str]: ...
def calibrate(
    captures: list[_Path],
    out: _Path,
    *,
    geometry: _Path | None = ...,
    overwrite: bool = ...,
    servo_error: float = ...,
    place_error: float = ...,
    turn_error: float = ...,
    progress: _Progress | None = ...,
) -> dict[str, Any]: ...
def simulate(
    scene: _Path,
    out: _Path,
    *,
    overwrite: bool = ...,
    frames: int = ...,
    seed: int = ...,
    debris: str | None = ...,
    debris_seed: int | None = ...,
    position: tuple[float, float, float] | None = ...,
    pan: float | None = ...,
    tilt: float | None = ...,
    camera_model: str = ...,
    all_colors: bool = ...,
    infrared: bool = ...,
    lamp: bool = ...,
    focal: float = ...,
    baseline: float = ...,
    lens_blur: float = ...,
    misalignment: float = ...,
    rectification: float = ...,
    supersampling: int = ...,
    dots: int = ...,
    dot_share: float = ...,
    bounce: float = ...,
    lamp_light: float = ...,
    exposure: float = ...,
    exposure_target: float = ...,
    gain: float = ...,
    imager_difference: float = ...,
    full_well: float = ...,
    read_noise: float = ...,
    speckle: float = ...,
    speckle_turn: float = ...,
    wander: float = ...,
    wander_frames: float = ...,
    levels: float = ...,
    level_frames: float = ...,
    flicker: float = ...,
    drift: float = ...,
    sway: float = ...,
    window: int = ...,
    depth_unit: float | None = ...,
    device: int = ...,
    progress: _Progress | None = ...,
) -> Capture: ...
