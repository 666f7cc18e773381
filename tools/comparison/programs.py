# SPDX-License-Identifier: Apache-2.0
"""The compared programs. Each renders a Scene to linear radiance, and reports the processor time of the whole process.

Each has `name`, `ladder(quick)`: [(label, setting)] from fast to slow; `problem()`: a sentence if it cannot be used
here, or None; and `render(scene, setting, seed)`: (picture (height, width, 3), seconds of processor time).
"""
import json
import os
import re
import shutil
import subprocess

import numpy

from comparison import exr
from comparison.scenes import words

HERE = os.path.dirname(os.path.abspath(__file__))


class Job:
    """Common settings of all renderings: folder, picture size in pixels, number of threads."""

    def __init__(self, folder, width, height, threads):
        self.folder, self.width, self.height, self.threads = folder, width, height, threads

    def at(self, name):
        return os.path.join(self.folder, name)

    def run(self, command, name):
        """Runs the command, its output to NAME.log; returns its processor time with that of its children, s."""
        environment = {**os.environ, "PATH": "/usr/bin:/bin:" + os.environ["PATH"], "PYTHONDONTWRITEBYTECODE": "1"}
        with open(self.at(name + ".log"), "w", encoding="utf-8") as log:
            process = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                       env=environment, cwd=self.folder)
            status, usage = os.wait4(process.pid, 0)[1:]
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            with open(self.at(name + ".log"), encoding="utf-8", errors="replace") as log:
                end = "".join(log.readlines()[-5:]).strip()
            raise RuntimeError(f"{os.path.basename(command[0])} ended with {process.returncode}: {end}")
        return usage.ru_utime + usage.ru_stime


def version_problem(command, pattern, oldest, title):
    """A sentence if the command is missing or older than (major, minor), or None."""
    if shutil.which(command[0]) is None:
        return "not found"
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    found = re.search(pattern, done.stdout + done.stderr)
    if found is None:
        return f"its version is unknown: expected {title} {oldest[0]}.{oldest[1]} or later"
    if (int(found[1]), int(found[2])) < oldest:
        return f"version {found[1]}.{found[2]} is too old: expected {title} {oldest[0]}.{oldest[1]} or later"
    return None


class Luxel:
    """luxel bake: the whole scene's light, then the picture."""
    name = "Luxel"

    def __init__(self, job, program):
        self.job, self.program = job, program

    def problem(self):
        return None if os.path.exists(self.program) else "not found: build it with ./dev build"

    def ladder(self, quick):
        if quick:
            return [("draft", ("--quality", "draft"))]
        return [("draft", ("--quality", "draft")), ("medium", ()), ("final", ("--quality", "final"))]

    def options(self, setting):
        return ("bake", *setting)

    def render(self, scene, setting, seed):
        job, model, picture = self.job, self.job.at(scene.name + ".obj"), self.job.at("luxel.exr")
        if not os.path.exists(model):
            scene.write_obj(model)
        verb, *options = self.options(setting)
        spent = job.run([self.program, verb, model, "-o", picture, *options, "--seed", str(seed), "--threads",
                         str(job.threads), "--sky", ",".join(words(scene.sky).split()) if scene.sky.any() else "none",
                         "--eye", ",".join(words(scene.eye).split()), "--target", ",".join(words(scene.target).split()),
                         "--fov", str(scene.fov), "--width", str(job.width), "--height", str(job.height), "--quiet"],
                        "luxel")
        return exr.read(picture), spent


class Reference(Luxel):
    """luxel reference: path tracing of each pixel."""
    name = "Luxel, path tracing"

    def ladder(self, quick):
        return [(f"{n} paths", n) for n in ((16,) if quick else (16, 64, 256, 1024))]

    def options(self, setting):
        return ("reference", "--samples", str(setting))


