# SPDX-License-Identifier: Apache-2.0
# Types of the package. A test holds them to it: names, parameters and defaults. None is the default of the command.
import os
from collections.abc import Callable, Iterable, Sequence
from datetime import datetime
from typing import Any, Final, Literal, NamedTuple, Protocol, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

_Path = str | os.PathLike[str]
_Point = Sequence[float]
_Colour = float | Sequence[float] | str
_Progress = Callable[[str, float, int, float], object]
_Side = Literal["auto", "front", "back"]

class _Mesh(Protocol):
    @property
    def vertices(self) -> Any: ...
    @property
    def faces(self) -> Any: ...

_AnyScene = _Path | Scene | _Mesh

__version__: Final[str]

class Error(Exception):
    file: str | None
    line: int | None
    hints: tuple[tuple[str, str | None], ...]
    def __init__(self, message: str, hints: Iterable[tuple[str, str | None]] = (), file: str | None = None,
                 line: int | None = None) -> None: ...

class InputError(Error, ValueError): ...
class FormatError(Error): ...
class MismatchError(Error, ValueError): ...
class DeviceError(Error, OSError): ...
class Stopped(Error): ...

class Interval(NamedTuple):
    value: float
    low: float
    high: float
    def __float__(self) -> float: ...
    def holds(self, number: float) -> bool: ...

class SurfaceMeasure(NamedTuple):
    name: str
    side: str
    patches: int
    area: float
    unlit: float
    mean: Interval
    min: Interval
    max: Interval
    min_over_mean: Interval
    min_over_max: Interval
    darkest: int
    brightest: int
    errors: str

class Probes(NamedTuple):
    illuminance: NDArray[np.float64]
    illuminance_error: NDArray[np.float64]
    sampling_error: NDArray[np.float64]
    irradiance: NDArray[np.float64]
    place: NDArray[np.str_]
    reached: NDArray[np.bool_]

class Spheres(NamedTuple):
    coefficients: NDArray[np.float64]
    relative_error: NDArray[np.float64]

class Plane(NamedTuple):
    mean: Interval
    min: Interval
    max: Interval
    uniformity: Interval
    diversity: Interval
    illuminance: NDArray[np.float64]
    illuminance_error: NDArray[np.float64]
    positions: NDArray[np.float64]
    spacing: float
    errors: str
    points_behind: int

class Lightmap(NamedTuple):
    irradiance: NDArray[np.float32]
    irradiance_error: NDArray[np.float32]
    texels: NDArray[np.uint8]
    uv: NDArray[np.float32]
    page: NDArray[np.int32]
    charts: int
    rays: int

class DaylightFactors(NamedTuple):
    factor: NDArray[np.float32]
    factor_error: NDArray[np.float32]
    sky: NDArray[np.float32]
    external: NDArray[np.float32]
    internal: NDArray[np.float32]
    mean: Interval
    median: Interval
    min: Interval
    uniformity: Interval

class PlaneFigures(NamedTuple):
    max_intensity: float
    beam_angle: float
    field_angle: float

class Material:
    name: str
    reflectance: tuple[float, float, float]
    emission: tuple[float, float, float]
    transmittance: tuple[float, float, float] | None
    two_sided: bool
    def __init__(
        self,
        name: str = "default",
        reflectance: float | Sequence[float] = 0.5,
        emission: float | Sequence[float] = 0.0,
        transmittance: float | Sequence[float] | None = None,
        two_sided: bool = True,
    ) -> None: ...

