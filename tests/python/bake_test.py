# SPDX-License-Identifier: Apache-2.0
"""bake(): the truth, the command's bytes, threads, stops and interrupts."""
import inspect
import logging
import pathlib
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import luxel
from conftest import furnace, light_of_furnace


def test_closed_enclosure_has_its_exact_irradiance():
    solution = luxel.bake(furnace(0.5, 1.0), method="dense", max_edge=0.0)
    np.testing.assert_allclose(solution.irradiance, light_of_furnace(0.5, 1.0), rtol=2e-4)
    np.testing.assert_allclose(solution.radiosity, light_of_furnace(0.5, 1.0), rtol=2e-4)


def test_intervals_of_the_sampled_solver_hold_the_truth():
    truth = light_of_furnace(0.7, 2.0)
    solution = luxel.bake(furnace(0.7, 2.0), error=0.02, max_edge=0.5)
    # The light of a furnace has no noise but that of its direct part; a bar of five errors and rounding.
    allowed = 5.0 * solution.irradiance_error + 1e-3 * truth
    assert (np.abs(solution.irradiance - truth) < allowed).all()
    mean = solution.mean("wall")
    assert mean.low - 1e-3 * mean.value <= 179.0 * truth <= mean.high + 1e-3 * mean.value


@pytest.mark.parametrize("options, flags", [
    ({"quality": "draft"}, ["--quality", "draft"]),
    ({"error": "8%", "max_edge": 0.4, "seed": 7, "store_transport": True, "light_group": {"top": "lamp*"}},
     ["--error", "8%", "--max-edge", "0.4", "--seed", "7", "--store-transport", "--light-group", "top=lamp*"]),
    ({"method": "shooting", "tolerance": 0.01, "max_edge": 0.4, "sky": 0.5, "one_sided": ["green", "red"],
      "contacts": False, "eye": (0, 1, 4)},
     ["--method", "shooting", "--tolerance", "0.01", "--max-edge", "0.4", "--sky", "0.5", "--one-sided", "green",
      "--one-sided", "red", "--contacts", "off", "--eye", "0,1,4"]),
    ({"focus": "camera", "error": 0.2, "max_edge": 0.5, "width": 200, "height": 100, "max_reflectance": 0.6},
     ["--focus", "camera", "--error", "20%", "--max-edge", "0.5", "--width", "200", "--height", "100",
      "--max-reflectance", "0.6"]),
])
def test_same_bytes_as_the_command(tmp_path, program, box_file, options, flags):
    command = tmp_path / "command.vtkhdf"
    subprocess.run([program, "bake", str(box_file), *flags, "-o", str(command), "--quiet"], check=True,
                   stdout=subprocess.DEVNULL)
    ours = tmp_path / "ours.vtkhdf"
    luxel.bake(str(box_file), **options).save(ours)
    assert command.read_bytes() == ours.read_bytes()


def test_threads_change_no_bit(box_file):
    one, two = (luxel.bake(box_file, error=0.2, max_edge=0.5, threads=threads) for threads in (1, 3))
    assert one.irradiance.tobytes() == two.irradiance.tobytes()
    assert one.irradiance_error.tobytes() == two.irradiance_error.tobytes()


def test_seed_is_the_only_source_of_chance(box_file):
    first, again, other = (luxel.bake(box_file, error=0.2, max_edge=0.5, seed=seed) for seed in (1, 1, 2))
    assert first.irradiance.tobytes() == again.irradiance.tobytes()
    assert first.irradiance.tobytes() != other.irradiance.tobytes()


def test_path_and_scene_are_one(box_file):
    scene = luxel.load_scene(box_file)
    by_path = luxel.bake(pathlib.Path(box_file), error=0.2, max_edge=0.5)
    by_scene = luxel.bake(scene, error=0.2, max_edge=0.5)
    assert by_path.irradiance.tobytes() == by_scene.irradiance.tobytes()
    assert by_path.facts["command_line"] == by_scene.facts["command_line"]


def test_every_option_is_an_argument():
    parameters = inspect.signature(luxel.bake).parameters
    for option in luxel._core.options_of("bake"):
        if option["heading"] in ("Scene", "Sky", "Patches") or option["heading"].startswith("Light"):
            name = option["name"].replace("-", "_")
            assert name in parameters, name
            assert name in luxel.bake.__doc__, name


def test_progress_sees_all_stages_and_can_stop(box_file):
    seen = []
    luxel.bake(box_file, error=0.2, max_edge=0.5, progress=lambda *p: seen.append(p))
    stages = [stage for stage, *_ in seen]
    assert "light" in stages and "patches" in stages
    assert all(0.0 <= done <= 1.0 and error >= 0.0 for _, done, _, error in seen)

    def stop_in_light(stage, done, rays, error):
        return not (stage == "light" and error > 0.0)

    stopped = luxel.bake(box_file, error=0.0005, max_edge=0.2, progress=stop_in_light)
    assert stopped.stop == "stopped_by_user"
    assert stopped.irradiance.max() > 0.0