class Cycles:
    """Cycles in Blender: a camera rendering of diffuse surfaces, 64 bounces, no clamping, no adaptive sampling."""
    name = "Cycles"
    denoise = False

    def __init__(self, job):
        self.job = job

    def problem(self):
        return version_problem(["blender", "--version"], r"Blender (\d+)\.(\d+)", (3, 0), "Blender")

    def ladder(self, quick):
        return [(f"{n} samples", n) for n in ((16,) if quick else (16, 64, 256, 1024))]

    def render(self, scene, setting, seed):
        job, arrays, picture = self.job, self.job.at(scene.name + ".npz"), self.job.at("cycles.exr")
        if not os.path.exists(arrays):
            scene.write_arrays(arrays)
        wanted = {"arrays": arrays, "width": job.width, "height": job.height, "threads": job.threads, "seed": seed,
                  "picture": picture, "samples": setting, "denoise": self.denoise}
        spent = job.run(["blender", "--background", "--factory-startup", "--threads", str(job.threads),
                         "--python-exit-code", "1", "--python", os.path.join(HERE, "in_blender.py"), "--",
                         json.dumps(wanted)], "cycles")
        return exr.read(picture), spent


class CyclesDenoised(Cycles):
    name = "Cycles, denoised"
    denoise = True

    def problem(self):
        found = super().problem()
        if found is None:
            expression = "import _cycles; print('denoiser', _cycles.with_openimagedenoise)"
            done = subprocess.run(["blender", "--background", "--factory-startup", "--python-expr", expression],
                                  capture_output=True, text=True, check=False, env={**os.environ, "PATH": "/usr/bin:/bin"})
            if "denoiser True" not in done.stdout:
                found = "this Blender is built without a denoiser"
        return found


class PovRay:
    """POV-Ray's radiosity, which caches irradiance. Lamps are emitting surfaces: its area lights have no cosine."""
    name = "POV-Ray"

    def __init__(self, job):
        self.job = job

    def problem(self):
        return version_problem(["povray", "--version"], r"POV-Ray (\d+)\.(\d+)", (3, 7), "POV-Ray")

    def ladder(self, quick):
        every = [("count 100", (100, 0.7)), ("count 400", (400, 0.4)), ("count 1600", (1600, 0.2))]
        return every[-1:] if quick else every  # the others change by 10 % from run to run, with the order of threads

    def render(self, scene, setting, seed):
        del seed  # its directions are a fixed table
        model, picture = self.job.at(scene.name + ".pov"), self.job.at("povray.exr")
        self._write(scene, setting, model)
        spent = self.job.run(["povray", f"+I{model}", f"+O{picture}", "+FE", f"+W{self.job.width}", f"+H{self.job.height}",
                              f"+WT{self.job.threads}", "-D", "-GA", "+A0.0", "+AM1", "+R2", "-J"], "povray")
        return exr.read(picture), spent

    def _write(self, scene, setting, path):
        count, error_bound = setting
        right, up, ahead = scene.basis()
        top = 2 * numpy.tan(numpy.radians(scene.fov) / 2)
        with open(path, "w", encoding="utf-8") as file:
            file.write(f"""#version 3.7;
global_settings {{ assumed_gamma 1 ambient_light rgb 0 max_trace_level 256 adc_bailout 0.0005
  radiosity {{ brightness 1 gray_threshold 0 count {count} error_bound {error_bound} nearest_count 10
    recursion_limit 12 low_error_factor 0.7 minimum_reuse 0.005 pretrace_start 0.08 pretrace_end 0.01 always_sample off
    adc_bailout 0.0005 }} }}
#default {{ finish {{ ambient 0 diffuse 1 }} }}
background {{ rgb {vector(scene.sky)} }}
camera {{ perspective location {vector(scene.eye)} right {vector(right * top * self.job.width / self.job.height)}
  up {vector(up * top)} direction {vector(ahead)} }}
""")
            for material, (colour, radiance) in enumerate(zip(scene.reflectance, scene.radiance)):
                chosen = scene.triangles[scene.materials == material]
                if not len(chosen):
                    continue
                used, corners = numpy.unique(chosen, return_inverse=True)
                file.write("mesh2 { vertex_vectors { " + str(len(used)))
                file.writelines(f",\n{vector(point)}" for point in scene.points[used])
                file.write(f" }}\nface_indices {{ {len(chosen)}")
                # Its axes are left-handed, and so are its fronts: the other way round.
                file.writelines(",\n<{},{},{}>".format(*triangle[::-1]) for triangle in corners.reshape(-1, 3))
                file.write(" }\n")
                if radiance.any():
                    file.write(f"texture {{ pigment {{ rgb {vector(radiance)} }} finish {{ diffuse 0 emission 1 }} }}\n"
                               "interior_texture { pigment { rgb 0 } } }\n")
                else:
                    file.write(f"texture {{ pigment {{ rgb {vector(colour)} }} }} }}\n")


