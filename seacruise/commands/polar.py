"""``seacruise polar``: what a yacht is said to sail. Each action is a module with ``add_parser``."""

from __future__ import annotations

import argparse

from seacruise.commands import polar_compare, polar_convert, polar_fit, polar_hull, polar_plot, polar_show

ACTIONS = (polar_show, polar_plot, polar_hull, polar_compare, polar_convert, polar_fit)
"""In the order of the help text."""


def add_parser(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the sub-command and what it can do."""
    parser = commands.add_parser("polar", help="what a yacht is said to sail")
    actions = parser.add_subparsers(dest="action", required=True, metavar="ACTION")
    for action in ACTIONS:
        action.add_parser(actions)
