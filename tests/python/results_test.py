# SPDX-License-Identifier: Apache-2.0
"""Files, pictures, other light, points, planes, view factors, photometry and daylight."""
import math
import subprocess

import numpy as np
import pytest

import luxel
from conftest import CUBE, INSIDE, SOURCES, furnace, light_of_furnace

LUX = 179.0  # of 1 W/m² of white


# ---- Files ----

def test_saved_solutions_come_back_to_the_bit(tmp_path, box):
    path = tmp_path / "box.vtkhdf"
    box.save(path)
    with luxel.load(path) as again:
        assert again.irradiance.tobytes() == box.irradiance.tobytes()
        assert again.has_transport and again.light_groups == box.light_groups
        assert again.facts["options"] == box.facts["options"]
        again.save(tmp_path / "copy.vtkhdf")
    assert (tmp_path / "copy.vtkhdf").read_bytes() == path.read_bytes()


@pytest.mark.parametrize("name, options", [("box.glb", []), ("box.ply", []), ("box.png", ["--width", "80", "--height", "60"]),
                                           ("box.exr", ["--width", "80", "--height", "60"])])
def test_written_files_are_those_of_the_command(tmp_path, program, box, name, options):
    solution = tmp_path / "box.vtkhdf"
    box.save(solution)
    command = "export" if name.endswith((".glb", ".ply")) else "render"
    subprocess.run([program, command, str(solution), *options, "-o", str(tmp_path / ("command-" + name)), "--quiet"],
                   check=True, stdout=subprocess.DEVNULL)
    given = {"width": 80, "height": 60} if options else {}
    luxel.load(solution).write(tmp_path / name, **given)
    assert (tmp_path / name).read_bytes() == (tmp_path / ("command-" + name)).read_bytes()


def test_round_trip_needs_its_own_scene(tmp_path, box, box_file):
    scene = luxel.load_scene(box_file)
    box.write(tmp_path / "kept.glb", scene, preserve_topology=True)
    assert (tmp_path / "kept.glb").read_bytes()[:4] == b"glTF"
    with pytest.raises(luxel.MismatchError):
        box.write(tmp_path / "other.glb", furnace())
    with pytest.raises(luxel.InputError, match="expected one of the extensions"):
        box.write(tmp_path / "box.jpg")
    with pytest.raises(luxel.InputError, match="applies to a .glb"):
        box.write(tmp_path / "box.ply", as_="lightmap")


def test_page_is_written_where_it_was_built(tmp_path, box):
    try:
        box.write(tmp_path / "box.html", title="A box")
    except luxel.DeviceError as error:
        pytest.skip(str(error))
    assert "<title>A box" in (tmp_path / "box.html").read_text(encoding="utf-8")


# ---- Pictures ----

def test_pictures_are_arrays(box):
    shown = box.render(width=40, height=30)
    assert shown.shape == (30, 40, 3) and shown.dtype == np.uint8 and not shown.flags.writeable
    radiance = box.render(radiance=True, width=40, height=30)
    assert radiance.shape == (30, 40, 3) and radiance.dtype == np.float32
    assert radiance.max() <= 1.001 * box.radiosity.max() / math.pi * 3.0
    assert shown.std() > 5.0


def test_inside_a_furnace_all_is_of_one_brightness():
    solution = luxel.bake(furnace(0.5, 1.0), method="dense", max_edge=0.0)
    picture = solution.render(radiance=True, width=16, height=16, eye=(0.5, 0.5, 0.5), target=(1, 0.5, 0.5))
    np.testing.assert_allclose(picture, light_of_furnace(0.5, 1.0) / math.pi, rtol=1e-3)


def test_lightmap_of_a_furnace():
    solution = luxel.bake(furnace(0.5, 1.0), method="dense", max_edge=0.0)
    lightmap = solution.lightmap(page_size=64, final_gather=0.0)
    inside = lightmap.texels == 1
    np.testing.assert_allclose(lightmap.irradiance[inside], light_of_furnace(0.5, 1.0), rtol=1e-3)
    assert lightmap.irradiance.shape[0] == lightmap.page.max() + 1
    uv = lightmap.uv[lightmap.page >= 0]
    assert uv.min() >= 0.0 and uv.max() <= 1.0


# ---- Other light ----

def test_light_is_linear_in_the_lamps(box):
    half = box.relight(light={"*": 0.5})
    relative = np.abs(2.0 * half.irradiance - box.irradiance).sum() / box.irradiance.sum()
    assert relative < 0.01  # smoothing and caps are not linear to the last per cent
    dark = box.relight(off=["*"])
    assert dark.irradiance.max() == 0.0


