// Job: a project that Python opens, changes, runs and saves.
#include "python/Arrays.h"
#include "python/Values.h"

#include "base/Error.h"
#include "import/trusted/ReadPictures.h"
#include "parallel/Threads.h"
#include "pipeline/Pipeline.h"
#include "python/Bindings.h"
#include "python/Job.h"
#include "python/Search.h"
#include "python/Session.h"
#include "python/Work.h"

namespace dipwright::python {
namespace {

constexpr int mostThreads = 1024;

struct Field {
    ProjectValue value;
};

QString kindWord(FieldKind kind) {
    switch (kind) {
    case FieldKind::Text:
        return QStringLiteral("text");
    case FieldKind::Choice:
        return QStringLiteral("choice");
    case FieldKind::Flag:
        return QStringLiteral("flag");
    case FieldKind::Number:
        return QStringLiteral("number");
    case FieldKind::WholeNumber:
        return QStringLiteral("whole number");
    case FieldKind::Colour:
        return QStringLiteral("colour");
    }
    return {};
}

std::optional<double> limitOf(const Field& field, double limit) {
    const FieldKind kind = field.value.rule.kind;
    const bool isNumber = kind == FieldKind::Number || kind == FieldKind::WholeNumber;
    return isNumber && field.value.rule.minimum < field.value.rule.maximum ? std::optional(limit)
                                                                           : std::nullopt;
}

Job open(const Path& path) {
    session();
    return computed(py::none(), [&](const Progress&) { return Job::opened(pathText(path)); });
}

Job make(const Path& model, std::optional<double> size, const std::optional<Path>& texture,
         const QString& preset, const std::vector<Values>& immersions, bool allowOutside,
         const py::object& progress) {
    session();
    ImportOptions options;
    options.texture = pathText(texture);
    options.allowOutside = allowOutside;
    if (size && !(*size >= 0.1 && *size <= 10'000)) {
        throw Error(QStringLiteral("The size must be 0.1 to 10,000 mm"), QStringLiteral("size_mm"));
    }
    if (size) {
        options.longestEdge = Millimetres(*size);
    }
    const Project begun = begunProject(pathText(model), preset, immersions);
    return computed(progress, [&](const Progress& reported) {
        return Job::made(begun, pathText(model), options, reported);
    });
}

void applyFilmImage(JobOptions& options, const std::optional<Path>& picture) {
    options.chessboard = picture && *picture == "chessboard";
    if (picture && !options.chessboard) {
        options.filmImage = computed(
            py::none(), [&](const Progress&) { return readPictureFile(pathText(*picture)); });
    }
}

Run run(Job& job, const py::object& progress, const QString& solver, bool certainty, bool laws,
        bool tolerances, bool cradles, const std::optional<Path>& filmImage, int threads) {
    const SolverRegistry& registry = session();
    if (threads < 0 || threads > mostThreads) {
        throw Error(QStringLiteral("The number of threads must be 0 to %1").arg(mostThreads),
                    QStringLiteral("threads"));
    }
    JobOptions options;
    options.solver = solver;
    options.estimatesNumericalError = certainty;
    options.refines = certainty;
    options.variesLaws = laws;
    options.computesTolerances = tolerances;
    options.makesCradles = cradles;
    applyFilmImage(options, filmImage);
    const Project project = job.project();
    const std::shared_ptr<const JobResult> previous = job.last;
    job.last = std::make_shared<const JobResult>(computed(progress, [&](const Progress& reported) {
        const ThreadLimit limit(threads);
        return runJob(project, registry, options, previous.get(), reported);
    }));
    return {job.last, job.path()};
}

SearchResult search(const Job& job, int immersions, int candidates, int directions, int refined,
                    int finer, int confirmed, int seed, bool paths, const Weights& weights,
                    const Limits& limits, const QString& solver, const py::object& progress) {
    SearchSettings settings;
    settings.immersions = immersions;
    settings.simulated = candidates;
    settings.directions = directions;
    settings.refined = refined;
    settings.finer = finer;
    settings.confirmed = confirmed;
    settings.seed = seed;
    settings.paths = paths;
    return searched(job.project(), settings, weights, limits, solver, progress);
}

std::vector<QString> pathsOf(const Job& job) {
    std::vector<QString> paths;
    for (const ProjectValue& value : projectValues(job.project())) {
        paths.push_back(value.path);
    }
    return paths;
}

bool contains(const Job& job, const QString& path) {
    const std::vector<QString> paths = pathsOf(job);
    return std::find(paths.begin(), paths.end(), path) != paths.end();
}

py::array modelPositions(const Job& job) {
    const std::shared_ptr<const TexturedMesh> model = job.project().model;
    return sharedArray(model, reinterpret_cast<const float*>(model->mesh.positions.data()),
                       {py::ssize_t(model->mesh.positions.size()), 3});
}

py::array modelTriangles(const Job& job) {
    const std::shared_ptr<const TexturedMesh> model = job.project().model;
    return sharedArray(model, reinterpret_cast<const std::uint32_t*>(model->mesh.triangles.data()),
                       {py::ssize_t(model->mesh.triangles.size()), 3});
}

void bindField(py::module_& module) {
    py::class_<Field>(module, "Field", "What is known about one value of a project.")
        .def_property_readonly(
            "path", [](const Field& field) { return field.value.path; },
            "Its path, such as \"film.swell\".")
        .def_property_readonly(
            "kind", [](const Field& field) { return kindWord(field.value.rule.kind); },
            "\"number\", \"whole number\", \"flag\", \"text\", \"choice\" or \"colour\".")
        .def_property_readonly(
            "unit", [](const Field& field) { return field.value.rule.unit; },
            "Unit of the number, such as \"mm\"; empty: none.")
        .def_property_readonly(
            "minimum", [](const Field& field) { return limitOf(field, field.value.rule.minimum); },
            "Least number; None if it is not a number.")
        .def_property_readonly(
            "maximum", [](const Field& field) { return limitOf(field, field.value.rule.maximum); },
            "Largest number; None if it is not a number.")
        .def_property_readonly(
            "choices", [](const Field& field) { return listOf(field.value.rule.choices); },
            "The words that a choice may be.")
        .def_property_readonly(
            "parts", [](const Field& field) { return field.value.rule.parts; },
            "How many values it has: 2 for a size.")
        .def_property_readonly(
            "value", [](const Field& field) { return toPython(field.value); }, "The value.")
        .def("__repr__",
             [](const Field& field) { return QStringLiteral("<Field %1>").arg(field.value.path); });
}

void bindValues(py::class_<Job>& job) {
    job.def("__getitem__", &Job::value, py::arg("path"),
            "Returns a value of the project by its path: job[\"film.swell\"]. Raises Error.")
        .def("__setitem__", &Job::setValue, py::arg("path"), py::arg("value"),
             "Sets a value by its path, as `--set` does. The value is a text, which may be a\n"
             "calculation with units (\"1in + 2mm\"), a number in the field's unit, or a tuple of\n"
             "either; None for null. Raises Error.")
        .def("__contains__", contains, py::arg("path"))
        .def("__iter__", [](const Job& object) { return py::iter(py::cast(pathsOf(object))); })
        .def("__len__", [](const Job& object) { return pathsOf(object).size(); })
        .def("keys", pathsOf, "Returns the paths of all values.")
        .def("update", &Job::setValues, py::arg("values"),
             "Sets several values by their paths, all or none. Raises Error.")
        .def(
            "field",
            [](const Job& object, const QString& path) {
                return Field{valueByPath(object.project(), path)};
            },
            py::arg("path"), "Returns unit, limits and choices of a value. Raises Error.");
}

void bindProject(py::class_<Job>& job) {
    job.def_property_readonly(
           "name", [](const Job& object) { return object.project().name; }, "The project's name.")
        .def_property_readonly(
            "path",
            [](const Job& object) {
                return object.path().isEmpty() ? std::nullopt : std::optional(object.path());
            },
            "The project's file; None if it was never saved.")
        .def_property_readonly(
            "import_notes", [](const Job& object) { return listOf(object.importNotes()); },
            "Sentences on what new() found and repaired in the model.")
        .def_property_readonly("model_positions", modelPositions,
                               "The model: (positions, 3) float32, mm. Shares its memory; "
                               "read-only.")
        .def_property_readonly("model_triangles", modelTriangles,
                               "Corners of each triangle of the model: (triangles, 3) uint32.")
        .def_property_readonly(
            "immersion_count", [](const Job& object) { return object.project().immersions.size(); },
            "Number of dips, 1 or 2.")
        .def("add_immersion", &Job::addImmersion, py::arg("values") = Values(),
             "Adds a dip. values: by their paths within the dip, such as\n"
             "{\"name\": \"Shell\", \"rotation_deg\": (0, 0, 180)}. Raises Error.")
        .def("remove_immersion", &Job::removeImmersion, py::arg("index"),
             "Removes a dip, counted from 0. Raises Error.")
        .def(
            "use",
            [](Job& object, const RankedPoses& poses) { object.setImmersions(poses.immersions); },
            py::arg("poses"), "Dips the part in the poses that a search found.")
        .def("use_profile", &Job::useProfile, py::arg("kind"), py::arg("name"),
             "Applies a profile. kind: \"printer\", \"film\" or \"tank\". Raises Error.")
        .def(
            "copy", [](const Job& object) { return Job(object); },
            "Returns a copy, which shares model and last result.")
        .def("save", &Job::save, py::arg("path") = py::none(),
             "Writes the project file, by default to where it was opened. Raises Error if another\n"
             "program has it open or has changed it.");
}

} // namespace

void bindJob(py::module_& module) {
    bindField(module);
    const SearchSettings usual;
    py::class_<Job> job(
        module, "Job",
        "A project: model, film, dips and all settings. job[\"film.swell\"] gets and\n"
        "sets a value by its path; the paths are in docs/files-and-commands.md.\n\n"
        "The project's file changes only by save(). One thread at a time.");
    bindValues(job);
    bindProject(job);
    job.def(
           "run", run, py::kw_only(), py::arg("progress") = py::none(), py::arg("solver") = "",
           py::arg("certainty") = true, py::arg("laws") = false, py::arg("tolerances") = false,
           py::arg("cradles") = false, py::arg("film_image") = py::none(), py::arg("threads") = 0,
           "Simulates every dip and makes the sheets. Another run after a change computes only "
           "what\n"
           "the change affects.\n\n"
           "progress: called as progress(share, text) with 0 to 1 on the calling thread; if it\n"
           "returns False, the run ends with Cancelled. solver: id of a plugin instead of the\n"
           "project's. certainty: estimates the numerical error, and refines films until their\n"
           "sheets can be printed and have the wanted error. laws, tolerances: as `--laws` and\n"
           "`--tolerances`, many more dips. cradles: also makes cradles. film_image: a picture's\n"
           "path or \"chessboard\", to print instead of the texture. threads: at most so many; 0:\n"
           "all cores. The GIL is released. Raises Error or Cancelled.")
        .def("search", search, py::arg("immersions") = usual.immersions, py::kw_only(),
             py::arg("candidates") = usual.simulated, py::arg("directions") = usual.directions,
             py::arg("refined") = usual.refined, py::arg("finer") = usual.finer,
             py::arg("confirmed") = usual.confirmed, py::arg("seed") = usual.seed,
             py::arg("paths") = usual.paths, py::arg("weights") = Weights(),
             py::arg("limits") = Limits(), py::arg("solver") = "", py::arg("progress") = py::none(),
             "Searches for dip poses, as `dipwright-cli optimize` does. The project does not "
             "change;\n"
             "use(search.ranking[0]) takes the best poses.\n\n"
             "immersions: 1 or 2 dips. The other numbers are the options of `optimize`. weights,\n"
             "limits: by measure, instead of the project's; a limit of None removes it. progress: "
             "as\n"
             "in run(), but a cancelled search returns the best so far, if there is any. Raises\n"
             "Error or Cancelled.")
        .def("__repr__", [](const Job& object) {
            return QStringLiteral("<Job %1>").arg(object.project().name);
        });

    module.def("open", open, py::arg("path"), "Opens a project file. Raises Error.");
    module.def(
        "new", make, py::arg("model"), py::kw_only(), py::arg("size_mm") = py::none(),
        py::arg("texture") = py::none(), py::arg("preset") = "production",
        py::arg("immersions") = std::vector<Values>(), py::arg("allow_outside") = false,
        py::arg("progress") = py::none(),
        "Makes a project of a model, as `dipwright-cli new` does. The sandboxed reader reads\n"
        "the files.\n\n"
        "model: OBJ, PLY, STL, glTF, 3MF … size_mm: length of its longest edge; default: one\n"
        "unit of the file is 1 mm, unless the file states its unit. texture: a picture instead\n"
        "of the model's. preset:\n"
        "\"production\" or \"paper-2020\". immersions: one or two dips, each as for\n"
        "Job.add_immersion(); default: one without rotation. allow_outside: also reads files\n"
        "outside the model's folder. progress: as in Job.run(). Raises Error or Cancelled.");
}

} // namespace dipwright::python
