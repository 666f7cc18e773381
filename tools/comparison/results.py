# SPDX-License-Identifier: Apache-2.0
"""Errors against the truth, and what shows them: a table and a chart."""
import math

import numpy

LUMINANCE = numpy.array([0.2126, 0.7152, 0.0722])
DARK = 0.1  # of the mean luminance: darker pixels are compared with this, so that black corners do not decide


class Truth:
    """The light by two programs, each with two independent runs: [(first, second), (first, second)] of pictures.

    The product of differences to two independent pictures has the squared error as its mean, without their noise.
    """

    def __init__(self, pairs, surfaces):
        self.surfaces = surfaces
        self.pairs = [[self.luminance(picture) for picture in pair] for pair in pairs]
        means = [sum(pair) / 2 for pair in self.pairs]
        self.mean = sum(means) / len(means)
        self.scale = numpy.maximum(self.mean, DARK * self.mean.mean())
        self.opposite = means if len(means) == 2 else self.pairs[0]

    def luminance(self, picture):
        return (picture @ LUMINANCE)[self.surfaces]

    def _root(self, product):
        """The root of the mean of a product of relative differences, and its standard error, from independent pixels."""
        product = product / self.scale**2
        mean, error = float(numpy.mean(product)), float(numpy.std(product)) / math.sqrt(len(product))
        root = math.sqrt(max(0.0, mean))
        return root, min(math.sqrt(error), error / (2 * root) if root > 0 else math.inf)

    def agreement(self):
        """Fractions: noise of the mean of all runs per pixel; of two programs, their difference beyond noise (RMS) and
        the ratio of their means, less 1, with its standard error."""
        spread = [(pair[0] - pair[1]) / 2 for pair in self.pairs]
        noise = math.sqrt(sum(float(numpy.mean((s / self.scale)**2)) for s in spread)) / len(spread)
        found = {"noise_rms": noise}
        if len(self.pairs) == 2:
            (a, b), (c, d) = self.pairs
            found["difference_rms"], found["difference_standard_error"] = self._root((a - c) * (b - d))
            found["brightness_ratio"] = float((a + b).sum() / (c + d).sum() - 1)
            found["brightness_standard_error"] = noise * 2 / math.sqrt(len(self.mean))
        return found

    def errors(self, picture):
        """Fractions: RMS of the relative error without the truth's noise, the 95th percentile of its absolute value
        with that noise, and the relative error of the mean luminance."""
        light = self.luminance(picture)
        first, second = self.opposite
        rms, standard_error = self._root((light - first) * (light - second))
        return {"rms": rms, "rms_standard_error": standard_error,
                "percentile_95": float(numpy.percentile(numpy.abs(light - self.mean) / self.scale, 95)),
                "mean": float(light.sum() / self.mean.sum() - 1)}


def at_time(runs, seconds):
    """The RMS error at this processor time, a line between the runs on logarithmic axes, in words; in brackets that of
    the slowest run, which took less."""
    runs = sorted((run["cpu_seconds"], max(run["rms"], 1e-6)) for run in runs)
    if not runs or seconds < runs[0][0]:
        return "-"
    for (t0, e0), (t1, e1) in zip(runs, runs[1:]):
        if seconds <= t1:
            weight = math.log(seconds / t0) / math.log(t1 / t0)
            return percent(e0 * (e1 / e0)**weight)
    return f"({percent(runs[-1][1])})"


def percent(value):
    return f"{100 * value:.2g} %" if value < 0.995 else f"{100 * value:.0f} %"


