# SPDX-License-Identifier: Apache-2.0
"""The figures that are pictures. Each function makes its files in `folder`, and returns what it measured."""
import math
import os
import shutil

from figures import ply, png
from figures.scenes import BOX, view
from figures.table import table

STEPS = (1, 2, 3, 10)
MESHES = {"coarse": 0.28, "middle": 0.07, "fine": 0.018}  # longest edges, m
METHODS = {"sampled": ("--error", "1%"), "shooting": (), "dense": (), "hemicube": (),
           "lines": ()}
LOOK = ("--tone", "clamp", "--exposure", "1.8")  # the same for every picture, band by band


def jacobi_steps(luxel, folder):
    """The Cornell box after so many bounces, by hemicubes."""
    steps = luxel.at("steps")
    shutil.rmtree(steps, ignore_errors=True)
    report = luxel.run("bake", BOX, "--method", "hemicube", "--max-edge", luxel.choose(0.07, 0.3), "--steps", STEPS[-1],
                       "--tolerance", "1e-9", "--each-step", steps, "-o", luxel.at("hemicube.vtkhdf"),
                       *view(luxel.choose(300, 60)))
    for step in STEPS:
        shutil.copyfile(os.path.join(steps, f"step-{step:03}.png"), os.path.join(folder, f"jacobi-step-{step}.png"))
    unshot = [step["unshot_fraction"] for step in report["solve"]["steps"]]
    return {"patches": report["solution"]["patches"], "unshot_fraction": unshot}


def too_few_patches(luxel, folder):
    """One light on three meshes, each patch as it is and smoothed, and path-traced, which has no patches."""
    measured = {}
    for word, edge in MESHES.items():
        solution = luxel.at(f"patches-{word}.vtkhdf")
        report = luxel.run("bake", BOX, "--max-edge", edge, "--error", luxel.choose("1%", "8%"), "-o", solution)
        for look, angle in (("flat", 0), ("smooth", 30)):
            luxel.run("render", solution, "--crease-angle", angle, *LOOK, *view(luxel.choose(300, 60)),
                      "-o", os.path.join(folder, f"patches-{word}-{look}.png"))
        measured[word] = {"max_edge_m": edge, "patches": report["solution"]["patches"]}
    luxel.run("reference", BOX, "--samples", luxel.choose(512, 16), *LOOK, *view(luxel.choose(300, 60)), "-o",
              os.path.join(folder, "patches-none.png"))
    return measured


def noise(light, truth):
    """Relative RMS over triangles of what is wrong with (brightness, colour): the mean over bands, and what each band
    has beside it. Every band is held against its own mean."""
    mean = [sum(v[b] for v in truth.values()) / len(truth) for b in range(3)]
    brightness = colour = 0.0
    for place, true in truth.items():
        off = [(s - t) / m for s, t, m in zip(light[place], true, mean)]
        grey = sum(off) / 3
        brightness += grey**2
        colour += sum((o - grey)**2 for o in off) / 3
    return {"brightness": math.sqrt(brightness / len(truth)), "colour": math.sqrt(colour / len(truth))}


