"""The checker of certificates: docs/certificate.md as code, in exact arithmetic.

Its files are the parts of the proof:

- ``verify``: the order of the checks.
- ``json_reader``, ``form``, ``records``: a certificate is read, from bytes to records.
- ``arithmetic``, ``extents``: integers for lengths, enclosures of cosines and sines; boxes.
- ``demands``: how a certificate is rejected.
- ``case``, ``pieces``: the scene in integers, and the convex pieces that partition its polygons.
- ``collisions``: a box of configurations is FULL.
- ``separation``, ``cover``, ``goal_area``, ``absence``: there is no path.
- ``path``: a path is free.

The checker shares with the planner what reads a scene: the packages `planar_planner.scene` and
`planar_planner.problem` with the fingerprint, `planar_planner.load` with the importers behind it,
and small modules that these need; and the list of keys in `planar_planner.certificate_keys`. It
imports nothing of `planar_planner.planning` and no native code. tests/planner/checker/
test_verify_independence.py has the whole list, and holds it.
"""
