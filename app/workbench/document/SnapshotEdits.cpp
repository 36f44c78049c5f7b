#include "workbench/document/SnapshotEdits.h"

#include "dip/LaidFilm.h"
#include "film/DippedFilm.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(SnapshotEdits)
};

void keep(Document& document, const QString& text, const std::vector<Snapshot>& kept) {
    document.edit(text, {}, [&kept](Project& project) { project = withSnapshots(project, kept); });
}

} // namespace

QJsonObject snapshotMeasures(const Document& document) {
    if (!document.result() || !document.isFresh()) {
        return {};
    }
    const JobResult& result = *document.result();
    double stretch = 0, uncertain = 0;
    for (const ImmersionResult& immersion : result.immersions) {
        const Distribution stretches = distribution(immersion.laid->painted().constraints);
        stretch = std::max(stretch, stretches.percentile95);
        uncertain += immersion.verdict.areaToCheck;
    }
    return {{QStringLiteral("painted"), result.coverageTotal},
            {QStringLiteral("stretch"), stretch},
            {QStringLiteral("uncertain_mm2"), uncertain}};
}

void takeSnapshot(Document& document, const QString& name) {
    std::vector<Snapshot> kept = snapshots(document.project());
    kept.push_back(snapshotOf(document.project(), name,
                              QDateTime::currentDateTime().toString(Qt::ISODate),
                              snapshotMeasures(document)));
    keep(document, Text::tr("Take snapshot “%1”").arg(kept.back().name), kept);
}

void removeSnapshot(Document& document, std::size_t number) {
    std::vector<Snapshot> kept = snapshots(document.project());
    const QString name = kept.at(number).name;
    kept.erase(kept.begin() + std::ptrdiff_t(number));
    keep(document, Text::tr("Remove snapshot “%1”").arg(name), kept);
}

void restoreSnapshot(Document& document, std::size_t number) {
    const Snapshot snapshot = snapshots(document.project()).at(number);
    document.edit(Text::tr("Restore snapshot “%1”").arg(snapshot.name), {},
                  [&snapshot](Project& project) { project = atSnapshot(project, snapshot); });
}

} // namespace dipwright