class Scene:
    def __init__(self, handle: Any) -> None: ...
    @staticmethod
    def from_arrays(
        vertices: ArrayLike | _Mesh,
        faces: ArrayLike | None = None,
        materials: Material | Sequence[Material] | dict[str, Any] | None = None,
        face_materials: ArrayLike | None = None,
        *,
        threads: int | None = None,
        progress: _Progress | None = None,
        scale: float | None = None,
        max_reflectance: float | None = None,
        allow_outside: bool | None = None,
        one_sided: str | Sequence[str] | None = None,
        glass: dict[str, float | Sequence[float]] | float | str | Sequence[str] | None = None,
        flip: str | Sequence[str] | None = None,
        weld: float | None = None,
        orient: bool | None = None,
        sky: float | _Point | str | None = None,
        sky_illuminance: float | str | None = None,
        albedo: float | str | None = None,
        direct_normal: float | str | None = None,
        diffuse_horizontal: float | str | None = None,
        dew_point: float | str | None = None,
        sun: tuple[float, float] | str | None = None,
        date: datetime | str | None = None,
        place: tuple[float, float] | str | None = None,
        timezone: float | str | None = None,
        weather: _Path | None = None,
        hour: str | None = None,
        sun_illuminance: float | str | None = None,
        north: float | None = None,
        luminaires: _Path | Sequence[_Path] | None = None,
        luminaire_grid: str | Sequence[str] | None = None,
        spectral: _Path | None = None,
        bands: int | float | str | None = None,
        up: Literal['auto', 'y', 'z'] | None = None,
    ) -> Scene: ...
    @property
    def source(self) -> str: ...
    @property
    def vertices(self) -> NDArray[np.float32]: ...
    @property
    def faces(self) -> NDArray[np.uint32]: ...
    @property
    def face_materials(self) -> NDArray[np.uint32]: ...
    @property
    def face_groups(self) -> NDArray[np.uint32]: ...
    @property
    def materials(self) -> tuple[str, ...]: ...
    @property
    def groups(self) -> tuple[str, ...]: ...
    @property
    def objects(self) -> tuple[str, ...]: ...
    @property
    def origin(self) -> tuple[float, float, float]: ...
    @property
    def has_light(self) -> bool: ...
    @property
    def luminaires(self) -> int: ...
    @property
    def fingerprint(self) -> int: ...

