#include "workbench/serving/RemoteDips.h"

#include "base/Error.h"
#include "base/OneLine.h"
#include "pipeline/DipCache.h"
#include "project/ProjectStore.h"
#include "serving/ServerClient.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QTemporaryDir>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Serving)
};

constexpr qint64 mostDipBytes = qint64(1) << 30;

SolverInfo solverIn(const QJsonObject& job) {
    const QJsonObject json =
        job[QStringLiteral("outcome")].toObject()[QStringLiteral("solver")].toObject();
    const auto text = [&](const char* key) { return oneLine(json[QLatin1String(key)].toString()); };
    SolverInfo solver;
    solver.id = text("id");
    solver.name = text("name");
    solver.version = text("version");
    solver.device = text("device");
    solver.available = true;
    return solver;
}

// Waits for the job, whose project was saved as `file`, and returns its dips.
std::shared_ptr<const JobResult> dipsOf(const QString& id, const Project& project,
                                        const QString& file, ServerClient& client,
                                        const ServerAddress& address, const Progress& progress) {
    const QJsonObject job = client.wait(id, progress.part(0.05, 0.85));
    progress(0.85, Text::tr("Fetching the results"));
    const QString dips = dipCacheFile(file);
    client.fetch(id, QFileInfo(dips).fileName(), dips, mostDipBytes, progress.cancelToken);
    const auto result = cachedDipsOf(project, solverIn(job), file, progress.part(0.9, 1));
    if (!result) {
        throw Error(Text::tr("The server's results do not fit this program. Install the same "
                             "version of Dipwright on both computers"),
                    address.text());
    }
    return result;
}

} // namespace

std::shared_ptr<const JobResult> remoteDips(const Project& project, const ServerAccess& server,
                                            const Progress& progress) {
    progress(0, Text::tr("Sending the project"));
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("project.dipw"));
    saveProject(project, file);
    ServerClient client(server.address, server.token);
    const QString id = client.submit(file, project.name, progress.cancelToken);
    try {
        const auto result = dipsOf(id, project, file, client, server.address, progress);
        client.remove(id);
        return result;
    } catch (...) {
        client.abandon(id);
        throw;
    }
}

} // namespace dipwright
