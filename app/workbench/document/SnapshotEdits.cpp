#include "workbench/document/SnapshotEdits.h"

#include "dip/LaidFilm.h"
#include "film/DippedFilm.h"
#include "texture/ReverseTexture.h"

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
    double stretch = 0, largest = 0, uncertain = 0, wrinkled = 0, air = 0, marked = 0, pale = 0;
    double error = 0, ink = 0;
    for (const ImmersionResult& immersion : result.immersions) {
        const PaintedStretch& painted = immersion.laid->painted();
        const Distribution stretches = distribution(painted.constraints);
        stretch = std::max(stretch, stretches.percentile95);
        largest = std::max(largest, stretches.maximum);
        wrinkled = std::max(wrinkled, painted.wrinkling.share);
        uncertain += immersion.verdict.areaToCheck;
        air += immersion.coverage->trappedAir.area;
        marked += immersion.coverage->marked.any;
        pale += immersion.inkShortfall.value_or(immersion.texture->shortfallArea);
        if (const NumericalErrorEstimate* estimate = immersion.knownError()) {
            error = std::max(error, estimate->offBy.percentile95);
        }
        for (const InkArea& plate : immersion.inks) {
            ink += plate.area;
        }
    }
    QJsonObject measures{{"painted", result.coverageTotal},
                         {"stretch", stretch},
                         {"largest_stretch", largest},
                         {"uncertain_mm2", uncertain},
                         {"error_mm", error},
                         {"wrinkled", wrinkled},
                         {"air_mm2", air},
                         {"marked_mm2", marked},
                         {"pale_mm2", pale},
                         {"ink_mm2", ink}};
    if (result.share) {
        measures.insert(QStringLiteral("seam_mm"), result.share->cost.length);
    }
    return measures;
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
