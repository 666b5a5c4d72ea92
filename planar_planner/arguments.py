"""Command-line arguments; light to import, since every start of the program pays for it."""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from planar_planner.import_arguments import add_importing
from planar_planner.options import Options
from planar_planner.samplers import DEFAULT_SAMPLERS

PLOT_SUFFIXES = (".png", ".svg", ".pdf")

_DEFAULTS = Options()
_UNITS = {"": 1, "K": 2**10, "M": 2**20, "G": 2**30, "T": 2**40}

_EXAMPLES = """\
examples:
  planar-planner solve gear --plot gear.png
  planar-planner check gear-jammed
  planar-planner solve my_scene.json --start 1,2,0 --goal 8,2,1.5708 --json result.json
  planar-planner solve gear --certificate gear.cert.json
  planar-planner verify gear gear.cert.json
  planar-planner list
  planar-planner show maze --plot maze.png
  planar-planner convert map.yaml scene.json --robot robot.wkt --start 1,1,0 --goal 8,5,0
  planar-planner solve drawing.svg --flatten inwards --tolerance 0.01

exit status: 0 path, 1 no path (proven), 2 bad input or usage, 3 undecided
of verify:   0 valid, 1 rejected, 2 unreadable"""


class _Version(argparse.Action):
    """Look the version up only when it is asked for."""

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> None:
        import planar_planner

        parser.exit(message=f"planar-planner {planar_planner.__version__}\n")


