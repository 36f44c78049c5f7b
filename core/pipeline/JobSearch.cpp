#include "pipeline/JobSearch.h"

#include "base/Error.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QJsonDocument>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PoseSearch)
};

// Of all that the dips of a search depend on; its poses are not among that.
QByteArray identityOf(const Project& project, const QString& solver) {
    const QJsonObject whole = toJson(project);
    QJsonObject counting;
    for (const char* key : {"model", "film", "process", "body", "tolerance"}) {
        counting[QLatin1String(key)] = whole[QLatin1String(key)];
    }
    counting[QLatin1String("solver")] = solver;
    return QCryptographicHash::hash(QJsonDocument(counting).toJson(QJsonDocument::Compact),
                                    QCryptographicHash::Sha256);
}

} // namespace

SearchSubject searchSubject(const Project& project, const QString& solver) {
    if (!project.model) {
        throw Error(Text::tr("The project has no model, import one first"), project.name);
    }
    SearchSubject subject;
    subject.name = project.name;
    subject.identity = identityOf(project, solver);
    subject.model = project.model;
    subject.film = project.film;
    subject.process = project.process;
    subject.fieldResolution = project.fieldResolution;
    subject.marks = project.tolerance.marks;
    subject.registrationError = project.share.registrationError;
    subject.immersions = project.immersions;
    return subject;
}

} // namespace dipwright
