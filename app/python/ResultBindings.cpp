// The result of a run: its dips, pictures, figures and files.
#include "python/Arrays.h"
#include "python/Values.h"

#include "base/Error.h"
#include "outputs/MakeOutputs.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/Report.h"
#include "pipeline/WriteResults.h"
#include "python/Parts.h"
#include "python/Work.h"
#include "results/Results.h"

#include <algorithm>

namespace dipwright::python {
namespace {

constexpr int mapEdge = 1600;                           // pixels, as in the result files
constexpr int leastMapEdge = 100, mostMapEdge = 20'000; // pixels

struct Share : Run {
    const BodyShare& split() const { return *(**this).share; }
};
struct Tolerances : Dip {
    const DipTolerances& dip() const { return run->tolerances->dips[number]; }
};

py::object pictureOrNone(const QImage& picture) {
    return picture.isNull() ? py::object(py::none()) : pixels(picture);
}

// Draws a map without the GIL. `longEdge` is its longer side in pixels.
template <typename Draw>
py::array drawn(int longEdge, const Draw& draw) {
    if (longEdge < leastMapEdge || longEdge > mostMapEdge) {
        throw Error(QStringLiteral("The longer side of a map must be %1 to %2 pixels")
                        .arg(leastMapEdge)
                        .arg(mostMapEdge),
                    QStringLiteral("long_edge"));
    }
    return pixels(computed(py::none(), [&](const Progress&) { return draw(); }));
}

py::object certaintyMap(const Dip& dip, int longEdge) {
    if (!dip->knownError()) {
        return py::none();
    }
    const double limit = allowedError(Zone::C, dip.run->project.tolerance);
    return drawn(longEdge, [&] {
        return numericalErrorMap(*dip->laid, dip->knownError()->pointErrors, limit, longEdge);
    });
}

std::vector<Dip> immersionsOf(const Run& run) {
    std::vector<Dip> dips;
    for (std::size_t number = 0; number < run->immersions.size(); ++number) {
        dips.push_back({run, number});
    }
    return dips;
}

void save(const Run& run, const Path& folder, const py::object& progress) {
    runWork(progress, [&](const Progress& reported) {
        writeResults(run->project, *run, pathText(folder), reported);
    });
}

// Throws Error that lists the reasons if an output failed.
void requireAll(const std::vector<OutputStatus>& outputs, const QString& folder) {
    QStringList reasons;
    for (const OutputStatus& status : outputs) {
        if (status.state == OutputState::Failed) {
            reasons.append(outputText(status.output) + QStringLiteral(": ") + status.reason);
        }
    }
    if (!reasons.isEmpty()) {
        throw Error(QStringLiteral("%1 of %2 outputs failed. %3")
                        .arg(reasons.size())
                        .arg(outputs.size())
                        .arg(reasons.join(QStringLiteral(". "))),
                    folder);
    }
}

std::vector<OutputStatus> makeAll(const Run& run, const Path& folder, const QString& outputs,
                                  bool overwrite, bool acceptClipping, const py::object& progress) {
    const OutputRequest request{pathText(folder), outputsNamed(run->project, outputs),
                                run.projectFile, overwrite, acceptClipping};
    std::vector<OutputStatus> made = computed(
        progress, [&](const Progress& reported) { return makeOutputs(*run, request, reported); });
    requireAll(made, request.folder);
    return made;
}

void bindParts(py::module_& module) {
    py::class_<Share>(module, "Share", "The part's surface, split between two dips.")
        .def_property_readonly(
            "positions",
            [](const Share& share) {
                const auto& positions = share.split().fade.mesh->mesh().positions;
                return sharedArray(share.result, reinterpret_cast<const float*>(positions.data()),
                                   {py::ssize_t(positions.size()), 3});
            },
            "Corners of the finely divided part: (positions, 3) float32, mm, model coordinates.")
        .def_property_readonly(
            "triangles",
            [](const Share& share) {
                const auto& triangles = share.split().fade.mesh->mesh().triangles;
                return sharedArray(share.result,
                                   reinterpret_cast<const std::uint32_t*>(triangles.data()),
                                   {py::ssize_t(triangles.size()), 3});
            },
            "Corners of each of its triangles: (triangles, 3) uint32.")
        .def_property_readonly(
            "painters",
            [](const Share& share) {
                const auto& painters = share.split().painters;
                return sharedArray(share.result,
                                   reinterpret_cast<const std::uint8_t*>(painters.data()),
                                   {py::ssize_t(painters.size())});
            },
            "What paints each triangle: (triangles,) uint8; 0 nothing, 1 the first dip, 2 the "
            "second,"
            "\n3 both.")
        .def_property_readonly(
            "seam",
            [](const Share& share) {
                const auto& seam = share.split().join;
                return sharedArray(share.result, reinterpret_cast<const float*>(seam.data()),
                                   {py::ssize_t(seam.size()), 2, 3});
            },
            "The seam in straight pieces: (pieces, 2, 3) float32, both ends, mm, model "
            "coordinates.")
        .def_property_readonly(
            "seam_mm", [](const Share& share) { return share.split().cost.length; },
            "Length of the seam, mm.")
        .def_property_readonly(
            "areas",
            [](const Share& share) {
                const ShareAreas& areas = share.split().areas;
                return std::map<std::string, double>{{"first", areas.first},
                                                     {"second", areas.second},
                                                     {"both", areas.both},
                                                     {"none", areas.none}};
            },
            "Painted by the first dip alone, the second alone, both, none: mm².");

    py::class_<Tolerances>(module, "Tolerances",
                           "How far handling may move the colours of one dip.")
        .def_property_readonly(
            "median", [](const Tolerances& object) { return object.dip().spread.median; },
            "Half of the painted area is within this, mm.")
        .def_property_readonly(
            "percentile95",
            [](const Tolerances& object) { return object.dip().spread.percentile95; },
            "95 % of the painted area is within this, mm.")
        .def_property_readonly(
            "maximum", [](const Tolerances& object) { return object.dip().spread.maximum; },
            "All of the painted area is within this, mm.")
        .def_property_readonly(
            "point_spreads",
            [](const Tolerances& object) {
                const std::vector<float>& spreads = object.dip().filmPoints;
                return sharedArray(object.owner(), spreads.data(), {py::ssize_t(spreads.size())});
            },
            "Spread of each film point: (points,) float32, mm; 0 where the film does not paint.");

    py::class_<OutputStatus>(module, "Output", "One output that was made.")
        .def_property_readonly(
            "name", [](const OutputStatus& status) { return outputWord(status.output); },
            "Its word, such as \"sheet_pdf\".")
        .def_property_readonly(
            "files", [](const OutputStatus& status) { return listOf(status.files); },
            "Its files, relative to the folder.")
        .def_property_readonly(
            "notes", [](const OutputStatus& status) { return listOf(status.notes); },
            "Sentences for the user.")
        .def("__repr__", [](const OutputStatus& status) {
            return QStringLiteral("<Output %1>").arg(outputWord(status.output));
        });
}

void bindDip(py::module_& module) {
    py::class_<Dip>(module, "ImmersionResult", "The result of one dip.")
        .def_property_readonly(
            "name", [](const Dip& dip) { return dip->immersion.name; }, "The dip's name.")
        .def_property_readonly("film", filmOf, "The film at the end of the dip.")
        .def_property_readonly("body", bodyOf, "The part in its pose.")
        .def_property_readonly("sheet", sheetOf, "The sheet to print.")
        .def_property_readonly("verdict", py::overload_cast<const Dip&>(verdictOf),
                               "The verdict on this dip alone.")
        .def_property_readonly("certainty", certaintyOf,
                               "The numerical error of the sheet; None if the run did not estimate "
                               "it.")
        .def_property_readonly(
            "tolerances",
            [](const Dip& dip) {
                return dip.run->tolerances ? py::cast(Tolerances{dip}) : py::none();
            },
            "How far handling may move the colours; None without run(tolerances=True).")
        .def_property_readonly(
            "coverage", [](const Dip& dip) { return dip->coverage->share; },
            "Painted share of the surface that is not masked, 0 to 1.")
        .def_property_readonly(
            "read_back_mm",
            [](const Dip& dip) {
                return dip->readBack ? std::optional(dip->readBack->percentile95) : std::nullopt;
            },
            "Read-back error of the texture on 95 % of the painted area, mm; None for a draft.")
        .def_property_readonly(
            "solver",
            [](const Dip& dip) {
                return QStringLiteral("%1 %2 on %3")
                    .arg(dip->solver.name, dip->solver.version, dip->solver.device);
            },
            "The solver that simulated the dip, its version and its device.")
        .def(
            "stretch_map",
            [](const Dip& dip, int longEdge) {
                return drawn(longEdge, [&] { return stretchMap(*dip->laid, longEdge); });
            },
            py::arg("long_edge") = mapEdge,
            "Draws stretch.png: (height, width, 3 or 4) uint8. long_edge: longer side in pixels.")
        .def(
            "wrinkling_map",
            [](const Dip& dip, int longEdge) {
                return drawn(longEdge, [&] { return wrinklingMap(*dip->laid, longEdge); });
            },
            py::arg("long_edge") = mapEdge, "Draws wrinkling.png, like stretch_map().")
        .def("certainty_map", certaintyMap, py::arg("long_edge") = mapEdge,
             "Draws certainty.png, like stretch_map(); None without an estimate.")
        .def("__repr__", [](const Dip& dip) {
            return QStringLiteral("<ImmersionResult %1: coverage %2 %>")
                .arg(dip->immersion.name)
                .arg(100 * dip->coverage->share, 0, 'f', 1);
        });
}

} // namespace

void bindResult(py::module_& module) {
    bindParts(module);
    bindDip(module);
    py::class_<Run>(module, "Result",
                    "The result of Job.run(). Its parts and arrays keep all of it in memory.")
        .def_property_readonly("immersions", immersionsOf, "One result for each dip.")
        .def_property_readonly("verdict", py::overload_cast<const Run&>(verdictOf),
                               "The verdict on the job, with the reasons of every dip.")
        .def_property_readonly(
            "coverage", [](const Run& run) { return run->coverageTotal; },
            "Share of the surface that all dips together paint, 0 to 1.")
        .def_property_readonly(
            "share", [](const Run& run) { return run->share ? py::cast(Share{run}) : py::none(); },
            "How two dips share the part; None if they do not.")
        .def_property_readonly(
            "proof", [](const Run& run) { return pictureOrNone(run->proof); },
            "The part as it will come out, from six sides: (height, width, 3 or 4) uint8.")
        .def_property_readonly(
            "coverage_picture", [](const Run& run) { return pictureOrNone(run->coverage); },
            "Which dip paints which area, like proof; None if the dips do not share the part.")
        .def_property_readonly(
            "notes", [](const Run& run) { return listOf(run->notes); }, "Sentences for the user.")
        .def_property_readonly(
            "report", [](const Run& run) { return toPython(report(run->project, *run)); },
            "All figures, as in report.json.")
        .def("save", save, py::arg("folder"), py::kw_only(), py::arg("progress") = py::none(),
             "Writes all result files into the folder, or none, as `dipwright-cli run` does.\n"
             "progress: as in Job.run(). Raises Error or Cancelled.")
        .def(
            "make_outputs", makeAll, py::arg("folder"), py::arg("outputs") = "Everything",
            py::kw_only(), py::arg("overwrite") = false, py::arg("accept_clipping") = false,
            py::arg("progress") = py::none(),
            "Writes some outputs into the folder, as `dipwright-cli run --outputs` does.\n\n"
            "outputs: the name of an output set, or words such as \"sheet_pdf,traveller\".\n"
            "overwrite: also replaces files that no output has made. accept_clipping: print files\n"
            "may lose colour that the printer cannot reach. Raises Error or Cancelled.")
        .def("__repr__", [](const Run& run) {
            return QStringLiteral("<Result of %1: %2, coverage %3 %>")
                .arg(run->project.name, adviceText(adviceOf(*run)))
                .arg(100 * run->coverageTotal, 0, 'f', 1);
        });
}

} // namespace dipwright::python
