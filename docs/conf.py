"""Settings of the documentation, for Sphinx.

From a clone, without network once the packages are there::

    pip install ".[docs]" && sphinx-build -W --keep-going docs build/docs

The API reference is made from the docstrings of the installed package.
"""

from __future__ import annotations

from importlib.metadata import metadata

_package = metadata("planar-planner")
project = _package["Name"]
author = "The planar-planner authors"
version = release = _package["Version"]

extensions = ["myst_parser", "sphinx.ext.autodoc", "numpydoc"]
html_theme = "furo"
html_title = f"{project} {release}"
html_copy_source = False
html_show_copyright = False
html_show_sphinx = False

# Headings are linked to by the names that GitHub gives them, so that links work in both places.
myst_heading_anchors = 4

autodoc_mock_imports = ["ompl"]  # an extra that need not be there to be documented
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # docstrings give types with shapes and units
numpydoc_show_class_members = False  # the class lists its members itself
default_role = "py:obj"
