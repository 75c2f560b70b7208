"""What is to be said of a lattice that is laid on the faces: pieces, seams, and what is not covered.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import DimpleState

ENOUGH = 0.9  # of the faces' area


def coverage(placed):
    """What the milled dimples are worth, each a cell of the lattice, over the faces' area; None if the
    lattice is not laid on the faces."""
    if placed.laid is None or not placed.laid.area:
        return None
    milled = int((placed.dimples.states == DimpleState.CUT).sum())
    return milled * placed.division.pattern.cell_area / placed.laid.area


def remarks(placed):
    """Sentences."""
    if placed.laid is None:
        return []
    said, counts = [], placed.dimples.counts()
    for count, distance in placed.laid.rounds:
        said.append("%d dimples go round the closed face, %.5g mm apart." % (count, distance))
    if placed.laid.pieces > 1:
        said.append("The lattice is laid in %d pieces." % placed.laid.pieces)
    if counts["crowded"]:
        said.append(
            "%d lattice points are left out for others that are too near, where pieces or the two sides of "
            "a closed face meet." % counts["crowded"]
        )
    share = coverage(placed)
    if share is not None and share < ENOUGH:
        reasons = ", ".join(
            "%s: %d" % (name, n)
            for name, n in counts.items()
            if n and name not in ("cut", "off the face")
        )
        said.append(
            "Dimples cover %.0f %% of the faces; left out on them: %s."
            % (100.0 * share, reasons or "nothing but strips along borders, narrower than a spacing")
        )
    return said