def test_stop_before_light_raises(box_file):
    with pytest.raises(luxel.Stopped):
        luxel.bake(box_file, progress=lambda *_: False)


def test_errors_of_a_progress_function_come_through(box_file):
    def fail(*_):
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        luxel.bake(box_file, progress=fail)


class FakeBar:
    """What ProgressBar needs of tqdm."""

    made = []

    def __init__(self, total):
        self.total, self.n, self.closed, self.name = total, 0.0, False, None
        FakeBar.made.append(self)

    def set_description(self, name):
        self.name = name

    def update(self, by):
        assert by > 0.0
        self.n += by

    def refresh(self):
        pass

    def close(self):
        self.closed = True


def test_progress_bar_draws_on_a_bar_like_that_of_tqdm(box_file):
    FakeBar.made.clear()
    with luxel.ProgressBar(FakeBar) as bar:
        luxel.bake(box_file, error=0.2, max_edge=0.5, progress=bar)
    assert {b.name for b in FakeBar.made} >= {"patches", "light"}
    assert all(b.closed and 0.0 <= b.n <= 100.0 for b in FakeBar.made)


def test_progress_bar_draws_on_tqdm(box_file):
    tqdm = pytest.importorskip("tqdm")
    with luxel.ProgressBar(lambda total: tqdm.tqdm(total=total, file=open("/dev/null", "w", encoding="utf-8"))) as bar:
        luxel.bake(box_file, error=0.2, max_edge=0.5, progress=bar)


def test_ctrl_c_ends_a_bake_within_a_second(box_file):
    code = ("import luxel, sys, time\n"
            "def show(stage, done, rays, error):\n"
            "    if stage == 'light' and rays > 0: print('light', flush=True)\n"
            "try:\n"
            f"    luxel.bake({str(box_file)!r}, error=0.0002, max_edge=0.05, progress=show)\n"
            "except KeyboardInterrupt:\n"
            "    print('interrupted', flush=True)\n"
            "    sys.exit(0)\n"
            "sys.exit(1)\n")
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "light\n"
        process.send_signal(signal.SIGINT)
        rest, _ = process.communicate(timeout=60)
        assert "interrupted" in rest
        assert process.returncode == 0


def test_other_threads_of_the_program_go_on(box_file):
    counted, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    before = counted[0]
    luxel.bake(box_file, error=0.1, max_edge=0.2)
    during = counted[0] - before
    stop.set()
    thread.join()
    assert during > 10  # a bake that keeps the lock lets through one or none


def test_two_bakes_at_once_are_those_apart(box_file):
    alone = luxel.bake(box_file, error=0.2, max_edge=0.5).irradiance.tobytes()
    found = []
    threads = [threading.Thread(target=lambda: found.append(luxel.bake(box_file, error=0.2, max_edge=0.5))) for _ in "ab"]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [s.irradiance.tobytes() for s in found] == [alone, alone]


def test_warnings_go_to_the_logger(caplog):
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 0, 1.0]])
    with caplog.at_level(logging.INFO, "luxel"):
        luxel.bake(luxel.Scene.from_arrays(vertices, [[0, 2, 1]]), error=0.2, max_edge=0.0)
    assert any("sky" in record.message for record in caplog.records)  # the default light
    assert not any("--" in record.message for record in caplog.records)


def test_resumed_run_is_the_uninterrupted_one(box_file):
    rough = luxel.bake(box_file, error=0.2, max_edge=0.5, store_transport=True)
    fine = luxel.bake(box_file, error=0.05, max_edge=0.5, store_transport=True)
    resumed = rough.resume(error=0.05)
    assert resumed.irradiance.tobytes() == fine.irradiance.tobytes()
    assert resumed.error <= 0.05
    with pytest.raises(luxel.InputError, match="store_transport=True"):
        luxel.bake(box_file, error=0.2, max_edge=0.5).resume(error=0.05)


def test_merged_solutions_have_a_smaller_error(box_file):
    parts = [luxel.bake(box_file, error=0.1, max_edge=0.4, mesh_error="none", seed=seed) for seed in (1, 2, 3)]
    merged = luxel.merge(parts)
    assert merged.error < min(part.error for part in parts)
    assert merged.rays == sum(part.rays for part in parts)
    with pytest.raises(luxel.InputError):
        luxel.merge([parts[0], parts[0]])
    with pytest.raises(luxel.InputError, match="two or more"):
        luxel.merge(parts[:1])
