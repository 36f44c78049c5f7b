// Declares the measurements of `dipwright-cli bench`.
#pragma once

#include "base/Progress.h"
#include "cli/bench/Statistics.h"
#include "settings/Immersion.h"
#include "solver/SolverRegistry.h"

#include <QJsonObject>

#include <map>
#include <optional>

namespace dipwright {

struct Project;
struct TexturedMesh;

} // namespace dipwright

namespace dipwright::cli {

// The step rate of a whole dip with the paper's film.
struct StepRow {
    QString body;
    int fieldSamples = 0; // samples along an edge of the field's cube
    qint64 points = 0, constraints = 0;
    int iterations = 0; // iterations per step; each iteration solves each constraint once
    Statistics stepsPerSecond;
    std::optional<double> paper; // steps/s in the paper; empty if the paper does not state them

    double solvesPerSecond() const {
        return stepsPerSecond.median * double(constraints) * iterations;
    }
    double flopsPerSecond() const;
};

// A task and the seconds it takes.
struct TimedRow {
    QString what;      // name for display
    QJsonObject facts; // values for the JSON output
    Statistics seconds;
};

// How soon results follow a change of the pose (pipeline/JobDraft.h).
struct LiveRow {
    QString model;            // name of the project
    Statistics firstAnswer;   // s from the change to the coarsest draft
    double dipsPerSecond = 0; // drafts per second while the body is dragged
    Statistics final;         // s from the change to the result of the job
};

// Makes or reads the bodies "sphere", "tetrahedron" and "turtle" on first use. The sphere is the
// one of Table I: radius 35 mm, about 26,000 vertices.
class BenchBodies {
public:
    struct Body {
        std::shared_ptr<const TexturedMesh> model;
        Immersion immersion;
    };
    const Body& body(const QString& name);
    // Returns the file of the sample turtle. Throws Error if the samples are not installed.
    static QString turtleFile();
    // Returns the turtle's project, with an A4 film of 120 × 170 points. Throws Error if the
    // samples are not installed.
    static Project turtle();

private:
    std::map<QString, Body> bodies_;
};

// Returns "n³" for display. It is concatenated, because QString::arg would read a literal ³ after a
// place marker as a digit of the marker.
inline QString cubed(int n) {
    return QString::number(n) + QChar(u'³');
}

// The solver to measure, and the number of runs of each measurement.
struct BenchSolver {
    const SolverRegistry& registry;
    QString id;
    int runs = 1;
};

// Measures the first `rows` rows of the paper's Table I: the sphere is dipped through films of 96
// to 117,600 points.
std::vector<StepRow> measureTableOne(const BenchSolver& solver, BenchBodies& bodies, int rows,
                                     const Progress& progress);
// Measures the paper's Figure 7: three bodies are dipped through a film of 21,600 points. The field
// first has 32 samples along an edge. This number is doubled repeatedly, up to `finest`.
std::vector<StepRow> measureFieldSweep(const BenchSolver& solver, BenchBodies& bodies, int finest,
                                       const Progress& progress);
// Measures whole dips of the sphere with both presets, with films of columns × rows points.
std::vector<TimedRow> measureDips(const BenchSolver& solver, BenchBodies& bodies, int columns,
                                  int rows, const Progress& progress);
// Measures the time to build fields of 64³ to `finest`³ samples around a sphere of 50,000
// triangles.
std::vector<TimedRow> measureFields(int runs, int finest, const Progress& progress);
// Makes dip 1 of the turtle. Then measures its reverse texture, and its sheet as PNG and as PDF.
std::vector<TimedRow> measureSheets(const BenchSolver& solver, const std::vector<int>& resolutions,
                                    const Progress& progress);
// Measures each step of `run` on the turtle except the dips. Steps that work on a single dip use
// dip 1.
std::vector<TimedRow> measureParts(const BenchSolver& solver, const Progress& progress);
// Measures the whole command `run` on the turtle, from project to files. The field is built each
// time.
std::vector<TimedRow> measureRun(const BenchSolver& solver, const Progress& progress);
// Turns the body of each project file, or of each sample if there is none. Measures how soon
// results follow, without a window.
std::vector<LiveRow> measureLive(const BenchSolver& solver, QStringList projects,
                                 const Progress& progress);

} // namespace dipwright::cli
