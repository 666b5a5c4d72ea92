"""The reader of XML: an element tree without namespaces and without the file's own entities."""

from __future__ import annotations

from xml.etree import ElementTree

from planar_planner.errors import SceneError, cut


def parse_xml(data: bytes, root: str) -> ElementTree.Element:
    """Return the root element of a file, tags without their namespaces.

    Raises
    ------
    SceneError
        If it is not XML, has another root, or defines entities, which can grow without bound.
    """
    if b"<!ENTITY" in data:
        raise SceneError("defines XML entities, which are not read")
    try:
        tree = ElementTree.fromstring(data)
    except ElementTree.ParseError as error:
        line, column = error.position
        raise SceneError(f"is not XML: {error.args[0]}", f"line {line}, column {column}") from None
    except (ValueError, LookupError) as error:  # an unknown encoding
        raise SceneError(f"is not XML: {error}") from None
    for element in tree.iter():
        if isinstance(element.tag, str):
            element.tag = element.tag.rpartition("}")[2]
    if tree.tag != root:
        raise SceneError(f"must be a {root} file", value=cut(str(tree.tag)))
    return tree
