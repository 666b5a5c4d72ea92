"""How well a grasp resists wrenches: grasp wrench sets, hands, force closure, force efficiency.

Source: [GFE] Zheng, Yamane, *Evaluation of Grasp Force Efficiency Considering Hand Configuration
and Using Novel Generalized Penetration Distance Algorithm*, ICRA 2013.
"""

from pdg.grasp.active_forces import ActiveForces, ForceCase
from pdg.grasp.contacts import (
    Contact,
    ContactKind,
    contact_map,
    frictionless,
    point_contact,
    soft_finger,
)
from pdg.grasp.efficiency import (
    ClosureState,
    ForceClosure,
    ForceEfficiency,
    force_closure,
    force_efficiency,
)
from pdg.grasp.hand import (
    Finger,
    Joint,
    JointKind,
    JointMode,
    active_wrench_set,
    finger,
    finger_forces,
    prismatic,
    revolute,
)
from pdg.grasp.wrenches import ForceNorm, WrenchSet, grasp_wrench_set

__all__ = [
    "ActiveForces",
    "ClosureState",
    "Contact",
    "ContactKind",
    "Finger",
    "ForceCase",
    "ForceClosure",
    "ForceEfficiency",
    "ForceNorm",
    "Joint",
    "JointKind",
    "JointMode",
    "WrenchSet",
    "active_wrench_set",
    "contact_map",
    "finger",
    "finger_forces",
    "force_closure",
    "force_efficiency",
    "frictionless",
    "grasp_wrench_set",
    "point_contact",
    "prismatic",
    "revolute",
    "soft_finger",
]
