"""Draw the pictures of docs/pdg.md: ``python docs/draw_pdg.py``."""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Polygon
from numpy.typing import NDArray

import pdg

mpl.use("Agg")
import matplotlib.pyplot as plt

PICTURES = Path(__file__).parent / "pictures"
# Okabe and Ito's colours: told apart by colour-blind readers too.
BLUE, ORANGE, GREEN, GREY = "#0072B2", "#D55E00", "#009E73", "#999999"
Pose = tuple[float, float, float]
Ring = NDArray[np.float64]

HAMMER = np.array(
    [(-0.3, -3), (0.3, -3), (0.3, 0), (1.2, 0), (1.2, 0.8), (-1.2, 0.8), (-1.2, 0), (-0.3, 0)]
)
PEG = np.array([(-0.3, -3), (0.3, -3), (0.3, 0), (-0.3, 0)])
BLOCK = np.array(
    [
        (-3, -3.6),
        (3, -3.6),
        (3, -0.6),
        (0.36, -0.6),
        (0.36, -3.1),
        (-0.36, -3.1),
        (-0.36, -0.6),
        (-3, -0.6),
    ]
)


def placed(ring: Ring, pose: Pose) -> Ring:
    """Return the vertices at a configuration."""
    x, y, theta = pose
    c, s = np.cos(theta), np.sin(theta)
    return np.asarray(ring @ np.array([[c, s], [-s, c]]) + (x, y))


def body(axes: Axes, ring: Ring, colour: str, label: str = "", *, filled: bool = True) -> None:
    """Draw a polygon."""
    style = "-" if filled else "--"
    face = mpl.colors.to_rgba(colour, 0.35 if filled else 0.0)
    axes.add_patch(Polygon(ring, closed=True, fc=face, ec=colour, lw=1.5, ls=style, label=label))


def _pair(point: NDArray[np.float64]) -> tuple[float, float]:
    return float(point[0]), float(point[1])


def arrow(axes: Axes, start: NDArray[np.float64], end: NDArray[np.float64], colour: str) -> None:
    """Draw an arrow."""
    axes.annotate(
        "", _pair(end), _pair(start), arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 2}
    )


def finish(figure: mpl.figure.Figure, name: str) -> None:
    """Write the file."""
    for axes in figure.axes:
        axes.set_aspect("equal")
        axes.autoscale_view()
        axes.set_axis_off()
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0), frameon=False, ncols=2)
    figure.savefig(PICTURES / f"pdg_{name}.png", dpi=110, bbox_inches="tight")
    plt.close(figure)


def translational() -> None:
    """Draw PD^t of a convex pair, and the distance of one that is apart."""
    a = np.array([(-1, -0.8), (1.2, -0.5), (0.8, 0.9), (-0.7, 0.7)])
    b = np.array([(0, -1.5), (2.6, -1.2), (3, 1), (0.4, 1.3)])
    figure, panels = plt.subplots(1, 2, figsize=(9, 3.6))
    for axes, pose in zip(panels, [(0.3, 0.0, 0.1), (-1.9, 0.2, 0.1)], strict=True):
        found = pdg.translational_depth(a, b, pose)
        body(axes, b, GREY, "B")
        body(axes, placed(a, pose), BLUE, "A")
        step = found.depth * np.array(found.direction)
        body(axes, placed(a, pose) + step, ORANGE, "A after the push", filled=False)
        arrow(axes, np.array(found.on_a), np.array(found.on_b), ORANGE)
        axes.set_title(f"{found.state}: depth {found.depth:.2f}")
    finish(figure, "translational")


def generalized() -> None:
    """Draw how far a peg in a notch must be moved, without and with turning."""
    pose = (0.0, 0.1, 0.12)
    without = pdg.translational_depth(PEG, BLOCK, pose)
    lower = pdg.generalized_depth_lower_bound(PEG, BLOCK, pose).lower
    upper = pdg.generalized_depth_upper_bound(PEG, BLOCK, pose)
    pushed = placed(PEG, pose) + without.depth * np.array(without.direction)
    turned = placed(PEG, upper.placement.pose)
    figure, panels = plt.subplots(1, 2, figsize=(9, 5))
    titles = [
        (pushed, f"translation only: PD$^t$ = {without.depth:.3f}"),
        (turned, f"turning too: LB {lower:.3f} ≤ PD$^g$ ≤ UB {upper.upper:.3f}"),
    ]
    for axes, (ring, title) in zip(panels, titles, strict=True):
        body(axes, BLOCK, GREY, "B")
        body(axes, placed(PEG, pose), BLUE, "A")
        body(axes, ring, ORANGE, "A, free", filled=False)
        axes.set_title(title)
    finish(figure, "generalized")


def distance() -> None:
    """Draw DISP, and the motion whose longest path bounds D_g."""
    start, end = (0.0, 0.0, 0.0), (1.5, -2.0, 2.0)
    bounds = pdg.generalized_distance_bracket(HAMMER, start, end)
    figure, axes = plt.subplots(figsize=(6.5, 5))
    body(axes, placed(HAMMER, start), BLUE, "A(q₀)")
    body(axes, placed(HAMMER, end), GREEN, "A(q₁)")
    steps = np.linspace(0, 1, 101)
    centre = np.array([bounds.centre])
    ends = [placed(centre, q)[0] for q in (start, end)]
    paths = np.array(
        [placed(HAMMER - centre, (*(ends[0] + s * (ends[1] - ends[0])), s * end[2])) for s in steps]
    )
    for k in range(paths.shape[1]):
        axes.plot(
            *paths[:, k].T, color=ORANGE, lw=0.8, label="paths of vertices" if k == 0 else None
        )
    axes.plot(
        *np.array(ends).T, color="black", lw=1, ls=":", marker="o", ms=4, label="centre, straight"
    )
    moved = np.hypot(*(placed(HAMMER, end) - placed(HAMMER, start)).T)
    far = int(np.argmax(moved))
    arrow(axes, placed(HAMMER, start)[far], placed(HAMMER, end)[far], "black")
    axes.set_title(f"DISP = {moved.max():.3f};  {bounds.lower:.3f} ≤ D$_g$ ≤ {bounds.upper:.3f}")
    finish(figure, "distance")


def query() -> None:
    """Draw a cell that only the per-normal test proves to be full."""
    square = np.array([(-1.0, -1), (1, -1), (1, 1), (-1, 1)])
    half = 1.9
    figure, axes = plt.subplots(figsize=(5, 4.6))
    body(axes, square, GREY, "B")
    for x in (-half, half):
        for y in (-half, half):
            body(
                axes,
                placed(square, (x, y, 0.0)),
                BLUE,
                "A at the cell's corners" if x == y > 0 else "",
            )
    axes.add_patch(
        Polygon(
            square * half,
            closed=True,
            fill=False,
            ec=ORANGE,
            lw=1.5,
            ls="--",
            label="cell of positions",
        )
    )
    verdicts = {
        m: pdg.c_obstacle_query(square, square, (0, 0, 0, half, half, 0), m).verdict
        for m in ("published", "displacement", "per-normal")
    }
    axes.set_title("\n".join(f"{m}: {v}" for m, v in verdicts.items()))
    finish(figure, "query")


if __name__ == "__main__":
    for draw in (translational, generalized, distance, query):
        draw()
