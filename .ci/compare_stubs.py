"""Compare a committed stub with the one that nanobind generates from the compiled module.

The committed stub has the better types (what is in a dict, which tuples), so types are not
compared: names, kinds, the values of enumerations, and the parameters' names, order and defaults
are.

Usage: compare_stubs.py COMMITTED GENERATED
"""

from __future__ import annotations

import ast
import sys
from pathlib import Path


def interface(stub: str) -> dict[str, str]:
    """Return qualified name → kind and parameters of everything public in a stub."""
    found: dict[str, str] = {}
    _collect(ast.parse(Path(stub).read_text(encoding="utf-8")).body, "", found)
    return found


def _collect(body: list[ast.stmt], prefix: str, found: dict[str, str]) -> None:
    for node in body:
        if isinstance(node, ast.ClassDef):
            found[prefix + node.name] = "class"
            _collect(node.body, f"{prefix}{node.name}.", found)
        elif isinstance(node, ast.FunctionDef):
            found[prefix + node.name] = found.get(prefix + node.name, "") + _parameters(node)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            found[prefix + node.target.id] = "value"
        elif prefix and isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            found[prefix + node.targets[0].id] = ast.unparse(node.value)


def _parameters(node: ast.FunctionDef) -> str:
    if any(isinstance(d, ast.Name) and d.id == "property" for d in node.decorator_list):
        return "property"
    arguments = node.args.posonlyargs + node.args.args + node.args.kwonlyargs
    required = len(arguments) - len(node.args.defaults)
    names = [
        argument.arg + ("=" if i >= required else "")
        for i, argument in enumerate(arguments)
        if argument.arg != "self"  # nanobind calls it so, or makes it positional-only
    ]
    return f"({', '.join(names)})"


def main(committed: str, generated: str) -> int:
    """Print each difference and return whether there are any."""
    old, new = interface(committed), interface(generated)
    different = sorted(name for name in old.keys() | new.keys() if old.get(name) != new.get(name))
    for name in different:
        print(
            f"{committed}: {name}: stub has {old.get(name, 'nothing')}, "
            f"module has {new.get(name, 'nothing')}"
        )
    return bool(different)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
