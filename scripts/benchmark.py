#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times the program on one core with one BLAS thread: nested meshes by scenes x contact solvers x linear solvers x levels,
and what a relative error costs with every strategy. Medians of several runs go to CSV files, and matplotlib draws them.
Installs what is missing and builds unless --program is given.
Scenes: two_ends has smooth contact with two ends; no_contact is the same body with a gap so large that nothing touches; a1
and b1 are of the catalogue. Times to an error: b1 is the worst of eight ends of contact, b1_kinks the first of them, given
as Kinks at x; block compares energies. Files: runs.csv (every run), benchmark.csv (medians by scene, solvers and level;
t_solution sums up the stages without errors and output, t_nested the same over all levels so far), memory.csv (every level
in a process of its own), target_runs.csv and targets.csv (time to an error), targets_worst.csv and targets.txt (the largest
value of every column over the ends of contact; the cheapest run below every target), summary.txt, environment.txt and
benchmark_*.png: error against t_nested, time per unknown by stage, bytes per unknown, error against processor time."""
import argparse
import csv
import glob
import importlib.util
import os
import re
import resource
import shutil
import statistics
import subprocess
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
STAGES = "mesh setup assembly factor compliance qp recovery postprocess bound".split()
TITLES = {"two_ends": "smooth contact, two ends", "no_contact": "the same without contact", "a1": "scene A1",
          "b1": "scene B1", "b3": "B3", "block": "block on parabola (energy)"}
TWO_ENDS = "prm/smooth_contact_two_ends.prm"
NO_EXACT_SOLUTION = {f"Exact solution/{name}": "" for name in ("Displacement", "Displacement gradient", "Pressure")}
NO_LOAD = {"Load/Body force": "0; 0", "Boundary/Traction": "", "Contact/Gap": "10"}
STAGE_SCENES = {"two_ends": (TWO_ENDS, {}), "no_contact": (TWO_ENDS, {"Contact/Gap": "10", **NO_EXACT_SOLUTION}),
                "a1": ("prm/a1.prm", {}), "b1": ("prm/b1.prm", {})}
TARGET_SCENES = ["two_ends", "b1", "b1_kinks", "b3", "block"]
# 1/sqrt(2), 1/pi, 1/sqrt(7), 1/sqrt(5), pi/6, 1/sqrt(3), 2/pi, pi/4: no mesh has a node there.
ENDS = ("0.7071067811865475 0.3183098861837907 0.3779644730092272 0.4472135954999579 0.5235987755982988 0.5773502691896258 "
        "0.6366197723675814 0.7853981633974483")
NORM_OF_B3 = 0.0840195532  # |u|_1 by a quadrature that is graded to both ends of contact


def stop(sentence):
    sys.exit(f"benchmark: {sentence}")


def read(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def write(path, rows):
    """Writes dictionaries as a table; the columns are those of the first row."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def number(text):
    return float(text) if text not in ("", None) else None


def grouped(rows, *keys):
    """Returns the rows by the values of some columns, in the order in which they appear."""
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[key] for key in keys), []).append(row)
    return groups


def medians(rows, columns):
    """Returns the medians of columns; empty where a row has no value."""
    values = {c: [number(row[c]) for row in rows] for c in columns}
    return {c: "" if None in v else statistics.median(v) for c, v in values.items()}


