"""The same scene by this planner and by one of OMPL's; needs the extra ``[ompl]``.

A sampler's path is looked at state by state; ours is proven free along its whole length, and so
this planner can judge the sampler's. It prints::

    ours: path
    RRTConnect, seed 1: found, sound
    RRTConnect, seed 2: found, sound
"""

from planar_planner import OptionsError
from planar_planner.ompl.compare import Settings, compare

try:
    found = compare("slot", Settings(planners=("RRTConnect",), runs=2, timeout=5.0))
except OptionsError as error:
    raise SystemExit(f"OMPL is missing: {error}") from None

print(f"ours: {found.ours[0].verdict}")
for planner, runs in found.samplers.items():
    for run in runs:
        said = "found" if run.exact else "not found"
        print(f"{planner}, seed {run.seed}: {said}, {run.soundness}")