class Solution:
    def __init__(self, handle: Any) -> None: ...
    def close(self) -> None: ...
    def __enter__(self) -> Solution: ...
    def __exit__(self, *_: object) -> None: ...
    def __len__(self) -> int: ...
    @property
    def irradiance(self) -> NDArray[np.float32]: ...
    @property
    def irradiance_back(self) -> NDArray[np.float32]: ...
    @property
    def radiosity(self) -> NDArray[np.float32]: ...
    @property
    def radiosity_back(self) -> NDArray[np.float32]: ...
    @property
    def irradiance_error(self) -> NDArray[np.float32] | None: ...
    @property
    def irradiance_error_back(self) -> NDArray[np.float32] | None: ...
    @property
    def radiosity_error(self) -> NDArray[np.float32] | None: ...
    @property
    def radiosity_error_back(self) -> NDArray[np.float32] | None: ...
    @property
    def illuminance_error(self) -> NDArray[np.float32] | None: ...
    @property
    def illuminance(self) -> NDArray[np.float32]: ...
    @property
    def illuminance_back(self) -> NDArray[np.float32]: ...
    @property
    def lux(self) -> NDArray[np.float32]: ...
    @property
    def areas(self) -> NDArray[np.float32]: ...
    @property
    def normals(self) -> NDArray[np.float32]: ...
    @property
    def vertices(self) -> NDArray[np.float32]: ...
    @property
    def centroids(self) -> NDArray[np.float32]: ...
    @property
    def reflectance(self) -> NDArray[np.float32]: ...
    @property
    def emittance(self) -> NDArray[np.float32]: ...
    @property
    def corners(self) -> NDArray[np.uint32]: ...
    @property
    def triangles(self) -> NDArray[np.uint32]: ...
    @property
    def patch_materials(self) -> NDArray[np.uint32]: ...
    @property
    def materials(self) -> tuple[str, ...]: ...
    @property
    def bands(self) -> tuple[str, ...]: ...
    @property
    def light_groups(self) -> tuple[str, ...]: ...
    @property
    def origin(self) -> tuple[float, float, float]: ...
    @property
    def method(self) -> str: ...
    @property
    def stop(self) -> str: ...
    @property
    def error(self) -> float: ...
    @property
    def mesh_error(self) -> float: ...
    @property
    def rays(self) -> int: ...
    @property
    def facts(self) -> dict[str, Any]: ...
    @property
    def has_transport(self) -> bool: ...
    def replicates(self, *, threads: int | None = None) -> NDArray[np.float32] | None: ...
    def patches_of(self, surface: str, scene: Scene | None = None) -> NDArray[np.uint32]: ...
    @overload
    def measure(
        self, surface: None = None, *, side: _Side = "auto", scene: Scene | None = None, threads: int | None = None
    ) -> list[SurfaceMeasure]: ...
    @overload
    def measure(
        self, surface: str | ArrayLike, *, side: _Side = "auto", scene: Scene | None = None, threads: int | None = None
    ) -> SurfaceMeasure: ...
    def mean(
        self, surface: str | ArrayLike, *, side: _Side = "auto", scene: Scene | None = None, threads: int | None = None
    ) -> Interval: ...
    def probe(
        self,
        positions: ArrayLike,
        normals: ArrayLike = (0.0, 0.0, 1.0),
        *,
        error: float | None = None,
        floor: float | None = None,
        rays: int | None = None,
        seed: int | None = None,
        direct: bool = False,
        threads: int | None = None,
        progress: _Progress | None = None,
    ) -> Probes: ...
    def probe_spheres(
        self,
        positions: ArrayLike,
        count: Literal[4, 9] = 9,
        *,
        error: float | None = None,
        floor: float | None = None,
        rays: int | None = None,
        seed: int | None = None,
        threads: int | None = None,
        progress: _Progress | None = None,
    ) -> Spheres: ...
    def plane(
        self,
        height: float | None = None,
        *,
        polygon: ArrayLike | None = None,
        surface: str | None = None,
        scene: Scene | None = None,
        spacing: float | None = None,
        border: float = 0.0,
        maintenance: float = 1.0,
        error: float | None = None,
        floor: float | None = None,
        rays: int | None = None,
        seed: int | None = None,
        direct: bool = False,
        threads: int | None = None,
        progress: _Progress | None = None,
    ) -> Plane: ...
    def relight(
        self,
        *,
        threads: int | None = None,
        progress: _Progress | None = None,
        light: dict[str, float] | None = None,
        tint: dict[str, _Colour] | None = None,
        off: str | Sequence[str] | None = None,
        reflectance: dict[str, _Colour] | None = None,
    ) -> Solution: ...
    def relighter(self, *, threads: int | None = None) -> Relighter: ...
    def resume(
        self,
        *,
        threads: int | None = None,
        progress: _Progress | None = None,
        rays: int | float | str | None = None,
        error: float | str | None = None,
        error_measure: Literal['seen', 'power'] | None = None,
        time: float | str | None = None,
        ray_budget: int | float | str | None = None,
        cheap_rays: int | float | str | None = None,
        memory: float | str | None = None,
        every: float | str | None = None,
    ) -> Solution: ...
    def save(self, path: _Path) -> None: ...
    def write(
        self,
        path: _Path,
        scene: Scene | None = None,
        scale: float = 1.0,
        *,
        threads: int | None = None,
        progress: _Progress | None = None,
        up: Literal['auto', 'y', 'z'] | None = None,
        crease_angle: float | None = None,
        tone: Literal['neutral', 'reinhard', 'reinhard-local', 'maximum', 'clamp'] | None = None,
        exposure: float | None = None,
        key: float | str | None = None,
        white: float | None = None,
        title: str | None = None,
        for_: Literal['any', 'three', 'babylon', 'godot', 'blender', 'unity', 'unreal'] | None = None,
        as_: Literal['vertex', 'lightmap', 'emissive'] | None = None,
        preserve_topology: bool | None = None,
        simplify: bool | None = None,
        compress: Literal['none', 'quantize', 'meshopt'] | None = None,
        layout: Literal['file', 'new'] | None = None,
        texels_per_metre: float | str | None = None,
        page_size: int | None = None,
        margin: int | None = None,
        final_gather: float | str | None = None,
        gather_rays: int | None = None,
        eye: _Point | None = None,
        target: _Point | None = None,
        fov: float | str | None = None,
        width: int | None = None,
        height: int | None = None,
        samples: int | None = None,
        gather: int | None = None,
        quantity: Literal['radiance', 'luminance', 'illuminance'] | None = None,
        max_value: float | None = None,
    ) -> None: ...
    @overload
    def render(
        self,
        radiance: Literal[False] = False,
        *,
        threads: int | None = None,
        progress: _Progress | None = None,
        up: Literal['auto', 'y', 'z'] | None = None,
        crease_angle: float | None = None,
        tone: Literal['neutral', 'reinhard', 'reinhard-local', 'maximum', 'clamp'] | None = None,
        exposure: float | None = None,
        key: float | str | None = None,
        white: float | None = None,
        title: str | None = None,
        for_: Literal['any', 'three', 'babylon', 'godot', 'blender', 'unity', 'unreal'] | None = None,
        as_: Literal['vertex', 'lightmap', 'emissive'] | None = None,
        preserve_topology: bool | None = None,
        simplify: bool | None = None,
        compress: Literal['none', 'quantize', 'meshopt'] | None = None,
        layout: Literal['file', 'new'] | None = None,
        texels_per_metre: float | str | None = None,
        page_size: int | None = None,
        margin: int | None = None,
        final_gather: float | str | None = None,
        gather_rays: int | None = None,
        eye: _Point | None = None,
        target: _Point | None = None,
        fov: float | str | None = None,
        width: int | None = None,
        height: int | None = None,
        samples: int | None = None,
        gather: int | None = None,
        quantity: Literal['radiance', 'luminance', 'illuminance'] | None = None,
        max_value: float | None = None,
    ) -> NDArray[np.uint8]: ...
    @overload
    def render(
        self,
        radiance: Literal[True],
        *,
        threads: int | None = None,
        progress: _Progress | None = None,
        up: Literal['auto', 'y', 'z'] | None = None,
        crease_angle: float | None = None,
        tone: Literal['neutral', 'reinhard', 'reinhard-local', 'maximum', 'clamp'] | None = None,
        exposure: float | None = None,
        key: float | str | None = None,
        white: float | None = None,
        title: str | None = None,
        for_: Literal['any', 'three', 'babylon', 'godot', 'blender', 'unity', 'unreal'] | None = None,
        as_: Literal['vertex', 'lightmap', 'emissive'] | None = None,
        preserve_topology: bool | None = None,
        simplify: bool | None = None,
        compress: Literal['none', 'quantize', 'meshopt'] | None = None,
        layout: Literal['file', 'new'] | None = None,
        texels_per_metre: float | str | None = None,
        page_size: int | None = None,
        margin: int | None = None,
        final_gather: float | str | None = None,
        gather_rays: int | None = None,
        eye: _Point | None = None,
        target: _Point | None = None,
        fov: float | str | None = None,
        width: int | None = None,
        height: int | None = None,
        samples: int | None = None,
        gather: int | None = None,
        quantity: Literal['radiance', 'luminance', 'illuminance'] | None = None,
        max_value: float | None = None,
    ) -> NDArray[np.float32]: ...
    def lightmap(
        self,
        *,
        texels_per_metre: float | None = None,
        page_size: int | None = None,
        margin: int | None = None,
        crease_angle: float | None = None,
        final_gather: float | None = None,
        gather_rays: int | None = None,
        seed: int | None = None,
        threads: int | None = None,
        progress: _Progress | None = None,
    ) -> Lightmap: ...

