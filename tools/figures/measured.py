# SPDX-License-Identifier: Apache-2.0
"""The figures that are charts and tables. Each function makes its files in `folder`, and returns what it measured."""
import json
import math
import os

import draw_charts
from figures import ply
from figures.scenes import BOX, FURNACE_RADIANCE, FURNACE_REFLECTANCES, write_furnace
from figures.table import table

# How each method is asked for less and less error: for so many seconds that no point takes a minute.
SETTINGS = {
    "sampled": [("--error", e) for e in ("2%", "1%", "0.5%", "0.2%", "0.1%")],
    "shooting": [("--rays", n) for n in ("30k", "100k", "300k", "1M", "3M", "10M")],
    "lines": [("--lines", n) for n in (100, 300, 1000, 3000, 10000, 30000)],
    "hemicube": [("--hemicube-resolution", pixels, "--hemicube-points", points)
                 for pixels, points in ((32, 1), (64, 1), (64, 4), (64, 16))],
    "dense": [("--factor-tolerance", t) for t in ("1e-1", "1e-2", "1e-3")],
}
PATHS = (16, 64, 256, 1024, 4096)
SMALL = {"sampled": [("--error", "8%"), ("--error", "4%")]}


def write(folder, name, text):
    with open(os.path.join(folder, name), "w", encoding="utf-8", newline="\n") as file:
        file.write(text)


def error_against_time(luxel, folder):
    """Every method on one mesh of the Cornell box: how far off its light is, against the processor time it took."""
    mesh = ("--max-edge", luxel.choose(0.2, 0.4))
    truth, guess = luxel.at("error-truth.vtkhdf"), luxel.at("error-guess.vtkhdf")
    luxel.run("bake", BOX, *mesh, "--method", "dense", "--factor-tolerance", luxel.choose("1e-4", "1e-1"), "-o", truth)

    def measure(words, setting):
        report = luxel.run(*words, *mesh, *setting, "-o", guess)
        return {"setting": " ".join(map(str, setting)), "cpu_seconds": report["cpu_seconds"],
                "true_error": luxel.run("compare", truth, guess)["relative_rms"],
                "patches": report["solution"]["patches"]}

    runs = {method: [measure(("bake", BOX, "--method", method), s) for s in settings]
            for method, settings in luxel.choose(SETTINGS, SMALL).items()}
    runs["path tracing"] = [measure(("reference", BOX, "--bounces-from", "patches"), ("--samples", n))
                            for n in luxel.choose(PATHS, PATHS[:2])]
    result = {"patches": runs["sampled"][0]["patches"], "methods": runs}
    write(folder, "error-of-methods.svg", draw_charts.methods_chart(result))
    return result


def furnace(luxel, folder):
    """In a closed room whose walls all emit and reflect alike, light is the same everywhere: E / (1 - rho)."""
    room, lit = write_furnace(luxel.place), luxel.at("furnace.ply")
    exact, result = [1 / (1 - rho) for rho in FURNACE_REFLECTANCES], []
    for method in ("sampled", "shooting", "dense", "hemicube", "lines"):
        luxel.run("bake", room, "--method", method, "--max-edge", 1.0, "--crease-angle", 0, "-o", lit)
        light = [[h / (math.pi * FURNACE_RADIANCE) for h in patch] for patch in ply.irradiance(lit).values()]
        result.append({"method": method, "mean": [sum(v[b] for v in light) / len(light) for b in range(3)],
                       "farthest_off": [max(abs(v[b] / x - 1) for v in light) for b, x in enumerate(exact)]})
    rows = [["exact: 1 / (1 − ρ)", *(f"{x:.4f}" for x in exact)]]
    rows += [[r["method"], *(f"{m:.4f} ({100 * off:.4f} %)" for m, off in zip(r["mean"], r["farthest_off"]))]
             for r in result]
    write(folder, "furnace.svg", table("A furnace: radiosity over emittance (and how far off the worst patch is)",
                                       ["", *(f"reflectance {rho}" for rho in FURNACE_REFLECTANCES)], rows))
    return result


def bench(luxel, folder):
    """The charts of time against polygons and lamps; what out/bench.json has of them is not measured again."""
    file = luxel.at("bench.json") if luxel.small else os.path.join(os.path.dirname(luxel.place), "bench.json")
    wanted = {"time_against_polygons": "polygons", "time_against_lamps": "lamps"}
    kept = {}
    if os.path.exists(file):
        with open(file, encoding="utf-8") as text:
            kept = json.load(text)
    missing = [section for key, section in wanted.items() if key not in kept]
    if missing:
        luxel.bench(file, *missing)
        with open(file, encoding="utf-8") as text:
            kept = json.load(text)
    write(folder, "time-against-polygons.svg", draw_charts.polygons_chart(kept["time_against_polygons"]))
    write(folder, "time-against-lamps.svg", draw_charts.lamps_chart(kept["time_against_lamps"]))
    return {key: kept[key] for key in wanted}
