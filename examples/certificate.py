"""A proof that there is no path, written to a file, read back and checked without the planner.

The checker is plain Python on exact numbers. It prints::

    planner: no_path, checker: no_path by 254 cells
    without one of them: start_side, x = 0.25: has a face that is neither shared nor FULL
"""

import json
import tempfile
from pathlib import Path

from planar_planner import CertificateError, solve, verify_certificate

result = solve("gear-jammed", certificate=True)
with tempfile.TemporaryDirectory() as folder:
    file = Path(folder, "jammed.json")
    file.write_text(json.dumps(result.certificate), encoding="utf-8")
    certificate = json.loads(file.read_text(encoding="utf-8"))

report = verify_certificate("gear-jammed", certificate)
cells = certificate["full"]  # each lies wholly in collision
print(f"planner: {result.verdict}, checker: {report.verdict} by {len(cells)} cells")

cells.pop()
try:
    verify_certificate("gear-jammed", certificate)
except CertificateError as error:
    print(f"without one of them: {error}")
