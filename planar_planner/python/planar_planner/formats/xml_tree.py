"""The reader of XML: an element tree without namespaces and without the file's own entities."""

from __future__ import annotations

from xml.etree import ElementTree
from xml.parsers import expat

from planar_planner.errors import SceneError, cut


def parse_xml(data: bytes, root: str, *, namespaces: bool = False) -> ElementTree.Element:
    """Return the root element of a file, tags with ``{namespace}`` only if asked for.

    Raises
    ------
    SceneError
        If it is not XML, has another root, or defines entities, which can grow without bound.
    """
    _refuse_entities(data)
    try:
        tree = ElementTree.fromstring(data)
    except ElementTree.ParseError as error:
        line, column = error.position
        raise SceneError(f"is not XML: {error.args[0]}", f"line {line}, column {column}") from None
    except (ValueError, LookupError) as error:  # an unknown encoding
        raise SceneError(f"is not XML: {error}") from None
    if tree.tag.rpartition("}")[2] != root:
        raise SceneError(f"must be a {root} file", value=cut(str(tree.tag).rpartition("}")[2]))
    if not namespaces:
        for element in tree.iter():
            if isinstance(element.tag, str):
                element.tag = element.tag.rpartition("}")[2]
    return tree


def _refuse_entities(data: bytes) -> None:
    """Raise if a file defines entities, in whatever encoding; expat meets them before any use."""

    def refuse(*_: object) -> None:
        raise SceneError("defines XML entities, which are not read")

    parser = expat.ParserCreate()
    parser.EntityDeclHandler = refuse
    try:
        parser.Parse(data, True)
    except SceneError:
        raise
    except (expat.ExpatError, ValueError, LookupError):
        return  # the reader of the tree says what is wrong
