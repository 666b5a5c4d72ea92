"""The form of a certificate: the fields that its objects have, and what may stand in each.

docs/certificate.md has a table for each object; a test compares them. Whether a certificate is true
is decided elsewhere. A certificate is hostile input: whatever is not of this form gives a
`CertificateError` with the place. Lengths become integers in units of `arithmetic.LENGTH_BITS`.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from planar_planner import certificate_keys as keys
from planar_planner.checker.arithmetic import LENGTH_BITS, units
from planar_planner.checker.json_reader import (
    Fields,
    integer,
    leaf,
    list_of,
    mapping_of,
    number,
    object_of,
    read_json,
    tuple_of,
    word,
)
from planar_planner.checker.records import (
    Certificate,
    ChainLink,
    ChainProof,
    Collision,
    DiscProof,
    EndProof,
    FullClaim,
    Interval,
    Joint,
    PairEdges,
    PairTerm,
    PathProof,
    Proof,
    SeparatingLine,
    Separation,
    Separator,
    WallTerm,
    Waypoint,
)
from planar_planner.errors import CertificateError

DEEPEST_LEVEL = 60
"""The deepest level of a box: its sides are at least 2^-60 of the domain's."""
MAX_LENGTH = 2**100
MOST_PLACES = 12
MAX_ANGLE = 2**20
"""In radians and in turns."""

Source = str | os.PathLike[str] | Mapping[str, Any]


def read_certificate(source: Source) -> Certificate:
    """Read a certificate from a file, or from its content.

    Raises
    ------
    CertificateError
        If it cannot be read, or is not of the form.
    """
    content = source if isinstance(source, Mapping) else read_json(source)
    try:
        certificate: Certificate = _CERTIFICATE(content)
    except CertificateError:
        raise
    except ValueError as error:  # an integer of more digits than Python shows
        raise CertificateError("", f"cannot be read: {error}") from None
    return certificate


def _collision(fields: Mapping[str, Any]) -> Collision:
    return Collision(fields.get(keys.PAIR), fields.get(keys.WALL), fields.get(keys.JOINT))


def _full_claim(fields: Mapping[str, Any]) -> FullClaim:
    return FullClaim(fields[keys.BOX], fields.get(keys.AXIS), _collision(fields))


def _term(fields: Mapping[str, Any]) -> PairTerm | WallTerm:
    vertex, weight = fields[keys.VERTEX], fields[keys.WEIGHT]
    if keys.WALL in fields:
        return WallTerm(fields[keys.WALL], vertex, weight)
    return PairTerm(fields[keys.PAIR], (fields[keys.OWNER], fields[keys.EDGE]), vertex, weight)


def _joint(fields: Mapping[str, Any]) -> Joint:
    return Joint(fields[keys.AXES], fields[keys.SUMS])


def _pair_edges(fields: Mapping[str, Any]) -> PairEdges:
    return PairEdges(fields[keys.PAIR], fields[keys.EDGES])


def _separator(items: tuple[Any, ...]) -> Separator:
    return Separator(items[:4], items[4:])


def _waypoint(items: tuple[Any, ...]) -> Waypoint:
    return Waypoint(*items)


def _interval(fields: Mapping[str, Any]) -> Interval:
    return Interval(
        fields[keys.FROM], fields[keys.TO], fields[keys.APART], fields.get(keys.ALONG, [])
    )


def _separating_line(items: tuple[Any, ...]) -> SeparatingLine:
    return SeparatingLine(items[:4], items[4])


def _chain_link(fields: Mapping[str, Any]) -> ChainLink:
    return ChainLink(fields.get(keys.PAIR), fields.get(keys.SIDE))


def _in_units(dyadic: tuple[int, int]) -> int:
    mantissa, exponent = dyadic
    return mantissa << (exponent + LENGTH_BITS)


def _separation(fields: Mapping[str, Any]) -> Separation:
    domain = fields[keys.DOMAIN]
    return Separation(
        domain[keys.LOW],
        domain[keys.SIZE],
        fields[keys.START_SIDE],
        fields[keys.FULL],
        fields[keys.FULL_FACES],
    )