class Relighter:
    def __init__(self, handle: Any) -> None: ...
    def light(
        self,
        *,
        threads: int | None = None,
        progress: _Progress | None = None,
        light: dict[str, float] | None = None,
        tint: dict[str, _Colour] | None = None,
        off: str | Sequence[str] | None = None,
        reflectance: dict[str, _Colour] | None = None,
    ) -> Solution: ...

class ViewFactors:
    def __init__(self, handle: Any) -> None: ...
    def __len__(self) -> int: ...
    @property
    def names(self) -> tuple[str, ...]: ...
    @property
    def between(self) -> str: ...
    @property
    def areas(self) -> NDArray[np.float64]: ...
    @property
    def data(self) -> NDArray[np.float64]: ...
    @property
    def environment(self) -> NDArray[np.float64]: ...
    @property
    def backs(self) -> NDArray[np.float64]: ...
    @property
    def dropped(self) -> NDArray[np.float64]: ...
    @property
    def data_error(self) -> NDArray[np.float32]: ...
    @property
    def environment_error(self) -> NDArray[np.float32]: ...
    @property
    def centres(self) -> NDArray[np.float32]: ...
    @property
    def indices(self) -> NDArray[np.uint32]: ...
    @property
    def triangles(self) -> NDArray[np.uint32]: ...
    @property
    def indptr(self) -> NDArray[np.uint64]: ...
    @property
    def enforced(self) -> bool: ...
    @property
    def error(self) -> float: ...
    @property
    def rays(self) -> int: ...
    def csr(self) -> tuple[NDArray[np.float64], NDArray[np.uint32], NDArray[np.uint64]]: ...
    def csr_error(self) -> tuple[NDArray[np.float32], NDArray[np.uint32], NDArray[np.uint64]]: ...
    def toarray(self) -> NDArray[np.float64]: ...
    def save(self, path: _Path) -> None: ...

