"""``python -m planar_planner``: the command line."""

from __future__ import annotations

import sys

from planar_planner.cli.main import main

sys.exit(main())
