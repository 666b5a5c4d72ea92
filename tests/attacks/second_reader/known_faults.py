"""Features whose import is silently wrong today; a line goes when its fault is mended."""

OF: dict[str, set[str]] = {
    "svg": set(),
    "dxf": set(),
    "map": set(),
    "mesh": set(),
    "wkt": set(),
    "geojson": set(),
    "yap": set(),
    "tpcap": set(),
    "discopygal": set(),
    "dynobench": set(),
    "octile": set(),
}
