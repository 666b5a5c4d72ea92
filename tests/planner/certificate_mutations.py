"""Ways to tamper with a certificate, or with the scene under it; none of them may pass.

A mutation takes copies of a scene and a valid certificate that it may change, and returns both,
or None where it does not apply. "Signed" mutants carry the hash of the changed scene, so that it is
the geometry that must give them away.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable
from typing import Any

from hand_made_certificates import signed

Json = dict[str, Any]
Mutant = tuple[Json, Json] | None
Mutation = Callable[[Json, Json], Mutant]

MUTATIONS: dict[str, Mutation] = {}


def mutation(mutate: Mutation) -> Mutation:
    MUTATIONS[mutate.__name__] = mutate
    return mutate


def mutant(name: str, scene: Json, certificate: Json) -> Mutant:
    """Return scene and certificate changed by the mutation of that name."""
    return MUTATIONS[name](copy.deepcopy(scene), copy.deepcopy(certificate))


def _rings(scene: Json) -> list[Any]:
    """Return the outer rings of the obstacles; scenes here have only polygons of them."""
    shapes = [shape for shape in scene["obstacles"] if shape["type"] == "Polygon"]
    return [shape["coordinates"][0] for shape in shapes]


def _listed(certificate: Json) -> list[Any]:
    """Return the lists of pieces of all polygons."""
    return [*certificate["robot_pieces"].values(), *certificate["obstacle_pieces"].values()]


def _claims(certificate: Json) -> list[Json]:
    return [*certificate.get("full", []), *certificate.get("full_faces", [])]


def _apart(certificate: Json) -> list[Any]:
    segments = certificate.get("segments", [])
    return [each for intervals in segments for interval in intervals for each in interval["apart"]]


def _joints(certificate: Json) -> list[Json]:
    return [claim["joint"] for claim in _claims(certificate) if "joint" in claim]


def _sums(certificate: Json) -> list[Any]:
    return [terms for joint in _joints(certificate) for terms in joint["sums"]]


def _terms(certificate: Json) -> list[Any]:
    return [term for terms in _sums(certificate) for term in terms]


def _is_path(certificate: Json) -> bool:
    return certificate["verdict"] == "path"


def _separates(certificate: Json) -> bool:
    return certificate.get("claim") in ("separation", "disc")


# --- Any certificate


@mutation
def scene_changed_by_an_ulp(scene: Json, certificate: Json) -> Mutant:
    """The certificate is of another scene; nothing but the hash can tell."""
    robot = scene["robot"]["coordinates"]
    ring = robot[0] if scene["robot"]["type"] == "Polygon" else robot[0][0]
    vertex = next(vertex for vertex in ring if vertex[0] != 0)
    vertex[0] = math.nextafter(vertex[0], math.inf)
    return scene, certificate


@mutation
def goal_changed_by_an_ulp(scene: Json, certificate: Json) -> Mutant:
    scene["goal"][0] = math.nextafter(scene["goal"][0], math.inf)
    return scene, certificate


@mutation
def hash_changed(scene: Json, certificate: Json) -> Mutant:
    certificate["scene"] = certificate["scene"][::-1]
    return scene, certificate


@mutation
def verdict_swapped(scene: Json, certificate: Json) -> Mutant:
    certificate["verdict"] = "no_path" if _is_path(certificate) else "path"
    return scene, certificate


@mutation
def version_changed(scene: Json, certificate: Json) -> Mutant:
    certificate["version"] = 2
    return scene, certificate


@mutation
def piece_missing(scene: Json, certificate: Json) -> Mutant:
    if not any(_listed(certificate)):
        return None
    max(_listed(certificate), key=len).pop()
    return scene, certificate


@mutation
def piece_duplicated(scene: Json, certificate: Json) -> Mutant:
    if not any(_listed(certificate)):
        return None
    pieces = _listed(certificate)[0]
    pieces.append(pieces[0])
    return scene, certificate


@mutation
def piece_shrunk(scene: Json, certificate: Json) -> Mutant:
    """A vertex goes inwards: the piece is still convex, but no longer part of a partition."""
    if not any(_listed(certificate)):
        return None
    piece = _listed(certificate)[0][0]
    (ax, ay), (bx, by), (cx, cy) = piece[0], piece[1], piece[2]
    piece[1] = [(ax + 14 * bx + cx) / 16, (ay + 14 * by + cy) / 16]
    return scene, certificate


@mutation
def piece_outside_its_polygon(scene: Json, certificate: Json) -> Mutant:
    if not any(_listed(certificate)):
        return None
    for piece in _listed(certificate)[0]:
        for vertex in piece:
            vertex[0] += 0.125
    return scene, certificate


@mutation
def piece_clockwise(scene: Json, certificate: Json) -> Mutant:
    if not any(_listed(certificate)):
        return None
    _listed(certificate)[0][0].reverse()
    return scene, certificate


@mutation
def pieces_not_convex(scene: Json, certificate: Json) -> Mutant:
    """An obstacle that nothing refers to is listed as one piece, though it is not convex."""
    for number, ring in enumerate(_rings(scene)):
        if str(number) not in certificate["obstacle_pieces"] and len(ring) == 6:
            certificate["obstacle_pieces"][str(number)] = [ring]
            return scene, certificate
    return None


@mutation
def pieces_of_no_polygon(scene: Json, certificate: Json) -> Mutant:
    if not any(_listed(certificate)):
        return None
    certificate["obstacle_pieces"]["99999"] = _listed(certificate)[0]
    return scene, certificate


@mutation
def pieces_not_listed(scene: Json, certificate: Json) -> Mutant:
    if not (_claims(certificate) or _apart(certificate)):
        return None
    certificate["robot_pieces"] = certificate["obstacle_pieces"] = {}
    return scene, certificate


@mutation
def outside_too_small(scene: Json, certificate: Json) -> Mutant:
    """What is outside the workspace shrinks to a far rectangle, and the path leads through it."""
    if "outside" not in certificate or not _is_path(certificate):
        return None
    certificate |= {"outside": [-5, -5, -4, -4]}
    if certificate["made_by"] == "hand":
        certificate["obstacle_pieces"] = {}
        certificate["waypoints"][1] = [8, 3, 0, 0]
    return scene, certificate


# --- Paths


@mutation
def waypoint_through_an_obstacle(scene: Json, certificate: Json) -> Mutant:
    if not _is_path(certificate) or len(certificate["waypoints"]) < 3 or not _rings(scene):
        return None
    number = next(iter(certificate["obstacle_pieces"]), None)
    if number is None:
        return None
    piece = certificate["obstacle_pieces"][number][0]
    middle = [sum(v[k] for v in piece) / len(piece) for k in (0, 1)]
    certificate["waypoints"][len(certificate["waypoints"]) // 2][:2] = middle
    return scene, certificate


@mutation
def waypoint_beyond_a_wall(scene: Json, certificate: Json) -> Mutant:
    if not _is_path(certificate) or len(certificate["waypoints"]) < 3:
        return None
    certificate["waypoints"][1][1] += 1e4
    return scene, certificate


@mutation
def waypoint_just_beyond_a_wall(scene: Json, certificate: Json) -> Mutant:
    """Over the block, higher than the ceiling allows; nothing else is in the way there."""
    if not _is_path(certificate) or scene.get("workspace") != {"box": [0, 0, 10, 4]}:
        return None
    if certificate["waypoints"][1][:2] != [5, 3]:
        return None
    certificate["waypoints"][1][1] = 3.875
    return scene, certificate


@mutation
def start_moved(scene: Json, certificate: Json) -> Mutant:
    if not _is_path(certificate):
        return None
    certificate["waypoints"][0][0] += 2.0**-20
    return scene, certificate


@mutation
def goal_moved(scene: Json, certificate: Json) -> Mutant:
    if not _is_path(certificate):
        return None
    certificate["waypoints"][-1][1] -= 2.0**-20
    return scene, certificate


@mutation
def goal_turned(scene: Json, certificate: Json) -> Mutant:
    """Signed: the scene's goal has another theta."""
    if not _is_path(certificate) or scene.get("rotation") is False:
        return None
    scene["goal"][2] += 2.0**-20
    return scene, signed(scene, certificate)


