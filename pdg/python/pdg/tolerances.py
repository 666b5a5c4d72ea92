"""Every numeric constant of the Python side, with unit and derivation.

Those of the core stand in ``pdg/native/tolerances.hpp``, and docs/rounding.md derives them.
u = 2**-53 is the unit roundoff. Constants that scale anything are powers of two or small integers,
so that scaling rounds nothing.
"""

from __future__ import annotations

# The magnitudes that a convex set's coordinates may have (any unit) unless they are 0. Products of
# four such numbers and sums of them stay within 2**±1022: nothing overflows, and what underflows is
# below u² of anything it is added to.
MIN_SET_COORDINATE = 2.0**-200
MAX_SET_COORDINATE = 2.0**200

# The most components that a convex set's vectors may have: kSumPadding of the core is derived for
# sums of that many.
MOST_DIMENSIONS = 2**20
# Limits of nodes, iterations and facets beyond this number are replaced by it; it is never reached.
MOST_COUNTED = 2**62

# The magnitudes that the numbers of a grasp (lengths, forces, coefficients) may have unless they
# are 0. A wrench's component is a product of at most three of them and a unit vector's, and thus
# within the coordinates above.
MIN_GRASP_MAGNITUDE = 2.0**-66
MAX_GRASP_MAGNITUDE = 2.0**66

# The sine of the least angle between a normal and a direction that is projected into the contact
# plane. The projection errs by a few u and is as long as the sine: √u leaves it half of a double's
# digits.
LEAST_TANGENT_SINE = 2.0**-26

# Singular values below this part of the largest that there could be count as zero, and so does a Δ
# this close to 0. Jacobians carry some ten roundings a joint, 2**-46 at most for ten joints; poses
# from inverse kinematics are good to some 2**-40. A larger value would take joints that move a tip
# by 10⁻⁹ of their reach for locked; a smaller one would let rounding raise the dimension.
RANK_TOLERANCE = 2.0**-30

# The relative width of the bracket at which force closure is decided: the lower end of a bracket
# narrower than its upper end is positive. Any value below 1 will do; this one leaves a tenth.
CLOSURE_TOLERANCE = 0.9

# What a caller's own convex set promises unless another accuracy is given: answers are right to
# this part of the set's extent. Twice 2**12 u: sums of some thousand rounded terms keep it. Bounds
# are no narrower than that; a smaller value is a promise that fewer sets keep.
SUPPORT_ACCURACY = 2.0**-40
# How often that enters u·s(u) - h(u), by which the promise is checked: in the point, in the value,
# and in the product here, whose own rounding is far less than the third.
ACCURACY_SHARES = 3

# The ratio of the greatest to the least width up to which a set is left as it is: rounding then
# costs the bounds two digits at most.
ROUND_ENOUGH = 64.0
# The same where only scaling by powers of two is considered, which may leave a factor of two a
# side.
ROUND_ENOUGH_ALONG_AXES = ROUND_ENOUGH / 4
# A set is flat along u if its width is at most this many times the error of one support value: a
# width has two of these, and four times as much is allowed, since u itself is rounded.
FLATNESS_UNITS = 8.0
# Each round makes a set rounder, or finds that it is flat; two or three rounds do.
MOST_ROUNDS = 8

# The defaults of a search for d_Q(A): its absolute tolerance, which is that of [GFE] Table I, and
# limits that searches in up to six dimensions do not reach; the facets take some 1 GB.
ABSOLUTE_TOLERANCE = 1e-4
MAX_ITERATIONS = 100_000
MAX_FACETS = 5_000_000
