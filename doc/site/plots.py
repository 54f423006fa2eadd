# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured tables as curves, and as tables of one page."""
import csv
import re

import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot
from matplotlib.ticker import MaxNLocator

# Table: column of x, columns of y, column that names the curves, axes that are logarithmic. A column "level_" stands for all
# columns level_1, level_2, ...; each row is a curve then.
CURVES = {
    "bound_effectivity": ("level_", [], "scene", "y"),
    "bound_pairs": ("unknowns", ["ratio"], "scene", "x"),
    "bound_unresolved": ("level", ["bound_over_error"], "scene", "y"),
    "compliance_model": ("patches", ["condition"], "body", "x"),
    "cost_levels": ("unknowns", ["contact_s", "no_contact_s"], "of", "xy"),
    "cycles_from_zero": ("cells_per_side", ["contact"], "body", "x"),
    "cycles_nested": ("level", ["to_1e-8", "to_1e-10"], "scene", ""),
    "estimate_few_patches": ("level", ["estimate_over_error"], "scene", ""),
    "flat_punch": ("w_over_a", ["difference"], "", "xy"),
    "graded_pairs": ("unknowns", ["sqrt_of_energy_difference"], "scene", "xy"),
    "h_and_H": ("H", ["u_h1", "u_superclose_h1", "p_l2", "p_dual"], "h", "xy"),
    "multigrid_steps": ("unknowns", ["steps"], "body", "x"),
    "time_to_error_graded": ("seconds", ["error"], "scene", "xy"),
    "unknown_orders": ("level", ["u_h_percent"], "scene", "y"),
    "westergaard": ("unknowns", ["p_l2", "p_dual"], "mesh", "xy"),
}


def number(text):
    """Returns the number of a field, such as 1e-3, 1/16 or +0.2 %, or nothing."""
    match = re.fullmatch(r"([-+]?[\d.]+(?:e[-+]?\d+)?)(?:/(\d+))?(?: %)?", text.strip())
    return float(match[1]) / float(match[2] or 1) if match else None


def curves_of(rows, x, columns, name):
    """Returns {label: [(x, y)]}."""
    curves = {}
    for row in rows:
        if x.endswith("_"):
            curves[row[name]] = [(int(key[len(x):]), number(row[key])) for key in row if key.startswith(x)]
            continue
        for column in columns:
            label = ", ".join(part for part in (row.get(name, ""), column if len(columns) > 1 else "") if part)
            curves.setdefault(label, []).append((number(row[x]), number(row[column])))
    curves = {label: sorted(point for point in points if None not in point) for label, points in curves.items()}
    return {label: points for label, points in curves.items() if len(points) > 1}


def draw(path, target):
    """Draws the curves of a table."""
    x, columns, name, logarithmic = CURVES[path.stem]
    with open(path, encoding="utf-8", newline="") as file:
        curves = curves_of(list(csv.DictReader(file)), x, columns, name)
    figure, axes = pyplot.subplots(figsize=(8, 4.2), layout="constrained")
    many = len(curves) > 20  # the table has their names
    for i, (label, points) in enumerate(curves.items()):
        axes.plot(*zip(*points), marker="os^vD"[i // 10 % 5], ms=4, lw=1.2, label=label, alpha=0.5 if many else 1.)
    if "x" in logarithmic:
        axes.set_xscale("log")
    if "y" in logarithmic:
        axes.set_yscale("log")
    axes.set(xlabel=x.strip("_"), ylabel=", ".join(columns) or "bound / error")
    axes.grid(True, color="#DDDDDD", lw=0.5)
    if "level" in x:
        axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    if many:
        axes.set_title(f"{len(curves)} curves", fontsize="medium")
    elif len(curves) > 1:
        axes.legend(fontsize="small", frameon=False, loc="center left", bbox_to_anchor=(1, 0.5))
    target.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(target, metadata={"Date": None})
    pyplot.close(figure)


def linked(text, folder, target):
    """Returns the page of the tables with links to them, and writes the page tables.md with all of them."""
    page = ["# The tables", "",
            "The numbers of [Measured tables](README.md), which says what they mean and how they were measured.", ""]
    names = sorted(path.stem for path in folder.glob("*.csv"))
    for name in names:
        page += [f"## {name}", ""]
        if name in CURVES:
            draw(folder / f"{name}.csv", target / f"{name}.svg")
            page += [f"![{name}]({name}.svg)", ""]
        (target / f"{name}.csv").write_bytes((folder / f"{name}.csv").read_bytes())
        page += ["```{csv-table}", f":file: {name}.csv", ":header-rows: 1", "```", ""]
    (target / "tables.md").write_text("\n".join(page), encoding="utf-8")
    def link(match):
        return f"[{match[0]}](tables.md#{match[1].lower()})" if match[1] in names else match[0]
    return re.sub(r"(?<!\[)`(\w+)\.csv`", link, text)