@mutation
def start_a_turn_on(scene: Json, certificate: Json) -> Mutant:
    """The whole path is a turn on: the same motion, in another form than stated."""
    if not _is_path(certificate):
        return None
    for waypoint in certificate["waypoints"]:
        waypoint[3] += 1
    return scene, certificate


@mutation
def turns_changed_at_the_goal(scene: Json, certificate: Json) -> Mutant:
    if not _is_path(certificate) or not certificate["segments"][-1][-1]["apart"]:
        return None
    certificate["waypoints"][-1][3] += 1
    return scene, certificate


@mutation
def turns_changed_on_the_way(scene: Json, certificate: Json) -> Mutant:
    if not _is_path(certificate) or len(certificate["waypoints"]) < 3:
        return None
    certificate["waypoints"][len(certificate["waypoints"]) // 2][3] -= 1
    return scene, certificate


@mutation
def turned_on_the_way(scene: Json, certificate: Json) -> Mutant:
    """A robot that may not turn does, in free space."""
    if not _is_path(certificate) or scene.get("rotation") is not False:
        return None
    certificate["waypoints"].insert(0, certificate["waypoints"][0])
    certificate["waypoints"].insert(1, [*certificate["waypoints"][0][:2], 0.25, 0])
    idle = [{"from": 0.0, "to": 1.0, "apart": []}]
    certificate["segments"] = [idle, idle, *certificate["segments"]]
    return scene, certificate


@mutation
def tolerance_invented(scene: Json, certificate: Json) -> Mutant:
    if not _is_path(certificate):
        return None
    certificate["contact_tolerance"] = 2.0**-10
    certificate["waypoints"][0][0] += 2.0**-30
    return scene, certificate


@mutation
def tolerance_negative(scene: Json, certificate: Json) -> Mutant:
    if not _is_path(certificate):
        return None
    certificate["contact_tolerance"] = -1.0
    return scene, certificate


@mutation
def bounds_tighter(scene: Json, certificate: Json) -> Mutant:
    """Signed: the path leaves the bounds of the reference point on its way."""
    if not _is_path(certificate) or "reference_bounds" not in scene:
        return None
    waypoints = certificate["waypoints"]
    scene["reference_bounds"][3] = max(w[1] for w in waypoints) - 2.0**-20
    return scene, signed(scene, certificate)


@mutation
def waypoint_dropped(scene: Json, certificate: Json) -> Mutant:
    """A corner is cut."""
    if not _is_path(certificate) or len(certificate["waypoints"]) < 4:
        return None
    if not certificate["segments"][0][-1]["apart"]:
        return None
    certificate["waypoints"].pop(1)
    certificate["segments"].pop(1)
    return scene, certificate


@mutation
def segment_dropped(scene: Json, certificate: Json) -> Mutant:
    if not _is_path(certificate):
        return None
    certificate["segments"].pop()
    return scene, certificate


@mutation
def interval_dropped(scene: Json, certificate: Json) -> Mutant:
    if not _is_path(certificate):
        return None
    max(certificate["segments"], key=len).pop()
    return scene, certificate


@mutation
def interval_gap(scene: Json, certificate: Json) -> Mutant:
    intervals = max(certificate.get("segments", [[]]), key=len)
    if len(intervals) < 2:
        return None
    intervals[1]["from"] = math.nextafter(intervals[1]["from"], 1)
    return scene, certificate


@mutation
def interval_overlap(scene: Json, certificate: Json) -> Mutant:
    intervals = max(certificate.get("segments", [[]]), key=len)
    if len(intervals) < 2:
        return None
    intervals[1]["from"] = math.nextafter(intervals[1]["from"], 0)
    return scene, certificate


@mutation
def intervals_short_of_the_end(scene: Json, certificate: Json) -> Mutant:
    if not _is_path(certificate):
        return None
    certificate["segments"][-1][-1]["to"] = math.nextafter(1, 0)
    return scene, certificate


@mutation
def intervals_late(scene: Json, certificate: Json) -> Mutant:
    if not _is_path(certificate):
        return None
    certificate["segments"][0][0]["from"] = 2.0**-60
    return scene, certificate


@mutation
def edge_dropped(scene: Json, certificate: Json) -> Mutant:
    """An interval lists one edge fewer."""
    for intervals in certificate.get("segments", []):
        for interval in intervals:
            if interval["apart"]:
                interval["apart"].pop(0)
                return scene, certificate
    return None


@mutation
def edges_all_dropped(scene: Json, certificate: Json) -> Mutant:
    """No interval lists an edge, nor the certificate an obstacle."""
    if not _apart(certificate):
        return None
    certificate["obstacle_pieces"] = {}
    for intervals in certificate["segments"]:
        for interval in intervals:
            interval["apart"] = []
    return scene, certificate


@mutation
def edge_of_the_other_side(scene: Json, certificate: Json) -> Mutant:
    for claim in _apart(certificate):
        p, i, q, j, owner, edge = claim
        table, number, piece = ("robot", p, i) if owner == "robot" else ("obstacle", q, j)
        count = len(certificate[f"{table}_pieces"][str(number)][piece])
        claim[5] = (edge + count // 2) % count
    return (scene, certificate) if _apart(certificate) else None


@mutation
def edge_that_is_none(scene: Json, certificate: Json) -> Mutant:
    for claim in _apart(certificate):
        claim[5] = 1000
    return (scene, certificate) if _apart(certificate) else None


@mutation
def obstacle_in_the_way(scene: Json, certificate: Json) -> Mutant:
    """Signed: another obstacle stands on the path."""
    if not _is_path(certificate):
        return None
    x, y = certificate["waypoints"][1][:2]
    ring = [[x - 0.01, y - 0.01], [x + 0.01, y - 0.01], [x, y + 0.01]]
    scene["obstacles"].append({"type": "Polygon", "coordinates": [ring]})
    return scene, signed(scene, certificate)


# --- Separations


@mutation
def start_cell_removed(scene: Json, certificate: Json) -> Mutant:
    if not _separates(certificate):
        return None
    certificate["start_side"] = certificate["start_side"][:1]
    certificate["start_side"][0] = [[60, 0], [60, 0], certificate["start_side"][0][2]]
    return scene, certificate


@mutation
def cell_removed(scene: Json, certificate: Json) -> Mutant:
    if not _separates(certificate) or len(certificate["start_side"]) < 2:
        return None
    certificate["start_side"].pop(len(certificate["start_side"]) // 2)
    return scene, certificate


@mutation
def cells_all_removed(scene: Json, certificate: Json) -> Mutant:
    if not _separates(certificate):
        return None
    certificate["start_side"] = []
    return scene, certificate


@mutation
def seam_cell_removed(scene: Json, certificate: Json) -> Mutant:
    """A cell that ends at turn 1 is removed, and with it all whose only neighbour it was."""
    if not _separates(certificate):
        return None
    for i, (_, _, (level, k)) in enumerate(certificate["start_side"]):
        if level > 0 and k + 1 == 1 << level:
            certificate["start_side"].pop(i)
            return scene, certificate
    return None


@mutation
def cell_shrunk(scene: Json, certificate: Json) -> Mutant:
    if not _separates(certificate):
        return None
    span = certificate["start_side"][0][0]
    span[:] = [span[0] + 1, 2 * span[1]]
    return scene, certificate


@mutation
def cell_grown(scene: Json, certificate: Json) -> Mutant:
    """All of the domain is the start's side."""
    if not _separates(certificate):
        return None
    certificate["start_side"].append([[0, 0], [0, 0], [0, 0]])
    return scene, certificate


@mutation
def cell_shifted(scene: Json, certificate: Json) -> Mutant:
    if not _separates(certificate):
        return None
    span = certificate["start_side"][-1][0]
    span[1] += 1
    return scene, certificate


@mutation
def cell_beyond_the_domain(scene: Json, certificate: Json) -> Mutant:
    """A true claim about a box that is none of the domain's."""
    if not _separates(certificate) or "workspace" not in scene:
        return None
    certificate["full"].append({"box": [[2, 5], [0, 0], [0, 0]], "wall": "x_max"})
    return scene, certificate


@mutation
def cell_with_angles(scene: Json, certificate: Json) -> Mutant:
    """A claim about half a turn where there is only one angle."""
    turning = scene.get("rotation") is not False and certificate.get("claim") != "disc"
    if not _separates(certificate) or turning or not _claims(certificate):
        return None
    claim = copy.deepcopy(_claims(certificate)[0])
    claim["box"][2] = [1, 0]
    certificate["full_faces" if "axis" in claim else "full"].append(claim)
    return scene, certificate


@mutation
def full_cell_dropped(scene: Json, certificate: Json) -> Mutant:
    if not certificate.get("full"):
        return None
    certificate["full"].pop(0)
    return scene, certificate


@mutation
def full_cells_all_dropped(scene: Json, certificate: Json) -> Mutant:
    if not certificate.get("full"):
        return None
    certificate["full"] = []
    return scene, certificate


@mutation
def face_dropped(scene: Json, certificate: Json) -> Mutant:
    if not certificate.get("full_faces"):
        return None
    certificate["full_faces"].pop(0)
    return scene, certificate


@mutation
def face_of_another_axis(scene: Json, certificate: Json) -> Mutant:
    if not certificate.get("full_faces"):
        return None
    certificate["full_faces"][0]["axis"] = 1 - min(certificate["full_faces"][0]["axis"], 1)
    return scene, certificate


@mutation
def full_cell_shifted(scene: Json, certificate: Json) -> Mutant:
    if not certificate.get("full"):
        return None
    certificate["full"][0]["box"][0][1] ^= 1
    return scene, certificate


@mutation
def full_cell_grown(scene: Json, certificate: Json) -> Mutant:
    """FULL is said of all translations."""
    if not certificate.get("full"):
        return None
    certificate["full"][0]["box"][:2] = [[0, 0], [0, 0]]
    return scene, certificate


@mutation
def witness_is_a_wall(scene: Json, certificate: Json) -> Mutant:
    """Every claim by a pair is made by a wall."""
    pairs = [claim for claim in _claims(certificate) if "pair" in claim]
    if not pairs or "workspace" not in scene:
        return None
    for claim in pairs:
        del claim["pair"]
        claim["wall"] = "x_min"
    return scene, certificate


@mutation
def wall_is_another(scene: Json, certificate: Json) -> Mutant:
    other = {"x_min": "x_max", "x_max": "x_min", "y_min": "y_max", "y_max": "y_min"}
    walls = [claim for claim in _claims(certificate) if "wall" in claim]
    for claim in walls:
        claim["wall"] = other[claim["wall"]]
    return (scene, certificate) if walls else None


@mutation
def witnesses_exchanged(scene: Json, certificate: Json) -> Mutant:
    """The witness of another claim."""
    pairs = [claim["pair"] for claim in _claims(certificate) if "pair" in claim]
    pieces = [claim for claim in _claims(certificate) if "pair" in claim]
    if len({tuple(pair) for pair in pairs}) < 2:
        return None
    for claim, pair in zip(pieces, pairs[::-1], strict=True):
        claim["pair"] = pair
    return scene, certificate


@mutation
def witness_of_no_piece(scene: Json, certificate: Json) -> Mutant:
    pieces = [claim for claim in _claims(certificate) if "pair" in claim]
    for claim in pieces:
        claim["pair"][3] += 1000
    return (scene, certificate) if pieces else None


def _resize(certificate: Json, low: int, size: int) -> None:
    """Move the domain by `low` / 32 of its size and change that by `size` / 32; so its boxes."""
    for name, parts in (("low", low), ("size", size)):
        for k in (0, 1):
            m, e = certificate["domain"][name][k]
            length, exponent = certificate["domain"]["size"][k]
            moved = (m << (e + 120)) + parts * (length << (exponent + 115))
            certificate["domain"][name][k] = [moved, -120]


@mutation
def domain_shrunk(scene: Json, certificate: Json) -> Mutant:
    """Its sides are no longer beyond the workspace; all claims hold as before."""
    if not _separates(certificate) or certificate["made_by"] != "hand":
        return None
    _resize(certificate, 1, -2)
    return scene, certificate


@mutation
def domain_halved(scene: Json, certificate: Json) -> Mutant:
    if not _separates(certificate):
        return None
    _resize(certificate, 8, -16)
    return scene, certificate


@mutation
def domain_shifted(scene: Json, certificate: Json) -> Mutant:
    if not _separates(certificate):
        return None
    _resize(certificate, 12, 0)
    return scene, certificate


@mutation
def domain_turned_inside_out(scene: Json, certificate: Json) -> Mutant:
    if not _separates(certificate):
        return None
    _resize(certificate, 32, -64)
    return scene, certificate


@mutation
def goal_in_the_start_side(scene: Json, certificate: Json) -> Mutant:
    """Signed: the goal is the start."""
    if not _separates(certificate):
        return None
    scene["goal"] = scene["start"]
    return scene, signed(scene, certificate)


@mutation
def start_outside_its_side(scene: Json, certificate: Json) -> Mutant:
    """Signed: the start is the goal."""
    if not _separates(certificate):
        return None
    scene["start"] = scene["goal"]
    return scene, signed(scene, certificate)


@mutation
def joint_term_dropped(scene: Json, certificate: Json) -> Mutant:
    for terms in _sums(certificate):
        terms.pop()
    return (scene, certificate) if _joints(certificate) else None


@mutation
def joint_terms_all_dropped(scene: Json, certificate: Json) -> Mutant:
    for terms in _sums(certificate):
        terms.clear()
    return (scene, certificate) if _joints(certificate) else None


@mutation
def sums_dropped(scene: Json, certificate: Json) -> Mutant:
    for joint in _joints(certificate):
        joint["sums"] = []
    return (scene, certificate) if _joints(certificate) else None


@mutation
def one_more_edge_may_separate(scene: Json, certificate: Json) -> Mutant:
    """A pair gets a further edge to choose, which no sum refutes."""
    for joint in _joints(certificate):
        for entry in joint["axes"]:
            edges = [list(edge) for edge in entry["edges"]]
            more = next(i for i in range(3) if ["obstacle", i] not in edges)
            entry["edges"].append(["obstacle", more])
            return scene, certificate
    return None


@mutation
def edge_that_may_separate_denied(scene: Json, certificate: Json) -> Mutant:
    for joint in _joints(certificate):
        for entry in joint["axes"]:
            entry["edges"] = entry["edges"][1:]
    return (scene, certificate) if any(j["axes"] for j in _joints(certificate)) else None


@mutation
def pair_of_a_joint_claim_unlisted(scene: Json, certificate: Json) -> Mutant:
    changed = [joint for joint in _joints(certificate) if joint["axes"]]
    for joint in changed:
        joint["axes"] = []
    return (scene, certificate) if changed else None


@mutation
def too_many_choices(scene: Json, certificate: Json) -> Mutant:
    """The one edge that may separate is listed very often, each refuted: true, but endless."""
    for joint in _joints(certificate):
        for entry in joint["axes"]:
            entry["edges"] = entry["edges"] * 2000
            return scene, certificate
    return None


@mutation
def weight_changed(scene: Json, certificate: Json) -> Mutant:
    for terms in _sums(certificate):
        terms[0]["weight"] *= 64
        terms[-1]["weight"] /= 64
    return (scene, certificate) if _terms(certificate) else None


@mutation
def weight_negative(scene: Json, certificate: Json) -> Mutant:
    """A wall's term that is large enough to make any sum negative, if weights may be."""
    for terms in _sums(certificate):
        for term in terms:
            if "wall" in term:
                other = {"x_min": "x_max", "x_max": "x_min", "y_min": "y_max", "y_max": "y_min"}
                false = {**term, "wall": other[term["wall"]], "weight": -64.0}
                terms.append(false)
                return scene, certificate
    return None


@mutation
def term_of_another_edge(scene: Json, certificate: Json) -> Mutant:
    """A pair has terms of two edges, the second one without weight."""
    for terms in _sums(certificate):
        for term in terms:
            if "pair" in term:
                terms.append({**term, "edge": (term["edge"] + 1) % 3, "weight": 0.0})
                return scene, certificate
    return None


@mutation
def edge_of_a_term_changed(scene: Json, certificate: Json) -> Mutant:
    terms = [term for term in _terms(certificate) if "pair" in term]
    for term in terms:
        term["edge"] = (term["edge"] + 1) % 3
    return (scene, certificate) if terms else None


@mutation
def vertex_of_a_term_changed(scene: Json, certificate: Json) -> Mutant:
    terms = [term for term in _terms(certificate) if "pair" in term]
    for term in terms:
        term["vertex"] += 1000
    return (scene, certificate) if terms else None


@mutation
def vertex_not_of_the_robot(scene: Json, certificate: Json) -> Mutant:
    """A wall's term is of a point far outside the robot, which is beyond the wall indeed."""
    for term in _terms(certificate):
        if "wall" in term:
            reach = -1000 if term["wall"].endswith("min") else 1000
            term["vertex"] = [reach, reach]
            return scene, certificate
    return None


@mutation
def robot_smaller(scene: Json, certificate: Json) -> Mutant:
    """Signed, and the pieces are legitimate: the robot is a thousandth of its size."""
    if not _separates(certificate) or scene["robot"]["type"] != "Polygon":
        return None
    if certificate["made_by"] == "hand" and not _terms(certificate):
        return None  # there is no way for any robot

    def scaled(points: list[Any]) -> list[Any]:
        return [[x * 2.0**-10, y * 2.0**-10] for x, y in points]

    scene["robot"]["coordinates"] = [scaled(ring) for ring in scene["robot"]["coordinates"]]
    pieces = certificate["robot_pieces"]
    certificate["robot_pieces"] = {p: [scaled(v) for v in each] for p, each in pieces.items()}
    if "disc" in certificate:
        certificate["disc"] = scaled(certificate["disc"])
    return scene, signed(scene, certificate)


@mutation
def obstacles_elsewhere(scene: Json, certificate: Json) -> Mutant:
    """Signed, and the pieces are legitimate: the obstacles are far away."""
    if not _claims(certificate) or "outside" in certificate:
        return None
    for ring in _rings(scene):
        ring[:] = [[x + 1024, y] for x, y in ring]
    for pieces in certificate["obstacle_pieces"].values():
        for piece in pieces:
            piece[:] = [[x + 1024, y] for x, y in piece]
    return scene, signed(scene, certificate)


# --- Discs and ends


@mutation
def disc_too_large(scene: Json, certificate: Json) -> Mutant:
    if "disc" not in certificate:
        return None
    certificate["disc"] = [[x * 1.5, y * 1.5] for x, y in certificate["disc"]]
    return scene, certificate


@mutation
def disc_off_centre(scene: Json, certificate: Json) -> Mutant:
    if "disc" not in certificate:
        return None
    reach = max(x for x, _ in certificate["disc"])
    certificate["disc"] = [[x + reach, y] for x, y in certificate["disc"]]
    return scene, certificate


@mutation
def disc_star_shaped(scene: Json, certificate: Json) -> Mutant:
    """A star polygon turns left at every vertex."""
    if "disc" not in certificate:
        return None
    disc = certificate["disc"]
    certificate["disc"] = [disc[3 * k % len(disc)] for k in range(len(disc))]
    return scene, certificate


@mutation
def disc_empty(scene: Json, certificate: Json) -> Mutant:
    if "disc" not in certificate:
        return None
    certificate["disc"] = []
    return scene, certificate


@mutation
def disc_inside_nothing(scene: Json, certificate: Json) -> Mutant:
    if "disc" not in certificate:
        return None
    certificate["inside"] = [0, 1000]
    return scene, certificate


@mutation
def end_exchanged(scene: Json, certificate: Json) -> Mutant:
    if "end" not in certificate:
        return None
    certificate["end"] = "goal" if certificate["end"] == "start" else "start"
    return scene, certificate


@mutation
def end_is_free(scene: Json, certificate: Json) -> Mutant:
    """Signed: the end is moved to where it is free, and within its bounds."""
    if "end" not in certificate:
        return None
    scene[certificate["end"]] = [5, 2, 0]
    return scene, signed(scene, certificate)
