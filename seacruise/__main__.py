"""``python -m seacruise`` is ``seacruise``."""

from __future__ import annotations

import sys

from seacruise.cli import main

sys.exit(main())