class Benchmark:
    def __init__(self, options):
        self.options, self.failures = options, 0
        core = options.core if options.core is not None else min(os.sched_getaffinity(0))
        self.prefix = ["taskset", "-c", str(core)] if shutil.which("taskset") else []
        for folder in ("runs",):
            shutil.rmtree(os.path.join(options.output, folder), ignore_errors=True)
            os.makedirs(os.path.join(options.output, folder))

    def file(self, name):
        return os.path.join(self.options.output, name)

    def run(self, name, scene, settings, must_succeed=True):
        """Runs a scene. Returns the rows of convergence.csv, wall seconds and processor seconds; nothing after a failure."""
        folder = self.file(f"runs/{name}")
        command = [*self.prefix, self.options.program, scene, "--output", folder]
        for key, value in {**settings, "Output/Inf-sup constant": "false"}.items():
            command += ["--set", f"{key}={value}"]
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        with open(f"{folder}.log", "w", encoding="utf-8") as log:
            code = subprocess.run(command, stdout=log, stderr=log, check=False).returncode
        seconds, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
        if code != 0 and must_succeed:
            print(f"benchmark: {name} failed, see {folder}.log", file=sys.stderr)
            self.failures += 1
            return None
        return (read(os.path.join(folder, "convergence.csv")), seconds,
                after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)

    # Stage by stage: benchmark.csv and memory.csv.

    def measure_stages(self, scenes):
        o, rows = self.options, []
        levels = {"Discretization/Coarsest level": o.coarsest, "Discretization/Finest level": o.largest}
        for repetition in range(o.repetitions):
            for scene in scenes:
                for contact in o.contact_solvers:
                    for linear in o.linear_solvers:
                        print(f"run {repetition + 1} of {o.repetitions}: {scene}, {contact}, {linear}", flush=True)
                        path, settings = STAGE_SCENES[scene]
                        done = self.run(f"{scene}-{contact.replace(' ', '_')}-{linear}", path, {
                            **settings, **levels, "Solver/Contact solver": contact, "Solver/Linear solver": linear, "Output/VTU": "none"})
                        head = {"scene": scene, "contact_solver": contact, "linear_solver": linear}
                        rows += [{**head, "t_process": done[1], **level} for level in done[0]] if done else []
        if not rows:
            stop("no run succeeded.")
        write(self.file("runs.csv"), rows)
        table, nested = [], {}
        keys = ["scene", "contact_solver", "linear_solver"]
        for key, runs in grouped(rows, *keys, "level").items():
            row = {**dict(zip(keys, key)), **medians(runs, [c for c in rows[0] if c not in keys])}
            row["level"], row["dofs"] = key[3], runs[0]["dofs"]
            row["t_solution"] = row["t_total"] - row["t_errors"] - row["t_output"]
            row["t_nested"] = nested[key[:3]] = nested.get(key[:3], 0.) + row["t_solution"]
            table.append({**row, "repetitions": len(runs)})
        write(self.file("benchmark.csv"), table)
        write(self.file("memory.csv"), [row for linear in o.linear_solvers for row in self.memory(linear)] or [{"linear_solver": ""}])
        self.print_stages({key: levels[-1] for key, levels in grouped(table, *keys).items()})
        return table

    def memory(self, linear):
        """Every level in a process of its own, without the exact solution and without kinks, which need memory of their own."""
        print(f"memory: {linear}", flush=True)
        rows = []
        for level in range(self.options.coarsest, self.options.largest + 1):
            done = self.run(f"memory-{linear}", TWO_ENDS, {**NO_EXACT_SOLUTION, "Discretization/Kinks at x": "",
                            "Discretization/Coarsest level": level, "Discretization/Finest level": level, "Solver/Linear solver": linear})
            if not done:
                return rows
            last = done[0][-1]
            first = rows[0]["peak_memory_mb"] if rows else number(last["peak_memory_mb"])
            rows.append({"linear_solver": linear, "level": level, "dofs": last["dofs"], "peak_memory_mb": number(last["peak_memory_mb"]),
                         "bytes_per_dof": (number(last["peak_memory_mb"]) - first) * 2**20 / float(last["dofs"])})
        return rows[1:]

    def print_stages(self, finest):
        """Prints the finest level of every configuration, and what contact costs beside the same body without contact."""
        lines = [("scene", "contact", "linear", "dofs", "seconds", "factor", "compliance", "|u-uh|1")]
        for key, row in finest.items():
            lines.append((*key, row["dofs"], *(f"{row[t]:.3f}" for t in ("t_solution", "t_factor", "t_compliance")),
                          "-" if row["u_h1"] == "" else f"{row['u_h1']:.3e}"))
        text = "".join("{:<11} {:<11} {:<13} {:>9} {:>9} {:>9} {:>10} {:>10}\n".format(*line) for line in lines)
        for (scene, *solvers), row in finest.items():
            without = finest.get(("no_contact", *solvers))
            if scene == "two_ends" and without:
                text += f"contact / no contact, {solvers[0]}, {solvers[1]}: {row['t_solution'] / without['t_solution']:.2f}\n"
        self.report("summary.txt", text)

    def report(self, name, text):
        print(text, end="")
        with open(self.file(name), "w", encoding="utf-8") as file:
            file.write(text)

    # Time to an error: target_runs.csv, targets.csv and targets_worst.csv. A run without error norms is timed, and a second
    # one with them tells the error that was reached.
    #   hp      a run for every target: the time of the whole process
    #   nested  one run of all levels: the time of the process up to the end of each level, without the guaranteed bound
    #   error   |u - u_h| / |u| in the seminorm of H1; sqrt(|J - J_fine| / |J_fine|) where no exact solution is known

    def strategy_settings(self, strategy, request):
        if strategy == "hp":
            return {"Discretization/Target error": request, "Discretization/Coarsest level": 2, "Discretization/Strategy": "hp",
                    "Output/VTU": "none"}
        return {"Discretization/Finest level": request, "Discretization/Coarsest level": self.options.coarsest,
                "Discretization/Strategy": "nested", "Output/VTU": "none"}

    def reference(self, scene, path, settings):
        """Returns |u|_1, or the energy of a finer mesh. A body that nothing loads has u_h = 0 and the error u."""
        if scene == "b3":
            return NORM_OF_B3
        if scene == "block":
            # The relative error of an energy is the square of that of u. A run that ends at Maximum unknowns will do, too.
            target = max(1e-8, min(float(t) for t in self.options.targets) / 10)
            rows = self.run("reference-block", path, {**settings, **self.strategy_settings("hp", target)}, False)[0]
            return float(rows[-1]["energy"])
        done = self.run(f"reference-{scene}", path, {**settings, **self.strategy_settings("nested", self.options.coarsest + 2), **NO_LOAD})
        return seminorm(done[0][-1]) if done else stop(f"the reference of {scene} failed.")

    def time_runs(self, head, path, settings, reference, requests):
        """Returns one row per repetition; for nested meshes one for each of the levels in requests."""
        strategy, name = head["strategy"], "-".join(map(str, head.values()))
        request = self.options.largest + 1 if strategy == "nested" else requests[0]
        settings = {**settings, **self.strategy_settings(strategy, request)}
        with_errors = self.run(f"{name}-{request}-errors", path, settings)
        rows = []
        for repetition in range(1, self.options.repetitions + 1):
            timed = self.run(f"{name}-{request}", path, {**settings, "Output/Errors": "false"}) if with_errors else None
            for wanted in requests if timed else []:
                counted = [row for row in timed[0] if strategy == "hp" or int(row["level"]) <= wanted]
                last, errors = counted[-1], with_errors[0][len(counted) - 1]
                if errors["u_h1"]:
                    error = seminorm(errors) / reference
                    post = float(errors["u_post_h1"]) / reference if errors["u_post_h1"] else ""
                else:
                    error, post = abs(float(errors["energy"]) / reference - 1)**0.5, ""
                rows.append({**head, "request": wanted, "repetition": repetition, "error": error, "error_post": post,
                             "estimate": errors["estimated_relative"], "steps": len(counted), "dofs": last["dofs"],
                             "all_dofs": sum(int(row["dofs"]) for row in counted), "max_degree": last["max_degree"],
                             "cpu": timed[2] if strategy == "hp" else last["cpu_total"],
                             **{f"t_{s}": sum(float(row[f"t_{s}"]) for row in counted) for s in STAGES}})
        return rows

    def measure_targets(self, scenes):
        o, rows = self.options, []
        for scene in scenes:
            ends = {"b1": o.ends, "b1_kinks": o.ends[:1]}.get(scene, ["-"])
            for end in ends:
                path, settings = {"two_ends": TWO_ENDS, "b3": "prm/b3.prm", "block": "prm/block_on_parabola.prm"}.get(
                    scene, "prm/described_b1.prm"), {}
                if end != "-":
                    settings = {"Constants/Values": f"xi={end}", **({"Discretization/Kinks at x": end} if scene == "b1_kinks" else {})}
                reference = self.reference(scene, path, settings)
                for strategy in o.strategies:
                    print(f"time to an error: {scene}, {strategy}, end of contact {end}", flush=True)
                    head = {"strategy": strategy, "scene": scene, "end": end}
                    for requests in [[t] for t in o.targets] if strategy == "hp" else [list(range(o.coarsest, o.largest + 1))]:
                        rows += self.time_runs(head, path, settings, reference, requests)
        if not rows:
            stop("no run to a target succeeded.")
        write(self.file("target_runs.csv"), rows)
        keys, columns = ["strategy", "scene", "end", "request"], list(rows[0])[5:]
        table = [{**dict(zip(keys, key)), "repetitions": len(runs), **medians(runs, columns)} for key, runs in grouped(rows, *keys).items()]
        worst = [{"strategy": k[0], "scene": k[1], "ends": len(r), "request": k[2], "repetitions": r[0]["repetitions"],
                  **{c: max((row[c] for row in r if row[c] != ""), default="") for c in columns}}
                 for k, r in grouped(table, "strategy", "scene", "request").items()]
        write(self.file("targets.csv"), table)
        write(self.file("targets_worst.csv"), worst)
        self.print_targets(table)
        return worst

    def print_targets(self, table):
        """Prints for every target the run with the least time whose error is below it, in the worst of the ends of contact."""
        text = row = "{:<9} {:<9} {:>6} {:>10} {:>9} {:>6} {:>8} {:>5}\n"
        text = row.format("scene", "strategy", "target", "error", "unknowns", "steps", "seconds", "ends")
        def error_of(run):
            return min(run["error"], run["error_post"]) if run["error_post"] != "" else run["error"]
        for (scene, strategy), runs in grouped(table, "scene", "strategy").items():
            ends = grouped(runs, "end").values()
            for target in self.options.targets:
                cheapest = [min((r for r in end if error_of(r) <= float(target)), key=lambda r: r["cpu"], default=None) for end in ends]
                if None not in cheapest:
                    r = max(cheapest, key=lambda r: r["cpu"])
                    text += row.format(scene, strategy, target, f"{error_of(r):.2e}", f"{r['dofs']:.0f}", f"{r['steps']:.0f}",
                                       f"{r['cpu']:.2f}", len(cheapest))
        self.report("targets.txt", text)

    # Pictures.

    def draw(self, table, worst):
        # Only now: this takes longer than to refuse wrong options.
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
        colours, blues = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#000000"], pyplot.get_cmap("viridis_r")
        pyplot.rcParams.update({"axes.grid": True, "axes.axisbelow": True, "font.size": 8, "figure.constrained_layout.use": True,
                                "savefig.dpi": 110})
        def save(figure, name):
            figure.savefig(self.file(f"benchmark_{name}.png"))
            pyplot.close(figure)
        shown = [row for row in table or [] if row["contact_solver"] == self.options.contact_solvers[0]]
        by_scene = {k[0]: grouped(r, "linear_solver") for k, r in grouped(shown, "scene").items()}
        errors = [scene for scene in by_scene if scene != "no_contact"]
        if errors:
            figure, axes = pyplot.subplots(1, len(errors), figsize=(3.8 * len(errors), 4.4), squeeze=False)
            for ax, scene in zip(axes[0], errors):
                for colour, ((linear,), rows) in zip(colours, by_scene[scene].items()):
                    for column, style, name in (("u_h1", "o-", "‖u−u_h‖₁"), ("u_post_h1", "o--", "‖u−πu_h‖₁")):
                        ax.loglog([r["t_nested"] for r in rows], [r[column] for r in rows], style, color=colour, ms=4,
                                  mfc="none" if "--" in style else colour, label=f"{name}, {linear}")
                ax.set(title=TITLES[scene], xlabel="seconds, all levels up to this one", ylabel="error")
                ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.15), fontsize=7)
            save(figure, "error")
        if by_scene:
            n_linear = max(len(groups) for groups in by_scene.values())
            figure, axes = pyplot.subplots(len(by_scene), n_linear, figsize=(4.4 * n_linear, 2.9 * len(by_scene)), squeeze=False)
            for line, (scene, groups) in zip(axes, by_scene.items()):
                for ax, ((linear,), rows) in zip(line, groups.items()):
                    rows = rows[1:] if len(rows) > 2 else rows  # the first level bears what is done once
                    base = [0.] * len(rows)
                    for k, stage in enumerate(STAGES):
                        heights = [1e6 * r[f"t_{stage}"] / float(r["dofs"]) for r in rows]
                        ax.bar([r["dofs"] for r in rows], heights, 0.8, base, color=blues(k / (len(STAGES) - 1)), label=stage)
                        base = [b + h for b, h in zip(base, heights)]
                    ax.set(title=f"{TITLES[scene]}, {linear}", xlabel="unknowns", ylabel="µs per unknown")
            axes[0, -1].legend(loc="upper left", bbox_to_anchor=(1, 1))
            save(figure, "stages")
        memory = read(self.file("memory.csv")) if table else []
        if memory and "dofs" in memory[0]:
            figure, ax = pyplot.subplots(figsize=(5.5, 3.8))
            for colour, ((linear,), rows) in zip(colours, grouped(memory, "linear_solver").items()):
                ax.semilogx([float(r["dofs"]) for r in rows], [float(r["bytes_per_dof"]) for r in rows], "o-", color=colour, label=linear)
            ax.set(title="Peak memory above that of the first level", xlabel="unknowns", ylabel="bytes per unknown")
            ax.legend()
            save(figure, "memory")
        targets = {k[0]: grouped(r, "strategy") for k, r in grouped(worst or [], "scene").items() if k[0] != "b1_kinks"}
        if targets:
            figure, axes = pyplot.subplots(1, len(targets), figsize=(4 * len(targets), 4.2), squeeze=False)
            for ax, (scene, groups) in zip(axes[0], targets.items()):
                for (strategy,), rows in groups.items():
                    curves = [("error", "o-", "u_h")] + ([("error_post", "o--", "π²ʰu_h")] if rows[0]["error_post"] != "" else [])
                    for column, style, name in curves:
                        ax.loglog([r["cpu"] for r in rows], [r[column] for r in rows], style, ms=4, label=f"{strategy}, {name}",
                                  color=colours[strategy == "hp"], mfc="none" if "--" in style else None)
                ax.set(title=TITLES[scene], xlabel="seconds of processor time", ylabel="relative error")
                ax.legend()
            save(figure, "targets")


