#include "python/Job.h"

#include "base/Error.h"
#include "project/NewProject.h"
#include "project/ProfileLibrary.h"
#include "project/Profiles.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace dipwright::python {
namespace {

constexpr std::size_t mostImmersions = 2;

// Lets other threads of Python go on meanwhile: "model.tessellation_mm" takes seconds.
void setIn(Project& project, const QString& path, const py::object& value) {
    const QString text = settingText(valueByPath(project, path), value);
    const py::gil_scoped_release released;
    setByPath(project, path, text);
}

void setAll(Project& project, const Values& values, const QString& prefix = {}) {
    using Setting = Values::value_type;
    std::vector<const Setting*> settings;
    for (const Setting& setting : values) {
        settings.push_back(&setting);
    }
    std::ranges::stable_sort(settings, {}, [](const Setting* s) { return settingOrder(s->first); });
    for (const Setting* setting : settings) {
        setIn(project, prefix + setting->first, setting->second);
    }
}

void addTo(Project& project, const Values& values) {
    const std::size_t index = project.immersions.size();
    if (index == mostImmersions) {
        throw Error(QStringLiteral("A part is dipped once or twice; remove an immersion first"),
                    QStringLiteral("immersions"));
    }
    project.immersions.emplace_back().name = QStringLiteral("Dip %1").arg(index + 1);
    setAll(project, values, QStringLiteral("immersions[%1].").arg(index));
}

// Python may change its current folder.
QString wholePath(const QString& path) {
    return QDir::cleanPath(QFileInfo(path).absoluteFilePath());
}

} // namespace

Job Job::opened(const QString& path) {
    Job job;
    job.known_ = FileVersion::of(path);
    job.project_ = loadProject(path);
    job.path_ = wholePath(path);
    return job;
}

Project begunProject(const QString& model, const QString& preset,
                     const std::vector<Values>& immersions) {
    Project project = newProject(model);
    applyPreset(project, preset);
    if (!immersions.empty()) {
        project.immersions.clear();
    }
    for (const Values& values : immersions) {
        addTo(project, values);
    }
    return project;
}

Job Job::made(const Project& begun, const QString& model, const ImportOptions& options,
              const Progress& progress) {
    Job job;
    job.project_ = begun;
    const ImportedModel imported = importModel(model, options, progress);
    setModel(job.project_, imported, model, options);
    job.importNotes_ = imported.report.warnings + imported.report.repairs;
    return job;
}

py::object Job::value(const QString& path) const {
    return toPython(valueByPath(project_, path));
}

void Job::setValue(const QString& path, const py::object& value) {
    setValues({{path, value}});
}

void Job::setValues(const Values& values) {
    Project changed = project_;
    setAll(changed, values);
    project_ = std::move(changed);
}

void Job::addImmersion(const Values& values) {
    Project changed = project_;
    addTo(changed, values);
    project_ = std::move(changed);
}

void Job::removeImmersion(int index) {
    if (index < 0 || std::size_t(index) >= project_.immersions.size() ||
        project_.immersions.size() == 1) {
        throw Error(QStringLiteral("There is no such dip that can be removed; a part is dipped "
                                   "once or twice"),
                    QStringLiteral("immersions[%1]").arg(index));
    }
    project_.immersions.erase(project_.immersions.begin() + index);
}

void Job::setImmersions(const std::vector<Immersion>& immersions) {
    project_.immersions = immersions;
}

void Job::useProfile(const QString& kind, const QString& name) {
    applyProfile(project_, ProfileLibrary().profile(profileKindOf(kind), name));
}

void Job::save(const std::optional<Path>& wanted) {
    const QString asked = wanted ? pathText(*wanted) : path_;
    if (asked.isEmpty()) {
        throw Error((wanted ? QStringLiteral("The name of the file is empty; name one, such as %1")
                            : QStringLiteral("The project has no file yet; name one, such as %1"))
                        .arg(QStringLiteral("save(\"part.dipw\")")),
                    project_.name);
    }
    const QString path = wholePath(asked);
    const ProjectFile locked(path);
    FileVersion known = path == path_ ? known_ : FileVersion::of(path);
    Project project = project_;
    if (path_.isEmpty()) {
        project.name = projectName(path);
    }
    replaceProject(project, path, known);
    project_ = std::move(project);
    known_ = known;
    path_ = path;
}

Values immersionValues(const Immersion& immersion) {
    const QString prefix = QStringLiteral("immersions[0].");
    Project project;
    project.immersions = {immersion};
    Values values;
    for (const ProjectValue& value : projectValues(project)) {
        if (value.path.startsWith(prefix)) {
            values[value.path.mid(prefix.size())] = toPython(value);
        }
    }
    return values;
}

} // namespace dipwright::python