def _certificate(fields: Mapping[str, Any]) -> Certificate:
    return Certificate(
        fields[keys.SCENE],
        fields[keys.ROBOT_PIECES],
        fields[keys.OBSTACLE_PIECES],
        fields.get(keys.OUTSIDE),
        fields.get(keys.REFERENCE),
        _proof(fields),
        fields.get(keys.DECIMAL_PLACES),
    )


def _proof(fields: Mapping[str, Any]) -> Proof:
    if keys.WAYPOINTS in fields:
        return PathProof(*(fields[key] for key in PATH_FIELDS if key != keys.VERDICT))
    if keys.CHAIN in fields:
        return ChainProof(fields[keys.CHAIN])
    if keys.END in fields:
        bounds = keys.REFERENCE_BOUNDS in fields
        return EndProof(fields[keys.END], None if bounds else _collision(fields))
    if keys.DISC in fields:
        return DiscProof(fields[keys.DISC], fields[keys.INSIDE], _separation(fields))
    return _separation(fields)


_TEXT = leaf("a string", lambda v: isinstance(v, str))
_TRUE = leaf("true", lambda v: v is True)
_INDEX = integer(0, 2**31)
_LENGTH = number(MAX_LENGTH, LENGTH_BITS - DEEPEST_LEVEL, units)
_PART = number(1, LENGTH_BITS - DEEPEST_LEVEL, units)
_ANGLE = number(MAX_ANGLE, 1100)
_FINITE = number(2**1000, 1100)  # 1100: every double is a multiple of 2^-1074
_TURNS = integer(-MAX_ANGLE, MAX_ANGLE)
_OWNER = word(keys.OBSTACLE, keys.ROBOT)
_WALL = word(*keys.WALLS)

_POINT = tuple_of(_LENGTH, _LENGTH)
_PAIR = tuple_of(_INDEX, _INDEX, _INDEX, _INDEX)
_SPAN = tuple_of(integer(0, DEEPEST_LEVEL), integer(0, 2**DEEPEST_LEVEL))
_BOX = tuple_of(_SPAN, _SPAN, _SPAN)
_PIECES = mapping_of(list_of(list_of(_POINT)))


def _dyadic(low: int) -> Any:
    """Read [m, e] as m 2^e, a multiple of 2^DEEPEST_LEVEL units, in units."""
    exponent = integer(DEEPEST_LEVEL - LENGTH_BITS, 100)
    return tuple_of(integer(low, 2**200), exponent, convert=_in_units)


TERM_FIELDS: Fields = {
    keys.PAIR: _PAIR,
    keys.OWNER: _OWNER,
    keys.EDGE: _INDEX,
    keys.VERTEX: _INDEX,
    keys.WEIGHT: _FINITE,
}
WALL_TERM_FIELDS: Fields = {keys.WALL: _WALL, keys.VERTEX: _POINT, keys.WEIGHT: _FINITE}
AXES_FIELDS: Fields = {keys.PAIR: _PAIR, keys.EDGES: list_of(tuple_of(_OWNER, _INDEX))}
JOINT_FIELDS: Fields = {
    keys.AXES: list_of(object_of(AXES_FIELDS, convert=_pair_edges)),
    keys.SUMS: list_of(list_of(object_of(TERM_FIELDS, WALL_TERM_FIELDS, convert=_term))),
}

_PAIR_COLLISION: Fields = {keys.PAIR: _PAIR}
_WALL_COLLISION: Fields = {keys.WALL: _WALL}
_JOINT_COLLISION: Fields = {keys.JOINT: object_of(JOINT_FIELDS, convert=_joint)}
COLLISIONS = (_PAIR_COLLISION, _WALL_COLLISION, _JOINT_COLLISION)
"""The fields of a collision: one of these."""
_BOX_FIELDS: Fields = {keys.BOX: _BOX}
FACE_FIELDS: Fields = {keys.BOX: _BOX, keys.AXIS: integer(0, 2)}
"""The fields of a claim about a face besides its collision; about a box they lack the axis."""