def markdown(measured):
    """All tables, and the agreement of the truth."""
    lines = [f"Measured {measured['date']}: {measured['machine']}, {measured['threads']} threads, pictures of "
             f"{measured['width']} x {measured['height']} pixels.", ""]
    budgets = measured["budgets_s"]
    lines += ["| scene | program | " + " | ".join(f"{budget:g} s" for budget in budgets) + " |",
              "|---" * (len(budgets) + 2) + "|"]
    for scene in measured["scenes"]:
        for program in scene["programs"]:
            cells = [program["problem"]] + [""] * (len(budgets) - 1) if program["problem"] else \
                [at_time(program["runs"], budget) for budget in budgets]
            lines.append(f"| {scene['scene']} | {program['program']} | " + " | ".join(cells) + " |")
    lines += ["", "| scene | program | setting | processor time | RMS error | 95 % of pixels below | mean |",
              "|---|---|---|---|---|---|---|"]
    for scene in measured["scenes"]:
        for program in scene["programs"]:
            for run in program["runs"]:
                lines.append(f"| {scene['scene']} | {program['program']} | {run['setting']} | {run['cpu_seconds']:.1f} s | "
                             f"{percent(run['rms'])} ± {percent(run['rms_standard_error'])} | "
                             f"{percent(run['percentile_95'])} | {100 * run['mean']:+.1f} % |")
    lines += ["", "| scene | triangles | compared pixels | truth | noise per pixel | difference of the two | of their means |",
              "|---|---|---|---|---|---|---|"]
    for scene in measured["scenes"]:
        truth = scene["truth"]
        two = "brightness_ratio" in truth
        lines.append(f"| {scene['scene']} | {scene['triangles']} | {percent(scene['compared_fraction'])} | {truth['by']} | "
                     f"{percent(truth['noise_rms'])} | " +
                     (f"{percent(truth['difference_rms'])} ± {percent(truth['difference_standard_error'])} | "
                      f"{100 * truth['brightness_ratio']:+.2f} ± "
                      f"{100 * truth['brightness_standard_error']:.2f} % |" if two else "- | - |"))
    return "\n".join(lines) + "\n"


def chart(measured, path):
    import matplotlib
    matplotlib.use("Agg")
    matplotlib.rcParams.update({"svg.hashsalt": "luxel", "font.size": 10, "svg.fonttype": "none"})
    from matplotlib import pyplot
    scenes = measured["scenes"]
    columns = min(2, len(scenes))
    figure, axes = pyplot.subplots(-(-len(scenes) // columns), columns, squeeze=False, sharey=True,
                                   figsize=(4.6 * columns, 3.5 * -(-len(scenes) // columns) + 0.6))
    lines = {}
    for axis, scene in zip(axes.flat, scenes):
        for i, program in enumerate(scene["programs"]):
            runs = sorted(program["runs"], key=lambda run: run["cpu_seconds"])
            if runs:
                lines[program["program"]], = axis.plot([run["cpu_seconds"] for run in runs],
                                                       [100 * run["rms"] for run in runs], marker="osD^vP"[i % 6], color=f"C{i}")
        axis.set(xscale="log", yscale="log", title=scene["scene"], xlabel="processor time, s")
        for values in (axis.xaxis, axis.yaxis):
            values.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda value, _: f"{value:g}"))
            values.set_minor_formatter(matplotlib.ticker.NullFormatter())
        axis.grid(True, which="both", color="#e3e5e9", linewidth=0.6)
    for axis in axes[:, 0]:
        axis.set_ylabel("RMS relative error, %")
    for axis in axes.flat[len(scenes):]:
        axis.set_visible(False)
    figure.legend(lines.values(), lines.keys(), loc="upper center", ncol=2 * columns, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 1 - (0.45 if columns > 1 else 0.7) / figure.get_figheight()))
    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)


def side_by_side(rows, path):
    """Pictures with one exposure: [(label, picture)] for each row, as one file."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    columns = max(len(row) for row in rows)
    figure, axes = pyplot.subplots(len(rows), columns, squeeze=False, figsize=(3.2 * columns, 2.7 * len(rows)))
    for axis in axes.flat:
        axis.set_axis_off()
    for row, line in zip(axes, rows):
        white = 2.5 * float(numpy.median(line[0][1] @ LUMINANCE)) + 1e-9
        for axis, (label, picture) in zip(row, line):
            axis.imshow(numpy.clip(picture / white, 0, 1)**(1 / 2.2), interpolation="nearest")
            axis.set_title(label, fontsize=9)
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    pyplot.close(figure)