def test_relighter_forgets_what_is_not_named(box):
    relighter = box.relighter()
    original = relighter.light()
    assert relighter.light(off="*").irradiance.max() == 0.0
    assert relighter.light().irradiance.tobytes() == original.irradiance.tobytes()
    black = relighter.light(reflectance={"*": 0.0})
    assert black.irradiance.sum() < original.irradiance.sum()
    assert (black.reflectance == 0.0).all()


def test_relight_names_what_is_missing(box, box_file):
    with pytest.raises(luxel.InputError, match="there is no light group 'desk', but"):
        box.relight(light={"desk": 0.5})
    with pytest.raises(luxel.InputError, match="light x: expected a number from 0"):
        box.relight(light={"x": -1})
    with pytest.raises(luxel.InputError, match="store_transport=True"):
        luxel.bake(box_file, error=0.2, max_edge=0.5).relight(off="*")


# ---- Points and planes ----

def test_probes_in_a_furnace_see_its_light():
    solution = luxel.bake(furnace(0.5, 1.0), error=0.02, max_edge=0.5)
    probes = solution.probe([[0.5, 0.5, 0.5], [0.2, 0.3, 0.4]], [0.0, 0.0, 1.0], error=0.02)
    truth = LUX * light_of_furnace(0.5, 1.0)
    assert (np.abs(probes.illuminance - truth) < 5.0 * probes.illuminance_error + 0.01 * truth).all()
    assert list(probes.place) == ["free", "free"] and probes.reached.all()
    spheres = solution.probe_spheres([[0.5, 0.5, 0.5]], 4)
    # Radiance L from all around: the first coefficient is L * 2 sqrt(pi), the others 0.
    expected = light_of_furnace(0.5, 1.0) / math.pi * 2.0 * math.sqrt(math.pi)
    np.testing.assert_allclose(spheres.coefficients[0, :, 0], expected, rtol=0.05)
    assert np.abs(spheres.coefficients[0, :, 1:]).max() < 0.1 * expected


def test_plane_of_a_furnace_is_uniform():
    solution = luxel.bake(furnace(0.5, 1.0), error=0.02, max_edge=0.5, store_transport=True)
    truth = LUX * light_of_furnace(0.5, 1.0)
    for plane in (solution.plane(0.5, spacing=0.25, border=0.1),
                  solution.plane(polygon=[[0.1, 0.1, 0.5], [0.9, 0.1, 0.5], [0.9, 0.9, 0.5], [0.1, 0.9, 0.5]], spacing=0.25)):
        assert plane.mean.low - 0.01 * truth <= truth <= plane.mean.high + 0.01 * truth
        assert plane.uniformity.high >= 0.99
        assert np.nanmean(plane.illuminance) == pytest.approx(plane.mean.value)
        assert len(plane.positions) == np.isfinite(plane.illuminance).sum()
        assert plane.errors == "replicates"
    halved = solution.plane(0.5, spacing=0.25, border=0.1, maintenance=0.5)
    assert halved.mean.value == pytest.approx(0.5 * solution.plane(0.5, spacing=0.25, border=0.1).mean.value)
    with pytest.raises(luxel.InputError, match="one of height, polygon and surface"):
        solution.plane(0.5, surface="wall")


# ---- View factors ----

def cube_in_groups(**options):
    rows = {f"side{i}": {"reflectance": 0.5} for i in range(6)}
    return luxel.view_factors(luxel.Scene.from_arrays(CUBE, INSIDE, rows, np.repeat(np.arange(6), 2)), between="materials",
                              **options)


def test_exact_view_factors_of_a_cube():
    factors = cube_in_groups(exact=True)
    dense = factors.toarray()
    opposite = 0.19982489569838746  # two faces of a cube: Hamilton and Morgan 1952
    assert len(factors) == 6 and factors.names[0] == "side0"
    np.testing.assert_allclose(dense.sum(axis=1), 1.0, atol=1e-6)
    np.testing.assert_allclose(np.diag(dense), 0.0, atol=1e-9)
    np.testing.assert_allclose([dense[0, 1], dense[2, 3], dense[4, 5]], opposite, atol=1e-6)
    np.testing.assert_allclose(factors.areas, 1.0)


def test_counted_view_factors_are_sparse_and_covered():
    factors = cube_in_groups(error=0.002, enforce=True)
    exact = cube_in_groups(exact=True).toarray()
    sparse = pytest.importorskip("scipy.sparse")
    matrix = sparse.csr_matrix(factors.csr(), shape=(6, 6))
    errors = sparse.csr_matrix(factors.csr_error(), shape=(6, 6)).toarray()
    assert (np.abs(matrix.toarray() - exact) < 5.0 * errors + 1e-6).all()
    np.testing.assert_allclose(np.asarray(matrix.sum(axis=1)).ravel() + factors.environment + factors.backs, 1.0, atol=1e-6)
    assert factors.enforced and not factors.data.flags.writeable


