#!/usr/bin/env python3
"""The five minutes of README.md in Python, and a search for better poses.

    python3 five_minutes.py MODEL FOLDER [PATH=VALUE ...]

MODEL is a textured model, such as the sample turtle.obj. Results go to FOLDER. Values such as
film.points=60x84 replace those of the project; a coarse film is quick.
"""
import pathlib
import sys

import dipwright


def show(share, text):
    print(f"\r{100 * share:3.0f} %  {text:50}", end="", file=sys.stderr, flush=True)


def main(model, folder, *settings):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)

    # 1. Make a project. Dip 1 prints the belly, dip 2 the shell with the model turned over.
    job = dipwright.new(model, size_mm=110, immersions=[
        {"name": "Belly"},
        {"name": "Shell", "rotation_deg": (0, 0, 180)},
    ])
    job.update(dict(setting.split("=", 1) for setting in settings))
    job.save(folder / "turtle.dipw")

    # 2. Run it, and look at the verdict first.
    result = job.run(progress=show)
    print(f"\n{result.verdict}")
    result.save(folder / "results")

    # 3. Change something: the film swells by 6 % and flows, and the belly is turned by 15°.
    changed = job.copy()
    changed["film.swell"] = "1.06x1.06"
    changed["film.relaxation_time_s"] = 0
    changed["immersions[0].rotation_deg"] = (0, 15, 0)
    compared = changed.run(progress=show)
    print(f"\ncoverage {result.coverage:.1%}, changed {compared.coverage:.1%}")

    # 4. Search for the best pose of a single dip, and take it. The numbers are for a quick look;
    #    without them, the search is as thorough as that of the command line.
    search = job.search(1, candidates=6, directions=60, refined=0, finer=1, confirmed=0,
                        progress=show)
    best = search.ranking[0]
    print(f"\nbest pose {best.immersions[0]['rotation_deg']}, "
          f"coverage {best.measures['coverage']:.1%}")
    job.use(best)
    job.save(folder / "best.dipw")

    # 5. Print the sheet of the belly into a file.
    for warning in result.immersions[0].sheet.print_to_file(folder / "sheet.pdf"):
        print(warning)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