class Photometry:
    def __init__(self, handle: Any) -> None: ...
    @property
    def file(self) -> str: ...
    @property
    def format(self) -> str: ...
    @property
    def luminaire(self) -> str: ...
    @property
    def catalogue(self) -> str: ...
    @property
    def maker(self) -> str: ...
    @property
    def type(self) -> str: ...
    @property
    def flux(self) -> float: ...
    @property
    def header_flux(self) -> float: ...
    @property
    def max_intensity(self) -> float: ...
    @property
    def downward_fraction(self) -> float: ...
    @property
    def planes(self) -> tuple[PlaneFigures, PlaneFigures]: ...
    @property
    def vertical(self) -> NDArray[np.float64]: ...
    @property
    def horizontal(self) -> NDArray[np.float64]: ...
    @property
    def intensity(self) -> NDArray[np.float64]: ...
    @property
    def size(self) -> tuple[float, float, float]: ...
    @property
    def lamps(self) -> tuple[dict[str, Any], ...]: ...
    @property
    def warnings(self) -> tuple[str, ...]: ...
    def at(self, vertical: ArrayLike, horizontal: ArrayLike) -> Any: ...

class Daylight:
    def __init__(self, handle: Any) -> None: ...
    @property
    def factors(self) -> DaylightFactors: ...
    @property
    def place(self) -> str: ...
    @property
    def times(self) -> NDArray[np.datetime64]: ...
    @property
    def sun_elevation(self) -> NDArray[np.float64]: ...
    @property
    def sun_azimuth(self) -> NDArray[np.float64]: ...
    @property
    def sky_illuminance(self) -> NDArray[np.float64]: ...
    @property
    def sun_illuminance(self) -> NDArray[np.float64]: ...
    @property
    def illuminance(self) -> NDArray[np.float32]: ...
    @property
    def illuminance_error(self) -> NDArray[np.float32]: ...
    @property
    def direct_sun(self) -> NDArray[np.float32]: ...
    @property
    def metrics(self) -> dict[str, Any]: ...
    @property
    def error(self) -> float: ...

class ProgressBar:
    def __init__(self, make: Callable[..., Any]) -> None: ...
    def __call__(self, stage: str, done: float, rays: int, error: float) -> bool: ...
    def close(self) -> None: ...
    def __enter__(self) -> ProgressBar: ...
    def __exit__(self, *_: object) -> None: ...

