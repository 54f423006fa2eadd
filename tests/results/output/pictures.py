# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the pictures of runs show: a narrow zone, graded meshes, a body in 3-D; skipped (127) where matplotlib is missing.
usage: pictures.py PROGRAM ROOT"""
import contextlib
import importlib.machinery
import importlib.util
import io
import json
import os
import subprocess
import sys
import tempfile
import warnings

program, root = map(os.path.realpath, sys.argv[1:3])
script, scenes = root + "/scripts/signorini-plot", root + "/prm"
loader = importlib.machinery.SourceFileLoader("plot", script)
plot = importlib.util.module_from_spec(importlib.util.spec_from_loader("plot", loader))
sys.dont_write_bytecode = True
loader.exec_module(plot)  # starts this test again where another Python has matplotlib
import numpy as np
from matplotlib.image import imread
from matplotlib.text import Text

failures = 0


def check(name, fact):
    global failures
    failures += not fact
    print(f"{name}: {'ok' if fact else 'FAILED'}")


def run(scene, directory, *settings, environment=None):
    command = [program, scene, "--output", directory]
    for setting in settings:
        command += ["--set", setting]
    return subprocess.run(command, capture_output=True, text=True, env=environment, check=False)


def draw_here(directory, *options):
    """Draws in this process, which saves a start of Python and its libraries. Returns the exit code, the output and errors."""
    sys.argv = [script, directory, *options]
    out, errors, code = io.StringIO(), io.StringIO(), 0
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors), warnings.catch_warnings():
        warnings.simplefilter("always")
        try:
            plot.main()
        except SystemExit as end:
            code = 1
            print(end.code, file=sys.stderr)
    return code, out.getvalue(), errors.getvalue()


def check_pictures(directory, code, out, errors, words):
    check(f"{directory}: drawn", code == 0 and not errors)
    facts = json.loads(out)
    check("  only titles name the run", not any(words.count(word) > 1 for word in ("stress up to", "whole side")))
    for name in facts["files"]:
        if name.endswith(".png"):
            pixels = np.round(255 * imread(os.path.join(directory, name))[..., :3]).astype(int)
            drawn = (pixels.min(2) < 250).mean()
            check(f"  {name} is no empty canvas", drawn > 0.02 and len(np.unique(pixels @ [1, 256, 65536])) > 20)
    check("  the factor is stated", f"× {facts['factor']:g}" in words)
    check("  no cell is folded", facts["least_jacobian"] > 0.)
    return facts


def draw(directory, *options):
    """Draws coarse pictures; their words are read from the figures before these are saved."""
    words.clear()
    code, out, errors = draw_here(directory, "--facts", "--format", "png", *options)
    return check_pictures(directory, code, out, errors, words["deformed"])


words, save = {}, plot.Results.save


def note_words(results, figure, name, **cut):
    words[name] = "\n".join(text.get_text() for text in figure.findobj(Text))
    save(results, figure, name, **cut)


plot.Results.save = plot.Scene.save = note_words
plot.STYLE["savefig.dpi"] = 60


def names(facts):
    return {name.split(".")[0] for name in facts["files"]}


# A square whose right side moves to the left by half its width, and a cube that is turned inside out.
x = np.array([[[0., 0.], [1., 0.], [1., 1.], [0., 1.]]])
u = np.array([[[0., 0.], [-.5, 0.], [-.5, 0.], [0., 0.]]])
check("a cell at half its width", abs(plot.least_jacobian(x, u, 1.) - 0.5) < 1e-12)
check("a folded cell", plot.least_jacobian(x, u, 3.) < 0.)
check("a factor that is asked for is reduced", plot.choose_factor(x, u, 3.) == 1.)
check("the factor: a tenth of the body", plot.choose_factor(x, 1e-3 * u) == 200.)
cube = np.array([[[i, j, k] for k in (0., 1.) for i, j in ((0., 0.), (1., 0.), (1., 1.), (0., 1.))]])
check("a folded cube", plot.least_jacobian(cube, cube * [-2., 0., 0.], 1.) < 0. < plot.least_jacobian(cube, 0. * cube, 1.))

# A fifth of an edge and a longer edge of the neighbour have the same middle.
fine = [[[a / 5, 0.], [(a + 1) / 5, 0.], [(a + 1) / 5, -1.], [a / 5, -1.]] for a in range(5)]
coarse = [[[a, 0.], [a, 1.], [b, 1.], [b, 0.]] for a, b in ((-0.2, 0.27), (0.27, 0.73), (0.73, 1.2))]
inner = [edge for edge in plot.outlines(np.array([*fine, *coarse])).tolist() if edge[0][1] == edge[1][1] == 0.]
check("cells that are divided in different ways leave no edge between them",
      not any(0.25 < (a[0] + b[0]) / 2 < 0.75 for a, b in inner))

# A ring of 24 sectors, each of 32² cells, as deal.II numbers them: a picture has cells as small as it can show, and both circles.
children = np.zeros((1, 2), dtype=int)
for _ in range(5):
    children = (2 * children[:, None] + [[0, 0], [1, 0], [0, 1], [1, 1]]).reshape(-1, 2)
grid = (children[:, None] + [[0, 0], [1, 0], [1, 1], [0, 1]]) / 32
angle, radius = (np.arange(24)[:, None, None] + grid[..., 0]) * np.pi / 12, np.tile(1. + grid[..., 1], (24, 1, 1))
ring = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=-1).reshape(-1, 2)
quads = np.arange(len(ring)).reshape(-1, 4)
some = plot.thinned(ring, quads, 0.2)
check("cells are joined up to a size", len(quads) / 16 <= len(some) < len(quads) / 3 and np.ptp(ring[some], axis=1).max() <= 0.2)
check("  and cover the same body", abs(abs(plot.signed_areas(ring[some])).sum() / (3 * np.pi) - 1) < 1e-3)
edges = plot.outlines(ring[some])
radii = np.linalg.norm(edges, axis=2)
check("  of two circles", np.allclose(np.minimum(abs(radii - 1), abs(radii - 2)), 0., atol=1e-9) and
      abs(np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1).sum() / (6 * np.pi) - 1) < 1e-3)
view = np.array([[1.2, 1.2], [1.3, 1.3]])
seen = plot.overlaps(ring, quads, view)
check("  a zoom has the cells of the mesh", len(plot.thinned(ring, quads, 1e-3, seen)) == seen.sum() < len(quads) / 50)

# Pieces of a side that faces another one from s = 0.6 on, of which the middles are given, and pieces with a gap between them.
ends = 0.6 + np.cumsum([0., .02, .03, .01, .04, .02, .015])
check("the ends of pieces", np.allclose(plot.edges_of_pieces((ends[1:] + ends[:-1]) / 2), ends, atol=0.006))
check("  of a whole side", np.allclose(plot.edges_of_pieces((ends[1:] + ends[:-1]) / 2 - 0.6), ends - 0.6))
check("  with a gap", (np.diff(plot.edges_of_pieces(np.array([.1, .3, 2., 2.1, 2.3]))) > 0.).all())

# A closed side of the length 80 with a zone across its start, and one that touches all around.
s = np.arange(0.5, 80.)
column = {"side": np.full(80, "rim"), "s": s, "x": np.cos(s * np.pi / 40), "y": np.sin(s * np.pi / 40), "u_n": np.full(80, 1e-3)}
line = plot.Line({**column, "p_H": -1. * ((s < 5) | (s > 70))}, "rim", 1.)
check("a zone across the start is one", line.zones == [(-10., 5.)] and line.range()[1] - line.range()[0] == 80. and line.range()[0] > -50.)
axes = plot.pyplot.figure().add_subplot()
line.label(axes, line.range())
check("  and arc lengths start at zero", all(0. <= float(text.get_text()) < 80. for text in axes.get_xticklabels()))
check("all around: from zero", plot.Line({**column, "p_H": np.full(80, -1.)}, "rim", 1.).zones == [(0., 80.)])
line = plot.Line({**column, "p_H": -1. / np.sqrt(1.0001 - np.minimum(s / 79.5, 1.)**2), "p_recovered": np.full(80, np.nan), "p_exact":
                  np.full(80, np.nan), "g": np.full(80, 1e-3) + 1e-8 * np.sin(s)}, "rim", 100.)
line.draw(axes, line.range(), False)
check("a pressure without limit ends above the scale, which says so", 2. < axes.get_ylim()[1] < 10. and "up to 100" in axes.texts[0].get_text())
line.draw(axes, line.range(), True)
check("openings of rounding fill no panel", axes.get_ylim()[1] > 90 * 1e-8)

# The normals of a graded arc, and what they meet of a plane and of a disc that they pass by.
angles = np.cumsum(np.concatenate([[-1.5], np.tile([0.02, 0.02, 0.05, 0.1, 0.05], 6)]))
circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
faces = np.stack([circle[:-1], circle[1:]], axis=1)
middles = faces.sum(1) / np.linalg.norm(faces.sum(1), axis=1)[:, None]
normals = plot.normals_at_ends(faces, middles)
check("normals of an arc", np.allclose(normals, faces.reshape(-1, 2), atol=1e-9))
x = np.stack([np.linspace(-3., 3., 601), np.zeros(601)], axis=1)
height = np.hypot(x[:, 0], 2.)
disc = np.where(abs(x[:, 0]) < 1., 2. - np.sqrt(np.maximum(1. - x[:, 0]**2, 0.)), np.sqrt(height**2 - 1.))
normals = np.tile([0., -1.], (601, 1))
check("a disc is drawn where normals meet it", (plot.is_passed(x + disc[:, None] * normals, normals, disc) == (abs(x[:, 0]) > 0.995)).mean() > 0.99)
for name, gap in (("plane", 0.5 + 0.3 * x[:, 0]), ("steep plane", 1000. * abs(x[:, 0]))):
    check(f"  a {name} everywhere", not plot.is_passed(x + gap[:, None] * normals, normals, gap).any())

os.chdir(tempfile.mkdtemp())
# A steep foundation is touched along 1/1000 of the side.
done = run(f"{scenes}/b1.prm", "b1", "Discretization/Finest level=5", "Output/Pictures=true")
check("the program draws", done.returncode == 0 and "Pictures:" not in done.stdout and os.path.exists("b1/pressure.svg"))
done = subprocess.run([sys.executable, script, "b1", "--facts", "--format", "png"], capture_output=True, text=True, check=False)
with open("b1/deformed.svg", encoding="utf-8") as file:
    facts = check_pictures("b1", done.returncode, done.stdout, done.stderr, file.read())
check("  pressure, body, convergence", {"pressure", "deformed", "convergence"} <= names(facts))
lines = open("b1/convergence.md", encoding="utf-8").read().splitlines()
check("  a table of three levels in Markdown", len(lines) == 5 and len({line.count("|") for line in lines}) == 1)
check("  and in LaTeX", open("b1/convergence.tex", encoding="utf-8").read().count("&") == 4 * (lines[0].count("|") - 2))
whole = plot.draw
plot.draw = plot.draw_deformed
with open("other", "w", encoding="utf-8") as file:
    file.write("untouched")
for name in ("deformed.svg", ".deformed.svg.part", ".deformed.png.part"):
    if os.path.lexists("b1/" + name):
        os.unlink("b1/" + name)
    os.symlink("../other", "b1/" + name)
facts = draw("b1", "--factor", "1e9", "--format", "svg", "png")
check("  links are not written through", open("other", encoding="utf-8").read() == "untouched" and not os.path.islink("b1/deformed.svg"))
plot.draw = whole
check("  a factor that would fold cells is not used", facts["factor"] < 1e9)
with open("b1/deformed.svg", encoding="utf-8") as file:
    check("  two formats, both state it", facts["files"] == ["deformed.svg", "deformed.png"] and f"× {facts['factor']:g}" in file.read())
with open("narrow.prm", "w", encoding="utf-8") as file:
    file.write("subsection Boundary\n set Displacement = top: 0; -1e-7\n set Contact = bottom\nend\n"
               "subsection Contact\n set Gap = 0.5*(x-0.3)^2\nend\nsubsection Discretization\n set Strategy = hp\nend\n")
done = run("narrow.prm", "narrow", "Output/Pictures=true", environment={**os.environ, "PATH": os.getcwd()})
check("a narrow zone; without Python a run succeeds", done.returncode == 0)
check("  and says what to install", "\nPictures: not drawn, because Python's matplotlib is missing (the package python3-matplotlib" in
      done.stdout and "draw them later with" in done.stdout)
facts = draw("narrow")
(zone,), views = facts["zones"]["bottom"], facts["views"]["bottom"]
check("  of less than 1/300 of the side", 0. < zone[1] - zone[0] < 1 / 300 and zone[0] < 0.3 < zone[1])
check("  is seen whole, and between 1/3 and 2/3 of its view", len(views) == 2 and views[0] == [0., 1.] and
      views[1][0] < zone[0] < zone[1] < views[1][1] and 1 / 3 < (zone[1] - zone[0]) / (views[1][1] - views[1][0]) < 2 / 3)
check("  and so is the mesh, all its cells with their degrees", "mesh-" in "".join(facts["files"]) and
      sum(facts["degrees"].values()) == plot.read_csv("narrow/convergence.csv")["cells"][-1])
def grid_in_space(point, m, n):
    """Returns the faces of a grid of m × n on a surface over the unit square."""
    s, t = np.meshgrid(np.linspace(0., 1., m + 1), np.linspace(0., 1., n + 1), indexing="ij")
    x = np.stack(point(s, t), axis=-1)
    return np.stack([x[:-1, :-1], x[1:, :-1], x[1:, 1:], x[:-1, 1:]], axis=2).reshape(-1, 4, 3)


plane = grid_in_space(lambda s, t: (3 * s, 2 * s + t, 6 * s - 2 * t), 4, 3)
shaft = grid_in_space(lambda s, t: (2 * np.cos(7 * s), 3 * t, 2 * np.sin(7 * s)), 60, 3)[:-6]  # 6.3 > 2 pi: it overlaps itself
ball = grid_in_space(lambda s, t: (np.sin(3 * s) * np.cos(6.2 * t), np.sin(3 * s) * np.sin(6.2 * t), -np.cos(3 * s)), 20, 30)[30:]
for name, faces, same in (("a plane", plane, 1e-12), ("a shaft", shaft, 1e-2)):
    polygons, _, directions = plot.flattened(faces, np.zeros(len(faces), dtype=bool))
    lengths = np.linalg.norm(plot.edges_of(faces)[:, :, 1] - plot.edges_of(faces)[:, :, 0], axis=2)
    flat = np.linalg.norm(plot.edges_of(polygons)[:, :, 1] - plot.edges_of(polygons)[:, :, 0], axis=2)
    check(f"{name} in space keeps its lengths when it is flattened", np.allclose(flat, lengths, rtol=same) and
          (directions is None) == (name == "a shaft"))
polygons = plot.flattened(ball, np.arange(len(ball)) < 30)[0]
check("a ball keeps the distances from the middle of its zone", np.allclose(
    np.linalg.norm(polygons, axis=2), np.arccos(np.clip(-ball[..., 2], -1., 1.)), atol=0.02))
cube = np.concatenate([grid_in_space(lambda s, t, d=d, e=e: np.roll((np.full_like(s, e), s if e else t, t if e else s), d, axis=0), 2, 2)
                       for d in range(3) for e in (0, 1)])
check("the edges of a cube", len(plot.sharp_edges(cube)) == 24)
check("a sphere in 3-D", run(f"{scenes}/space/sphere.prm", "sphere", "Discretization/Finest level=3").returncode in (0, 2))
facts = draw("sphere")
with open("sphere/answer.json", encoding="utf-8") as file:
    check("  the area of contact", abs(facts["area"]["bottom"] / json.load(file)["contact_area"] - 1) < 1e-5)
check("  a zoomed view", len(facts["views"]["bottom"]) == 2)
with open("roller.prm", "w", encoding="utf-8") as file:
    file.write("set Dimension = 3\nsubsection Geometry\n set Shape = cylinder\n set Axis = y\n set Sector = quarter\n set Length = 0.5\nend\n"
               "subsection Boundary\n set Contact = round\n set Rollers = left front back\n set Displacement = top: 0; 0; -0.01\nend\n"
               "subsection Contact\n set Foundation = plane 0,0,-1 normal 0,0,1\nend\n"
               "subsection Discretization\n set Coarsest level = 1\n set Finest level = 2\nend\n")
check("a cylinder on a plane", run("roller.prm", "roller").returncode in (0, 2))
facts = draw("roller")
# Three cells of each end, two of the round side and of each plane of symmetry, in sixteen faces.
check("  cells that bend meet their neighbours", facts["surface"] == 12 * 16)
done = subprocess.run([program, f"{scenes}/space/sphere.prm", "--check", "--output", "shown"], capture_output=True, text=True, check=False)
code, out, errors = draw_here("shown", "--scene", "--facts", "--format", "png")
check("a scene in 3-D before it is solved", done.returncode == 0 and code == 0 and not errors)
check("  all its sides", code == 0 and np.allclose(list(json.loads(out)["areas"].values()), np.ones(6)))
check("  with their names and roles", "bottom: contact" in words["scene"] and "front: rollers" in words["scene"])
check("friction", run(f"{scenes}/friction/k1.prm", "k1", "Discretization/Finest level=3", "Output/Inf-sup constant=false").returncode in (0, 2))
facts = draw("k1")
with open("k1/answer.json", encoding="utf-8") as file:
    zones = [[zone["start"]["arc_length"], zone["end"]["arc_length"]] for zone in json.load(file)["friction"]["stick_zones"]]
check("  the zones of stick", np.allclose(facts["stick"]["bottom"], zones))
check("  and the limits of friction", "limits of friction" in words["pressure"])
code, _, errors = draw_here("nowhere")
check("no folder: one sentence", code == 1 and errors.count("\n") == 1 and "there is no folder 'nowhere'" in errors)
code, _, errors = draw_here(".")
check("no results: one sentence", code == 1 and errors.count("\n") == 1 and "has no results" in errors)
for option in ("--width=-5mm", "--width=0in", "--width=5", "--factor=nan", "--factor=-1", "--units=a,b,c,d"):
    code, _, errors = draw_here("b1", option)
    check(f"{option}: refused in a sentence", code == 1 and ": found '" in errors and "allowed: " in errors and "Traceback" not in errors)
os.mkdir("sweep")
with open("sweep/sweep.csv", "w", encoding="utf-8") as file:
    file.write("push,E,level,dofs,contact_force,peak_pressure,energy,estimate,bound,seconds,reaction_top_x,fillet,verdict\n" + "".join(
        f"{push},{E},3,10,{push * E},1,1,1,1,1,0,{push},certified\n" for push in (1, 4, 2) for E in (1, 3)))
code, out, _ = draw_here("sweep", "--facts", "--format", "svg")
check("a sweep: numbers over the parameter with most values", code == 0 and json.loads(out) == {
    "along": "push", "curves": ["E = 1", "E = 3"], "numbers": ["contact_force", "peak_pressure", "fillet"], "files": ["sweep.svg"]})
done = subprocess.run([sys.executable, "-S", "-E", script, "--help"], capture_output=True, text=True, check=False)
check("--help needs no package", done.returncode == 0 and "--width" in done.stdout)
plot.Results.save = lambda results, figure, name: plot.pyplot.close(figure)  # what is read counts here
for name in ["certificate.json", "convergence.csv"] + sorted(name for name in os.listdir("narrow") if name.endswith(".vtu")):
    with open(os.path.join("narrow", name), "rb") as file:
        whole = file.read()
    with open(os.path.join("narrow", name), "wb") as file:
        file.write(whole[:len(whole) // 2 - 3])
    code, _, errors = draw_here("narrow")
    check(f"half of {name}: drawn, or one sentence", code == 0 or errors.count("\n") == 1 and "damaged or incomplete" in errors)
    check("  which names the file", name.endswith(".csv") or name in errors)
    with open(os.path.join("narrow", name), "wb") as file:
        file.write(whole)
sys.exit(failures > 0)
