# %% [markdown]
# # How exact must swell and tilt be?
#
# A sheet is printed for a film that swells by 2 % and a part that hangs straight. How far does the
# picture land from its place if the film swells by more or less, or the part hangs askew? Each `# %%`
# begins a cell; Jupyter (with jupytext), Spyder and VS Code run the file cell by cell. As a program:
#
#     python3 tolerance_study.py JOB.dipw [PICTURE.png]

# %%
import sys

import dipwright
import matplotlib
import numpy

if __name__ == "__main__":
    matplotlib.use("Agg")  # draw into a file; leave this out in a notebook
from matplotlib import pyplot

PROJECT = sys.argv[1] if len(sys.argv) > 1 else "turtle.dipw"
PICTURE = sys.argv[2] if len(sys.argv) > 2 else "tolerance_study.png"
SWELLS = (1.00, 1.01, 1.02, 1.03, 1.04)
TILTS = (-2, -1, 0, 1, 2)  # degrees about X

# %% [markdown]
# One dip with an even film of a fixed number of points: point *n* then is the same place of the
# printed sheet in every dip. The picture's resolution does not matter here, so it is low.

# %%
job = dipwright.open(PROJECT)
while job.immersion_count > 1:
    job.remove_immersion(1)
job.update({"film.points": (60, 84), "sheet.dpi": 40, "immersions[0].rotation_deg": (0, 0, 0)})


def places(swell, tilt):
    """Where each film point lands on the model: (points, 3), mm; NaN where it paints nothing."""
    job["film.swell"] = (swell, swell)
    job["immersions[0].rotation_deg"] = (tilt, 0, 0)
    dip = job.run(certainty=False).immersions[0]
    to_model = numpy.linalg.inv(dip.body.model_to_pose)
    landed = dip.film.places @ to_model[:3, :3].T + to_model[:3, 3]
    landed[dip.film.surface_triangles < 0] = numpy.nan
    return landed


# %% [markdown]
# The dip for which the sheet is printed, and all others. `nanpercentile` leaves out points that paint
# in only one of the two.

# %%
planned = places(1.02, 0)
errors = numpy.array([
    [numpy.nanpercentile(numpy.linalg.norm(places(swell, tilt) - planned, axis=1), 95)
     for tilt in TILTS]
    for swell in SWELLS
])

# %%
figure, axes = pyplot.subplots(figsize=(6, 4.5), layout="constrained")
drawn = axes.pcolormesh(TILTS, [100 * (swell - 1) for swell in SWELLS], errors, cmap="viridis")
for row, swell in enumerate(SWELLS):
    for column, tilt in enumerate(TILTS):
        axes.text(tilt, 100 * (swell - 1), f"{errors[row, column]:.1f}", ha="center", va="center",
                  color="white" if errors[row, column] < errors.max() / 2 else "black")
axes.set(xlabel="Tilt about X in degrees", ylabel="Swell of the film in %",
         title="How far the picture lands from its place")
figure.colorbar(drawn, label="95 % of the painted points are within, mm")
figure.savefig(PICTURE, dpi=150)
print(f"95 % within, mm; rows: swell {SWELLS}, columns: tilt {TILTS}\n{errors.round(2)}")