def seminorm(row):
    return (float(row["u_h1"])**2 - float(row["u_l2"])**2)**0.5


def read_options():
    class OneSentence(argparse.ArgumentParser):
        def error(self, message):
            stop(f"{message}; --help lists the options.")
    def fraction(text):
        if not 0. < float(text) <= 1.:
            raise ValueError(text)
        return text
    def words(kind=str, allowed=None, separator=None):
        def read_words(text):
            found = [kind(word) for word in text.split(separator)]
            if allowed and not set(found) <= set(allowed):
                raise ValueError(text)
            return found
        read_words.__name__ = f"list of {', '.join(allowed)}" if allowed else "list of numbers between 0 and 1"
        return read_words
    scenes = list(dict.fromkeys([*STAGE_SCENES, *TARGET_SCENES]))
    parser = OneSentence(description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter, allow_abbrev=False)
    parser.add_argument("--coarsest", type=int, default=4, help="first level of every run")
    parser.add_argument("--largest", type=int, default=7, help="last level of every run")
    parser.add_argument("--repetitions", type=int, default=3, help="runs of everything; medians are reported")
    parser.add_argument("--strategies", type=words(allowed=["nested", "hp"]), default="nested hp", help="hp has times to an error only")
    parser.add_argument("--targets", type=words(fraction), default="1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8", help='relative errors; "": none')
    parser.add_argument("--ends", type=words(fraction), default=ENDS, help="ends of contact of scene B1 in the times to an error")
    parser.add_argument("--scenes", type=words(allowed=scenes), default=" ".join(scenes), help="two_ends to b1 by stage, others by error")
    parser.add_argument("--contact-solvers", type=words(separator="|"), default="active set|psor")
    parser.add_argument("--linear-solvers", type=words(), help="the default is all that the program offers")
    parser.add_argument("--output", type=os.path.abspath, default=os.path.join(ROOT, "benchmark"), help="where the results go")
    parser.add_argument("--program", type=os.path.abspath, help="time this program; install and build nothing")
    parser.add_argument("--core", type=int, help="the core to run on; the default is the first one allowed")
    parser.add_argument("--no-pictures", action="store_true", help="draw nothing")
    parser.add_argument("--copy-pictures", action="store_true", help="copy the pictures to doc/pictures")
    o = parser.parse_args()
    if not o.coarsest <= o.largest or o.repetitions < 1:
        stop("levels must increase, and one repetition is the least.")
    return o