def bake(
    scene: _AnyScene,
    error: float | str | None = None,
    *,
    threads: int | None = None,
    progress: _Progress | None = None,
    quality: Literal['draft', 'medium', 'final'] | None = None,
    scale: float | None = None,
    max_reflectance: float | None = None,
    allow_outside: bool | None = None,
    one_sided: str | Sequence[str] | None = None,
    glass: dict[str, float | Sequence[float]] | float | str | Sequence[str] | None = None,
    flip: str | Sequence[str] | None = None,
    weld: float | None = None,
    orient: bool | None = None,
    max_edge: float | str | None = None,
    contacts: bool | None = None,
    max_contacts: int | float | str | None = None,
    contact_gap: float | None = None,
    mesh_error: float | str | None = None,
    max_patches: int | float | str | None = None,
    sky: float | _Point | str | None = None,
    sky_illuminance: float | str | None = None,
    albedo: float | str | None = None,
    direct_normal: float | str | None = None,
    diffuse_horizontal: float | str | None = None,
    dew_point: float | str | None = None,
    sun: tuple[float, float] | str | None = None,
    date: datetime | str | None = None,
    place: tuple[float, float] | str | None = None,
    timezone: float | str | None = None,
    weather: _Path | None = None,
    hour: str | None = None,
    sun_illuminance: float | str | None = None,
    north: float | None = None,
    luminaires: _Path | Sequence[_Path] | None = None,
    luminaire_grid: str | Sequence[str] | None = None,
    spectral: _Path | None = None,
    bands: int | float | str | None = None,
    method: Literal['sampled', 'shooting', 'dense', 'hemicube', 'lines'] | None = None,
    rays: int | float | str | None = None,
    seed: int | None = None,
    error_measure: Literal['seen', 'power'] | None = None,
    time: float | str | None = None,
    ray_budget: int | float | str | None = None,
    cheap_rays: int | float | str | None = None,
    focus: str | None = None,
    replicates: int | None = None,
    low_discrepancy: bool | None = None,
    stratified: bool | None = None,
    importance: bool | None = None,
    control_variate: bool | None = None,
    mis: bool | None = None,
    both_ways: bool | None = None,
    smoothing: bool | None = None,
    rays_per_patch: int | None = None,
    tolerance: float | str | None = None,
    solver: Literal['direct', 'jacobi', 'gauss-seidel'] | None = None,
    factor_tolerance: float | None = None,
    elements: Literal['patches', 'faces'] | None = None,
    hemicube_resolution: int | None = None,
    hemicube_points: int | None = None,
    lines: int | None = None,
    steps: int | None = None,
    store_transport: bool | None = None,
    light_group: dict[str, str] | None = None,
    up: Literal['auto', 'y', 'z'] | None = None,
    crease_angle: float | None = None,
    eye: _Point | None = None,
    target: _Point | None = None,
    fov: float | str | None = None,
    width: int | None = None,
    height: int | None = None,
    memory: float | str | None = None,
    force: bool | None = None,
    checkpoint: _Path | None = None,
    every: float | str | None = None,
) -> Solution: ...
def load_scene(
    path: _Path,
    *,
    threads: int | None = None,
    progress: _Progress | None = None,
    scale: float | None = None,
    max_reflectance: float | None = None,
    allow_outside: bool | None = None,
    one_sided: str | Sequence[str] | None = None,
    glass: dict[str, float | Sequence[float]] | float | str | Sequence[str] | None = None,
    flip: str | Sequence[str] | None = None,
    weld: float | None = None,
    orient: bool | None = None,
    sky: float | _Point | str | None = None,
    sky_illuminance: float | str | None = None,
    albedo: float | str | None = None,
    direct_normal: float | str | None = None,
    diffuse_horizontal: float | str | None = None,
    dew_point: float | str | None = None,
    sun: tuple[float, float] | str | None = None,
    date: datetime | str | None = None,
    place: tuple[float, float] | str | None = None,
    timezone: float | str | None = None,
    weather: _Path | None = None,
    hour: str | None = None,
    sun_illuminance: float | str | None = None,
    north: float | None = None,
    luminaires: _Path | Sequence[_Path] | None = None,
    luminaire_grid: str | Sequence[str] | None = None,
    spectral: _Path | None = None,
    bands: int | float | str | None = None,
    up: Literal['auto', 'y', 'z'] | None = None,
) -> Scene: ...
def load(path: _Path, *, progress: _Progress | None = None) -> Solution: ...
def merge(
    solutions: Iterable[Solution | _Path], *, threads: int | None = None, progress: _Progress | None = None
) -> Solution: ...
def view_factors(
    scene: _AnyScene,
    *,
    threads: int | None = None,
    progress: _Progress | None = None,
    scale: float | None = None,
    max_reflectance: float | None = None,
    allow_outside: bool | None = None,
    one_sided: str | Sequence[str] | None = None,
    glass: dict[str, float | Sequence[float]] | float | str | Sequence[str] | None = None,
    flip: str | Sequence[str] | None = None,
    weld: float | None = None,
    orient: bool | None = None,
    max_edge: float | str | None = None,
    between: Literal['groups', 'objects', 'materials', 'patches'] | None = None,
    sides: Literal['front', 'both'] | None = None,
    from_: str | Sequence[str] | None = None,
    error: float | str | None = None,
    rays: int | float | str | None = None,
    min_factor: float | None = None,
    enforce: bool | None = None,
    exact: bool | None = None,
    force: bool | None = None,
    seed: int | None = None,
    replicates: int | None = None,
    compress: bool | None = None,
    memory: float | str | None = None,
) -> ViewFactors: ...
def load_view_factors(path: _Path) -> ViewFactors: ...
def load_photometry(path: _Path, *, lamp_set: int = 1, rotate: float = 0.0) -> Photometry: ...
def daylight(
    scene: _AnyScene,
    positions: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    weather: _Path | None = None,
    north: float = 0.0,
    albedo: float = 0.2,
    sky_patches: Literal[145, 577, 2305] = 577,
    error: float | None = None,
    rays: int | None = None,
    seed: int | None = None,
    max_edge: float | None = None,
    occupied: tuple[float, float] = (8, 18),
    blind_transmittance: float | None = None,
    blinds: dict[str, float] | None = None,
    threads: int | None = None,
    progress: _Progress | None = None,
    **options: Any,
) -> Daylight: ...
