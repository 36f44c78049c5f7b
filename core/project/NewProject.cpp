#include "project/NewProject.h"

#include "import/trusted/ImportModel.h"
#include "project/Project.h"

#include <QDate>

namespace dipwright {

Project newProject(const QString& path) {
    Project project;
    project.name = projectName(path);
    project.date = QDate::currentDate().toString(Qt::ISODate);
    project.film.resolution = FilmResolution::Automatic;
    return project;
}

void setModel(Project& project, const ImportedModel& imported, const QString& source,
              const ImportOptions& options) {
    project.model = std::make_shared<const TexturedMesh>(imported.model);
    project.modelOrigin.source = source;
    project.modelOrigin.texture = options.texture;
    project.modelOrigin.unitMillimetres = options.unitMillimetres;
    project.modelOrigin.remarks = imported.report.remarks();
    project.modelOrigin.sha256.clear();
}

} // namespace dipwright