def test_view_factors_between_patches_and_their_file(tmp_path):
    factors = luxel.view_factors(furnace(), between="patches", max_edge=0.5, rays=256)
    assert factors.centres.shape == (len(factors), 3)
    np.testing.assert_allclose(factors.areas.sum(), 6.0, rtol=1e-5)
    factors.save(tmp_path / "cube.h5")
    again = luxel.load_view_factors(tmp_path / "cube.h5")
    assert again.data.tobytes() == factors.data.tobytes() and again.between == "patches"
    with pytest.raises(luxel.InputError, match="expected one of the extensions"):
        factors.save(tmp_path / "cube.txt")


# ---- Photometry ----

def test_photometry_of_a_file():
    photometry = luxel.load_photometry(SOURCES / "scenes" / "luminaires" / "led-panel.ies")
    angles = np.radians(photometry.vertical)
    # The flux of an intensity that depends on gamma alone, by the trapezoid rule over the solid angle.
    mean = photometry.intensity.mean(axis=0)
    flux = 2.0 * math.pi * np.trapz(mean * np.sin(angles), angles)
    assert photometry.flux == pytest.approx(flux, rel=0.05)
    assert photometry.intensity.shape == (len(photometry.horizontal), len(photometry.vertical))
    assert photometry.at(photometry.vertical[0], photometry.horizontal[0]) == photometry.intensity[0, 0]
    assert photometry.at([[0.0, 30.0]], 0.0).shape == (1, 2)
    assert photometry.max_intensity == pytest.approx(photometry.intensity.max())
    assert 0.0 <= photometry.downward_fraction <= 1.0 and photometry.planes[0].beam_angle > 0.0
    with pytest.raises(luxel.InputError):
        luxel.load_photometry(SOURCES / "README.md")


def test_luminaires_light_a_scene():
    panel = SOURCES / "scenes" / "luminaires" / "led-panel.ies"
    scene = luxel.Scene.from_arrays(4.0 * CUBE, INSIDE, luxel.Material("wall", 0.5), luminaire_grid=f"{panel}:2x2@3.5", up="z")
    assert scene.luminaires == 4
    solution = luxel.bake(scene, error=0.1, max_edge=0.5)
    # In a closed room all light is absorbed in the end: flux = (1 - rho) * area * mean illuminance.
    flux = 4.0 * luxel.load_photometry(panel).flux
    absorbed = 0.5 * np.sum(solution.areas * solution.illuminance)
    assert absorbed == pytest.approx(flux, rel=0.05)


# ---- Daylight ----

def open_box():
    """A floor of 2 m by 2 m below the open sky."""
    vertices = np.array([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0.0]])
    return luxel.Scene.from_arrays(vertices, [[0, 1, 2], [0, 2, 3]], luxel.Material("floor", 0.2), up="z")


def test_daylight_factor_in_the_open_is_one():
    daylight = luxel.daylight(open_box(), [[1.0, 1.0, 0.5], [0.5, 0.5, 0.5]], (0, 0, 1), sky_patches=145, error=0.1)
    factors = daylight.factors
    np.testing.assert_allclose(factors.factor, 1.0, atol=0.02)
    np.testing.assert_allclose(factors.sky + factors.external + factors.internal, factors.factor, rtol=1e-4)
    assert factors.mean.low <= factors.mean.value <= factors.mean.high
    assert len(daylight.times) == 0
    with pytest.raises(luxel.InputError, match="weather="):
        _ = daylight.illuminance


def test_hours_of_a_year(tmp_path):
    rows = ["place test", "latitude 48", "longitude -11", "time_zone -15", "site_elevation 500", "weather_data_file_units 1"]
    rows += [f"6 21 {hour + 0.5:.1f} 500 150" for hour in range(6, 18)]
    (tmp_path / "day.wea").write_text("\n".join(rows) + "\n", encoding="utf-8")
    daylight = luxel.daylight(open_box(), [[1.0, 1.0, 0.5]], weather=tmp_path / "day.wea", sky_patches=145, error=0.1)
    assert daylight.times.dtype == np.dtype("datetime64[m]") and len(daylight.times) == 12
    assert str(daylight.times[0]) == "2023-06-21T06:30"
    assert daylight.illuminance.shape == daylight.illuminance_error.shape == (12, 1)
    outside = daylight.sky_illuminance + daylight.sun_illuminance * np.sin(np.radians(daylight.sun_elevation))
    np.testing.assert_allclose(daylight.illuminance[:, 0], outside, rtol=0.05)
    np.testing.assert_allclose(daylight.direct_sun[:, 0],
                               daylight.sun_illuminance * np.sin(np.radians(daylight.sun_elevation)), rtol=0.02)
    metrics = daylight.metrics
    assert metrics["daylight_autonomy"].shape == (1,) and metrics["sDA"].value == pytest.approx(1.0)