def main():
    o = read_options()
    if o.program and not o.no_pictures and not importlib.util.find_spec("matplotlib"):
        stop("Python's matplotlib is missing; --no-pictures does without.")
    os.chdir(ROOT)
    if not o.program:
        subprocess.run(["bash", "scripts/install_packages", *([] if o.no_pictures else ["python3-matplotlib"])], check=True)
        subprocess.run(["cmake", "--preset", "release"], check=True)
        subprocess.run(["cmake", "--build", "--preset", "release"], check=True)
        o.program = "build/release/source/signorini"
    if not os.access(o.program, os.X_OK):
        stop(f"{o.program} is not a program.")
    os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", DEAL_II_NUM_THREADS="1")
    if not o.linear_solvers:
        # The comment above 'set Linear solver' names the values that are allowed.
        text = subprocess.run([o.program, "--print-parameters"], capture_output=True, text=True, check=True).stdout
        text = re.sub(r"\n *#", " ", text[:text.index("set Linear solver")])
        o.linear_solvers = re.findall(r"\w+", text[text.rindex("Allowed: ") + 9:].split(".")[0])
        o.linear_solvers.remove("automatic")
    benchmark = Benchmark(o)
    stages = [scene for scene in o.scenes if scene in STAGE_SCENES and "nested" in o.strategies]
    targets = [scene for scene in o.scenes if scene in TARGET_SCENES and o.targets]
    table = benchmark.measure_stages(stages) if stages else None
    worst = benchmark.measure_targets(targets) if targets else None
    version = subprocess.run([o.program, "--version"], capture_output=True, text=True, check=True).stdout
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        cpu = re.search(r"model name\s*: (.*)", file.read())
    with open(benchmark.file("environment.txt"), "w", encoding="utf-8") as file:
        file.write(f"{version}CPU       {cpu[1] if cpu else 'unknown'}, core {benchmark.prefix[-1:] or 'any'}\n"
                   f"levels    {o.coarsest} to {o.largest}, strategies {' '.join(o.strategies)}, medians of {o.repetitions} runs\n")
    if not o.no_pictures:
        benchmark.draw(table, worst)
        if o.copy_pictures:
            for path in glob.glob(benchmark.file("benchmark_*.png")):
                shutil.copy(path, "doc/pictures")
    print(f"The results are in {o.output}.")
    sys.exit(benchmark.failures > 0)


if __name__ == "__main__":
    main()
