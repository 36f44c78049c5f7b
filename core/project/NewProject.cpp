#include "project/NewProject.h"

#include "import/trusted/ImportModel.h"
#include "project/CadModel.h"
#include "project/Project.h"

#include <QDate>

namespace dipwright {

Project newProject(const QString& path) {
    Project project;
    project.name = projectName(path);
    project.date = QDate::currentDate().toString(Qt::ISODate);
    project.film.resolution = FilmResolution::Automatic;
    project.film.work = newProjectFilmWork;
    project.film.wantedError = newProjectWantedError;
    project.process.contactTravel = newProjectContactTravel;
    return project;
}

void setModel(Project& project, const ImportedModel& imported, const QString& source,
              const ImportOptions& options) {
    project.modelOrigin.unitMillimetres = options.unitMillimetres;
    takeModel(project, imported, source);
    project.modelOrigin.texture = options.texture;
}

} // namespace dipwright