def colour_noise(luxel, folder):
    """Three runs, of which each band is taken from one, beside one run that carries all bands on the same rays."""
    rays = luxel.choose(150_000, 3_000)
    mesh = ("--max-edge", luxel.choose(0.07, 0.3), "--crease-angle", 0)

    def bake(name, *words):
        luxel.run("bake", BOX, *mesh, *words, *LOOK, *view(luxel.choose(300, 60)), "-o", luxel.at(f"{name}.png"),
                  "-o", luxel.at(f"{name}.ply"))
        return ply.irradiance(luxel.at(f"{name}.ply"))

    truth = bake("noise-truth", "--error", luxel.choose("0.5%", "8%"))
    shared = bake("noise-shared", "--method", "shooting", "--rays", rays)
    shutil.copyfile(luxel.at("noise-shared.png"), os.path.join(folder, "noise-shared.png"))
    measured = {"shared": {"rays_at_first": rays, "noise": noise({place: light_of(shared, place) for place in truth},
                                                                       truth)}}
    for word, share in (("separate", rays // 3), ("separate-thrice", rays)):
        names = [f"noise-{word}-{seed}" for seed in (1, 2, 3)]
        runs = [bake(name, "--method", "shooting", "--rays", share, "--seed", seed)
                for seed, name in enumerate(names, 1)]
        png.band_of_each(os.path.join(folder, f"noise-{word}.png"), [luxel.at(f"{name}.png") for name in names])
        measured[word] = {"rays_at_first": 3 * share,
                          "noise": noise({place: tuple(light_of(run, place)[band] for band, run in enumerate(runs))
                                          for place in truth}, truth)}
    write_noise(os.path.join(folder, "noise.svg"), measured)
    return measured


def light_of(run, place):
    """None where no ray came."""
    return run.get(place, (0.0, 0.0, 0.0))


def write_noise(path, measured):
    names = {"shared": "shared rays", "separate": "three runs, the same rays in all",
             "separate-thrice": "three runs, as many rays each"}
    rows = [[name, f"{measured[word]['rays_at_first']:,}", *(f"{100 * measured[word]['noise'][what]:.1f} %"
                                                           for what in ("brightness", "colour"))]
            for word, name in names.items()]
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(table("Noise of the pictures above", ["", "first rays", "noise of brightness", "noise of colour"],
                         rows))


def beside_path_tracing(luxel, folder):
    """Each method's picture and how it differs from the path-traced one: from the light as it is, pixel by pixel, and
    from the light that radiosity on the same mesh has, patch by patch."""
    size = view(luxel.choose(240, 40))
    paths, picture = luxel.at("paths.exr"), os.path.join(folder, "method-path-traced.png")
    luxel.run("reference", BOX, "--samples", luxel.choose(400, 16), *size, *LOOK, "-o", paths, "-o", picture)
    truth = luxel.at("paths.vtkhdf")
    luxel.run("reference", BOX, "--max-edge", 0.2, "--bounces-from", "patches", "--samples", luxel.choose(32768, 16),
              "-o", truth)
    measured = {}
    for method, words in METHODS.items():
        light, seen = luxel.at(f"method-{method}.exr"), os.path.join(folder, f"method-{method}.png")
        fine = 0.2 if method == "dense" else luxel.choose(0.07, 0.3)
        baked = luxel.run("bake", BOX, "--method", method, *words, "--max-edge", fine, *size, *LOOK, "-o", light,
                          "-o", seen, "-o", luxel.at(f"method-{method}.vtkhdf"))
        pixels = luxel.run("compare", paths, light, "--scale", "40%", "-o",
                           os.path.join(folder, f"method-{method}-difference.png"))
        coarse = luxel.at(f"method-{method}.vtkhdf")
        if method != "dense":
            coarse = luxel.at(f"method-{method}-coarse.vtkhdf")
            luxel.run("bake", BOX, "--method", method, *words, "--max-edge", 0.2, "-o", coarse)
        sides = luxel.run("compare", truth, coarse, "--scale", "10%", *size, "-o",
                          os.path.join(folder, f"method-{method}-patches.png"))
        measured[method] = {"patches": baked["solution"]["patches"], "cpu_seconds": baked["cpu_seconds"],
                            "picture_rms": pixels["relative_rms"], "patch_rms": sides["relative_rms"]}
    gathered = luxel.at("method-gathered.exr")
    luxel.run("render", luxel.at("method-sampled.vtkhdf"), "--gather", luxel.choose(100, 4), *size, *LOOK, "-o",
              gathered, "-o", os.path.join(folder, "method-gathered.png"))
    pixels = luxel.run("compare", paths, gathered, "--scale", "40%", "-o",
                       os.path.join(folder, "method-gathered-difference.png"))
    measured["gathered"] = {"picture_rms": pixels["relative_rms"]}
    return measured
