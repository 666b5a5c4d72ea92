"""Compact convex sets of R^n by support function and support mapping.

A set is known by h(u) = max of u·x over the set and by s(u), a point that attains it ([GFE] Eq.
17). Ready-made sets are compiled; any object with `dimension` and `support` serves as well, but
each question then costs a call into Python.

Source: [GFE] Zheng, Yamane, *Evaluation of Grasp Force Efficiency Considering Hand Configuration
and Using Novel Generalized Penetration Distance Algorithm*, ICRA 2013.
"""

from pdg.sets.bodies import (
    Ball,
    Box,
    CrossPolytope,
    Ellipsoid,
    PointSet,
    Segment,
)
from pdg.sets.composites import AffineImage, MinkowskiSum, Scaled, UnionHull
from pdg.sets.convex_set import ConvexSet, SupportSet, as_convex_set

__all__ = [
    "AffineImage",
    "Ball",
    "Box",
    "ConvexSet",
    "CrossPolytope",
    "Ellipsoid",
    "MinkowskiSum",
    "PointSet",
    "Scaled",
    "Segment",
    "SupportSet",
    "UnionHull",
    "as_convex_set",
]