class Radiance:
    """rpict, which caches indirect irradiance and samples lamps directly. It has one thread."""
    name = "Radiance"

    def __init__(self, job):
        self.job = job

    def problem(self):
        missing = [name for name in ("oconv", "rpict", "pvalue") if shutil.which(name) is None]
        return "not found" if missing else None

    def ladder(self, quick):
        every = [("-ad 256", (256, 0.2)), ("-ad 1024", (1024, 0.1)), ("-ad 4096", (4096, 0.05))]
        return every[:1] if quick else every

    def render(self, scene, setting, seed):
        del seed
        job, model = self.job, self.job.at(scene.name)
        self._write(scene, model + ".rad")
        divisions, accuracy = setting
        ahead, vertical = scene.target - scene.eye, scene.fov
        horizontal = 2 * numpy.degrees(numpy.arctan(numpy.tan(numpy.radians(vertical) / 2) * job.width / job.height))
        octree, picture, values = model + ".oct", model + ".hdr", model + ".floats"
        spent = job.run(["sh", "-c", 'oconv "$1" > "$2"', "sh", model + ".rad", octree], "radiance")
        view = [*words(scene.eye).split(), "-vd", *words(ahead).split(), "-vu", "0", "1", "0", "-vv", str(vertical), "-vh",
                str(horizontal)]
        spent += job.run(["sh", "-c", 'picture=$1; shift; exec rpict "$@" > "$picture"', "sh", picture, "-vtv", "-vp", *view,
                          "-x", str(job.width), "-y", str(job.height), "-pa", "0", "-ps", "1", "-pj", "0.9", "-ab", "12",
                          "-ad", str(divisions), "-as", str(divisions // 4), "-aa", str(accuracy), "-ar", "256", "-lw",
                          "1e-6", "-lr", "16", "-dj", "0.7", "-ds", "0.1", "-dc", "1", "-dt", "0", "-av", "0", "0", "0",
                          octree], "radiance")
        job.run(["sh", "-c", 'pvalue -h -H -df "$1" > "$2"', "sh", picture, values], "radiance")
        return numpy.fromfile(values, numpy.float32).reshape(job.height, job.width, 3).astype(float), spent

    @staticmethod
    def _write(scene, path):
        with open(path, "w", encoding="utf-8") as file:
            for i, (colour, radiance) in enumerate(zip(scene.reflectance, scene.radiance)):
                file.write(f"void light m{i} 0 0 3 {words(radiance)}\n" if radiance.any() else
                           f"void plastic m{i} 0 0 5 {words(colour)} 0 0\n")
            for i, (material, corners) in enumerate(zip(scene.materials, scene.points[scene.triangles])):
                file.write(f"m{material} polygon t{i} 0 0 9 {words(corners.ravel())}\n")
            if scene.sky.any():
                file.write(f"void glow sky 0 0 4 {words(scene.sky)} 0\nsky source all 0 0 4 0 1 0 360\n")


def vector(values):
    return "<" + ",".join(f"{value:.9g}" for value in values) + ">"


def all_of(job, luxel):
    return [Luxel(job, luxel), Reference(job, luxel), Cycles(job), CyclesDenoised(job), PovRay(job), Radiance(job)]