DOMAIN_FIELDS: Fields = {
    keys.LOW: tuple_of(_dyadic(-(2**200)), _dyadic(-(2**200))),
    keys.SIZE: tuple_of(_dyadic(1), _dyadic(1)),
}
SEPARATION_FIELDS: Fields = {
    keys.VERDICT: word(keys.NO_PATH),
    keys.CLAIM: word(keys.SEPARATION_CLAIM),
    keys.DOMAIN: object_of(DOMAIN_FIELDS),
    keys.START_SIDE: list_of(_BOX),
    keys.FULL: list_of(
        object_of(*({**_BOX_FIELDS, **each} for each in COLLISIONS), convert=_full_claim)
    ),
    keys.FULL_FACES: list_of(
        object_of(*({**FACE_FIELDS, **each} for each in COLLISIONS), convert=_full_claim)
    ),
}
DISC_FIELDS: Fields = {
    **SEPARATION_FIELDS,
    keys.CLAIM: word(keys.DISC_CLAIM),
    keys.DISC: list_of(_POINT),
    keys.INSIDE: tuple_of(_INDEX, _INDEX),
}
LINKS: tuple[Fields, ...] = (_PAIR_COLLISION, {keys.SIDE: _WALL})
"""The fields of a link of a chain: one of these."""
CHAIN_FIELDS: Fields = {
    keys.VERDICT: word(keys.NO_PATH),
    keys.CLAIM: word(keys.CHAIN_CLAIM),
    keys.CHAIN: list_of(object_of(*LINKS, convert=_chain_link)),
}
END_FIELDS: Fields = {
    keys.VERDICT: word(keys.NO_PATH),
    keys.CLAIM: word(keys.END_CLAIM),
    keys.END: word(keys.START, keys.GOAL),
}
BOUNDS_FIELDS: Fields = {keys.REFERENCE_BOUNDS: _TRUE}
"""What an end has in place of a collision if it is out of the reference bounds."""

INTERVAL_FIELDS: Fields = {
    keys.FROM: _PART,
    keys.TO: _PART,
    keys.APART: list_of(
        tuple_of(_INDEX, _INDEX, _INDEX, _INDEX, _OWNER, _INDEX, convert=_separator)
    ),
}
ALONG_FIELDS: Fields = {
    keys.ALONG: list_of(
        tuple_of(
            _INDEX, _INDEX, _INDEX, _INDEX, word(keys.LEFT, keys.RIGHT), convert=_separating_line
        )
    ),
}
"""What an interval of an exact path may have besides."""
PATH_FIELDS: Fields = {
    keys.VERDICT: word(keys.PATH),
    keys.CONTACT_TOLERANCE: _FINITE,
    keys.WAYPOINTS: list_of(tuple_of(_LENGTH, _LENGTH, _ANGLE, _TURNS, convert=_waypoint)),
    keys.SEGMENTS: list_of(
        list_of(object_of(INTERVAL_FIELDS, {**INTERVAL_FIELDS, **ALONG_FIELDS}, convert=_interval))
    ),
}

COMMON_FIELDS: Fields = {
    keys.FORMAT: word(keys.FORMAT_NAME),
    keys.VERSION: integer(keys.FORMAT_VERSION, keys.FORMAT_VERSION),
    keys.MADE_BY: _TEXT,
    keys.SCENE: _TEXT,
    keys.ROBOT_PIECES: _PIECES,
    keys.OBSTACLE_PIECES: _PIECES,
}
OUTSIDE_FIELDS: Fields = {keys.OUTSIDE: tuple_of(_LENGTH, _LENGTH, _LENGTH, _LENGTH)}
"""What a certificate has besides if the workspace is a polygon."""
DECIMAL_FIELDS: Fields = {keys.DECIMAL_PLACES: integer(1, MOST_PLACES)}
"""What a certificate has besides if it takes the scene's lengths as decimals."""
REFERENCE_FIELDS: Fields = {keys.REFERENCE: _POINT}
"""What a separation has besides if it is about another point of the robot than the origin."""

_ENDS = (_PAIR_COLLISION, _WALL_COLLISION, BOUNDS_FIELDS)
_ABSENCES = (SEPARATION_FIELDS, DISC_FIELDS)
_PROOFS = (
    PATH_FIELDS,
    *_ABSENCES,
    CHAIN_FIELDS,
    *({**absence, **REFERENCE_FIELDS} for absence in _ABSENCES),
    *({**END_FIELDS, **e} for e in _ENDS),
)
_CERTIFICATE = object_of(
    *(
        {**COMMON_FIELDS, **proof, **outside, **decimals}
        for proof in _PROOFS
        for outside in ({}, OUTSIDE_FIELDS)
        for decimals in ({}, DECIMAL_FIELDS)
    ),
    convert=_certificate,
)
