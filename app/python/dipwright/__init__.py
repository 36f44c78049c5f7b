"""Dipwright in Python: plan the hydrographic (water transfer) printing of parts.

    import dipwright, numpy

    job = dipwright.open("turtle.dipw")
    result = job.run()
    film = result.immersions[0].film
    numpy.asarray(film.positions)
    result.immersions[0].verdict

The module computes what dipwright-cli computes, with the same code. Lengths are in mm, angles in
degrees. Arrays share the memory of the results and are read-only. docs/python.md is the guide.
"""
import sys

try:
    from ._dipwright import *
    from ._dipwright import __version__
except ModuleNotFoundError as error:
    if error.name != "dipwright._dipwright":
        raise
    raise ImportError("This dipwright was built for another version of Python than "
                      f"{sys.version_info.major}.{sys.version_info.minor}; start the Python for which "
                      "it was built") from None

__all__ = [
    "Body", "Cancelled", "Certainty", "Error", "Field", "Film", "ImmersionResult", "Job", "Output",
    "PlaceToCheck", "Poses", "Reason", "Result", "Search", "Share", "Sheet", "Solver", "Tolerances",
    "Verdict", "new", "open", "samples", "solvers",
]
