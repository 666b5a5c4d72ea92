"""Ways to tamper with a certificate, or with the scene under it; none of them may pass.

A mutation takes copies of a scene and a valid certificate that it may change, and returns both,
or None where it does not apply. "Signed" mutants carry the hash of the changed scene, so that it is
the geometry that must give them away.
"""

from worlds.certificate_mutations import (
    any_certificate,
    discs_and_ends,
    exact_fits,
    goals,
    joints,
    paths,
    separations,
)
from worlds.certificate_mutations.registry import MUTATIONS, Json, mutant

# Importing them registers theirs.
PARTS = (any_certificate, paths, separations, joints, discs_and_ends, exact_fits, goals)

__all__ = ["MUTATIONS", "PARTS", "Json", "mutant"]
