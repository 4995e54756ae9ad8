# SPDX-License-Identifier: GPL-3.0-or-later
# Made by `python -m corticle.sections > python/corticle/sections.pyi`; a test says when that is due.
from typing import Any, Optional, Sequence

def is_in_list(key: str) -> bool: ...

class Section:
    def __init__(self, case: Any) -> None: ...

class Geometry(Section):
    shape: str
    radius_mm: float
    semi_axes_mm: Sequence[float]
    size_mm: Sequence[float]
    file: str
    unit: str
    coordinates: str
    repair: str
    wrap_alpha_mm: float
    wrap_offset_mm: float
    labels: Sequence[int]
    image_volume: Optional[int]
    threshold: Optional[float]
    closing_mm: Optional[float]
    fill_cavities: bool
    smoothing_mm: Optional[float]
    remove_handles: bool
    hemisphere: str
    spacing_mm: Optional[float]
    particles: int
    grading: float
    seed: int
    arrangement: str
    volumes: str
    normals: str
    normal_divisions: int

class Map(Section):
    growth_file: str
    growth_array: str
    growth_times: Sequence[float]
    thickness_file: str
    thickness_array: str
    still_file: str
    still_array: str
    region_file: str
    region_array: str
    region_table: str
    modes: Sequence[float]
    protomap_amplitude: float
    protomap_wavelength_mm: Optional[float]
    protomap_seed: Optional[int]

class Tissue(Section):
    layer: str
    thickness_preset: str
    thickness_mm: float
    thickness_rate_mm: float
    lambda_: float
    mu_cortex: float
    mu_white: float
    mu_deep: float
    mu_ventricle: float
    mu_still: float
    bulk: str
    bulk_modulus: float
    bulk_ratio_cortex: Optional[float]
    bulk_ratio_white: Optional[float]
    bulk_ratio_deep: Optional[float]
    bulk_ratio_ventricle: Optional[float]
    bulk_ratio_still: Optional[float]
    alpha_t: float
    alpha_r: float
    alpha_white: float
    growth_law: str
    growth_onset: float
    growth_rate: float
    normal: str
    barrier_J: float
    @property
    def labels(self) -> TissueLabels: ...

class TissueLabels(Section):
    cortex: Sequence[int]
    white: Sequence[int]
    deep: Sequence[int]
    ventricle: Sequence[int]
    still: Sequence[int]

class Growth(Section):
    law: str
    table: str

class Fibres(Section):
    direction: str
    file: str
    stiffness: Optional[float]
    active_stress: Optional[float]
    ramp: Optional[float]
    growth_rate: Optional[float]
    growth_stretch: Optional[float]

class Relaxation(Section):
    share: float
    time: Optional[float]

class Stress_growth(Section):
    rate: float
    volume_ratio: Optional[float]
    shrinks: Optional[bool]

class Imperfection(Section):
    amplitude: float
    seed: int
    shortest: float
    longest: float

class Solver(Section):
    method: str
    elements: Optional[int]
    formulation: str
    support: float
    kernel_mm: float
    zeta: float
    integrator: str
    time_step: float
    cfl: float
    loading_time: float
    fastest_loading: float
    slowest_loading: float
    damping: float
    max_halvings: int

class Thesis(Section):
    growth: Optional[str]
    force: Optional[str]
    gradient: Optional[str]
    viscosity_alpha: Optional[float]
    viscosity_beta: Optional[float]

class Contact(Section):
    enabled: bool
    distance: float
    stiffness: float

class Time(Section):
    start: float
    end: float
    clock: str
    start_week: Optional[float]
    end_week: Optional[float]

class Size(Section):
    law: str
    applies_to: str
    thin_cortex: bool
    scaled: bool

class Output(Section):
    count: int
    times: Sequence[float]
    weeks: Sequence[float]
    pictures: str
    picture_times: Sequence[float]
    report: str
    checkpoint_minutes: float

class Boundary(Section):
    shape: str
    offset_mm: float
    semi_axes_mm: Sequence[float]
    centre_mm: Sequence[float]
    file: str
    kind: str
    stiffness: float
    times: Sequence[float]
    weeks: Sequence[float]
    scales: Sequence[float]
    fluid: str
    pressure: float
    pressure_time: float
    bulk_modulus: float
    ventricle_pressure: float

class Tracts(Section):
    file: str
    stiffness: float
    rest: float
    ramp_time: float
    growth_rate: float
    pushes: bool
    reach_mm: float

class Support(Section):
    def __getitem__(self, number: int) -> Support1: ...
    def __len__(self) -> int: ...

class Support1(Section):
    kind: Optional[str]
    plane: Optional[str]
    low_mm: Optional[Sequence[float]]
    high_mm: Optional[Sequence[float]]
    axes: Optional[str]
    displacement_mm: Optional[Sequence[float]]
    start: Optional[float]
    end: Optional[float]
    start_week: Optional[float]
    end_week: Optional[float]

class Sections:
    def __init__(self) -> None: ...
    @property
    def geometry(self) -> Geometry: ...
    @property
    def map(self) -> Map: ...
    @property
    def tissue(self) -> Tissue: ...
    @property
    def growth(self) -> Growth: ...
    @property
    def fibres(self) -> Fibres: ...
    @property
    def relaxation(self) -> Relaxation: ...
    @property
    def stress_growth(self) -> Stress_growth: ...
    @property
    def imperfection(self) -> Imperfection: ...
    @property
    def solver(self) -> Solver: ...
    @property
    def thesis(self) -> Thesis: ...
    @property
    def contact(self) -> Contact: ...
    @property
    def time(self) -> Time: ...
    @property
    def size(self) -> Size: ...
    @property
    def output(self) -> Output: ...
    @property
    def boundary(self) -> Boundary: ...
    @property
    def tracts(self) -> Tracts: ...
    @property
    def support(self) -> Support: ...