def make_parser() -> argparse.ArgumentParser:
    """Return the parser; each command sets ``run``, a function of the parsed arguments."""
    parser = argparse.ArgumentParser(
        prog="planar-planner",
        description="Complete motion planning for polygonal robots in the plane: a certified path, "
        "a proof that there is none, or an honest undecided.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("--version", action=_Version, nargs=0, help="show the version and exit")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    _add_solve(commands)
    _add_check(commands)
    _add_verify(commands)
    _add_list(commands)
    _add_show(commands)
    _add_compare(commands)
    _add_convert(commands)
    return parser


def with_joined_numbers(argv: Sequence[str]) -> list[str]:
    """Write ``--start -1,2,0`` as ``--start=-1,2,0``, which argparse would take for an option."""
    joined: list[str] = []
    for argument in argv:
        if joined and joined[-1] in ("--start", "--goal") and re.match(r"-[\d.]", argument):
            joined[-1] += f"={argument}"
        else:
            joined.append(argument)
    return joined


def _add_solve(commands: Any) -> None:
    solve = _add_command(commands, "solve", "find a path, or prove that there is none")
    _add_query(solve)
    _add_plot(solve, "draw the scene and the result")
    solve.set_defaults(run=_run_solve, verdict_only=False)


def _add_check(commands: Any) -> None:
    check = _add_command(commands, "check", "like solve, but print only the verdict")
    _add_query(check)
    check.set_defaults(run=_run_solve, plot=None, verdict_only=True)


def _add_verify(commands: Any) -> None:
    verify = _add_command(commands, "verify", "check a certificate with independent, exact code")
    _add_scene(verify)
    verify.add_argument("certificate", metavar="CERT", help="what solve --certificate has written")
    add_importing(verify)
    _add_json(verify, "the finding")
    _add_contact_tolerance(verify, "the ends of a path may have been moved")
    verify.set_defaults(run=_run_verify)


def _add_list(commands: Any) -> None:
    listing = _add_command(
        commands, "list", "list the built-in scenes with size, expected verdict and origin"
    )
    listing.set_defaults(run=_run_list)


def _add_show(commands: Any) -> None:
    show = _add_command(commands, "show", "describe a scene, and draw it, without solving it")
    _add_scene(show)
    add_importing(show)
    _add_plot(show, "draw the scene")
    show.set_defaults(run=_run_show)


def _add_compare(commands: Any) -> None:
    compare = _add_command(commands, "compare", "compare with OMPL's planners in one run")
    compare.add_argument(
        "scenes",
        metavar="SCENE",
        nargs="+",
        help="built-in names (see list) or files: scenes or outside formats",
    )
    compare.add_argument(
        "--planners",
        metavar="A,B,…",
        default=",".join(DEFAULT_SAMPLERS),
        help="OMPL's planners by name (default: %(default)s)",
    )
    for name, metavar, kind, default, what in (
        ("runs", "N", int, 11, "runs of each planner"),
        ("limit", "SECONDS", float, 10.0, "time of a run"),
        ("resolution", "FRACTION", float, 0.002, "of OMPL's motion validation"),
        ("seed", "N", int, 0, "run i (from 0) of a planner has the seed N + i + 1"),
    ):
        compare.add_argument(
            f"--{name}",
            metavar=metavar,
            type=kind,
            default=default,
            help=f"{what} (default: %(default)s)",
        )
    compare.add_argument(
        "--json", metavar="FILE", help="write all runs as JSON; - for standard output"
    )
    add_importing(compare)
    _add_plot(compare, "draw times to the first solution")
    compare.set_defaults(run=_run_compare)


def _add_convert(commands: Any) -> None:
    convert = _add_command(
        commands, "convert", "turn a file in an outside format into a scene file, or back"
    )
    _add_scene(convert)
    convert.add_argument(
        "out",
        metavar="OUT",
        type=Path,
        help="file to write: .json for a scene; .geojson, .wkt, .svg, .dxf, .csv, .txt (with .rob)",
    )
    add_importing(convert)
    convert.add_argument("--quiet", action="store_true", help="do not tell what was repaired")
    convert.set_defaults(run=_run_convert)


def _add_command(commands: Any, name: str, summary: str) -> argparse.ArgumentParser:
    command: argparse.ArgumentParser = commands.add_parser(
        name, help=summary, description=summary, allow_abbrev=False
    )
    return command


def _add_scene(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "scene",
        metavar="SCENE",
        help="a built-in name (see list) or a file: scene or outside format",
    )


def _add_plot(command: argparse.ArgumentParser, what: str) -> None:
    command.add_argument(
        "--plot", metavar="FILE", type=_picture, help=f"{what}: {', '.join(PLOT_SUFFIXES)}"
    )


def _add_json(command: argparse.ArgumentParser, what: str) -> None:
    command.add_argument(
        "--json", metavar="FILE", help=f"write {what} as JSON; - for standard output"
    )


def _add_contact_tolerance(command: Any, what: str) -> None:
    command.add_argument(
        "--contact-tolerance",
        type=float,
        metavar="LENGTH",
        default=_DEFAULTS.contact_tolerance,
        help=f"how far {what} off contact (default: %(default)g)",
    )


def _add_query(command: argparse.ArgumentParser) -> None:
    _add_scene(command)
    add_importing(command)
    _add_json(command, "the result")
    command.add_argument(
        "--certificate",
        metavar="FILE",
        type=Path,
        help="write the evidence for the answer, compressed if the name ends in .gz; see verify",
    )
    command.add_argument(
        "--quiet", action="store_true", help="no statistics and no progress, only the verdict"
    )
    _add_limits(command)


def _add_limits(command: argparse.ArgumentParser) -> None:
    limits = command.add_argument_group("limits", "reaching one makes the verdict undecided")
    limits.add_argument(
        "--resolution",
        type=float,
        metavar="FRACTION",
        default=_DEFAULTS.resolution,
        help="smallest cell relative to the scene (default: %(default)g)",
    )
    limits.add_argument(
        "--max-cells",
        type=int,
        metavar="N",
        default=_DEFAULTS.max_cells,
        help="cells (default: %(default)s)",
    )
    limits.add_argument(
        "--timeout",
        type=float,
        metavar="SECONDS",
        default=_DEFAULTS.timeout,
        help="time of the search, or inf (default: %(default)g)",
    )
    limits.add_argument(
        "--max-memory",
        type=_bytes,
        metavar="BYTES",
        default=_DEFAULTS.max_memory,
        help="memory of the cells, with unit K, M, G or T (default: 4G)",
    )
    _add_contact_tolerance(limits, "a touching start or goal may be moved")


def options_of(arguments: argparse.Namespace) -> Options:
    """Return the limits that the arguments state."""
    return Options(
        resolution=arguments.resolution,
        max_cells=arguments.max_cells,
        timeout=arguments.timeout,
        max_memory=arguments.max_memory,
        contact_tolerance=arguments.contact_tolerance,
    )


def _bytes(text: str) -> int:
    match = re.fullmatch(
        r"(\d{1,18}(?:\.\d{1,9})?)\s*([KMGT]?)(?:i?B)?", text.strip(), re.IGNORECASE
    )
    if match is None:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of bytes such as 512M or 4G")
    return int(float(match[1]) * _UNITS[match[2].upper()])


def _picture(text: str) -> Path:
    file = Path(text)
    if file.suffix.lower() not in PLOT_SUFFIXES:
        raise argparse.ArgumentTypeError(
            f"cannot tell the format of {text!r}; it must end in {', '.join(PLOT_SUFFIXES)}"
        )
    return file


def _run_solve(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.solve import run

    return run(arguments)


def _run_verify(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.verify import run

    return run(arguments)


def _run_list(_: argparse.Namespace) -> int:
    from planar_planner.commands.listing import run

    return run()


def _run_show(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.show import run

    return run(arguments)


def _run_compare(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.compare import run

    return run(arguments)


def _run_convert(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.convert import run

    return run(arguments)
