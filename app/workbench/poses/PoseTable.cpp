#include "workbench/poses/PoseTable.h"

#include "dip/BodyPath.h"

#include <QApplication>
#include <QHeaderView>

#include <algorithm>

namespace dipwright {

namespace {

constexpr QSize pictureSize(56, 56);
enum Column { Picture, Objective, Painted, Reasons, Columns };

QString posesText(const RankedPoses& poses) {
    QStringList lines;
    for (const Immersion& immersion : poses.immersions) {
        QStringList angles;
        for (const Degrees& angle : immersion.rotation) {
            angles.append(QLocale().toString(angle.value(), 'f', 1));
        }
        QString line = PoseTable::tr("%1: turned by %2° about X, Y, Z")
                           .arg(immersion.name, angles.join(QStringLiteral("°, ")));
        if (const QString path = pathText(immersion.path); !path.isEmpty()) {
            line += QStringLiteral("; ") + path;
        }
        lines.append(line);
    }
    return lines.join(QLatin1Char('\n'));
}

// Returns the verdict on confirmed poses and, if they cannot simply be printed, its worst reason.
QString adviceOn(const RankedPoses& poses) {
    if (poses.advice() == Advice::NotJudged) {
        return {};
    }
    QString text = adviceText(poses.advice());
    for (const Verdict& verdict : poses.verdicts) {
        if (verdict.advice == poses.advice() && verdict.advice != Advice::Print &&
            !verdict.reasons.empty()) {
            return PoseTable::tr("%1: %2").arg(text,
                                               reasonText(verdict.reasons.front(), millimetres));
        }
    }
    return text;
}

QString measuresText(const RankedPoses& poses) {
    QStringList lines;
    for (const Measure measure : allMeasures()) {
        lines.append(PoseTable::tr("%1: %2").arg(measureName(measure),
                                                 measureText(measure, poses.measures[measure])));
    }
    return lines.join(QLatin1Char('\n'));
}

QTableWidgetItem* cell(const QString& text, const QString& help) {
    auto* item = new QTableWidgetItem(text);
    item->setToolTip(help);
    return item;
}

} // namespace

PoseTable::PoseTable(QWidget* parent) : QTableWidget(0, Columns, parent) {
    setObjectName(QStringLiteral("poseTable"));
    setAccessibleName(tr("Found poses, best first"));
    setHorizontalHeaderLabels(
        {tr("Pose"), tr("Objective"), tr("Coverage,\nstretch"), tr("Verdict,\ndifferences")});
    horizontalHeader()->setSectionResizeMode(Reasons, QHeaderView::Stretch);
    horizontalHeader()->setSectionResizeMode(Picture, QHeaderView::Fixed);
    setColumnWidth(Picture, pictureSize.width() + 8);
    for (const int column : {Objective, Painted}) {
        horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    }
    verticalHeader()->setDefaultSectionSize(pictureSize.height() + 4);
    setIconSize(pictureSize);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setWordWrap(true);
    setTabKeyNavigation(false);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    connect(this, &QTableWidget::itemSelectionChanged, this, &PoseTable::chosenChanged);
    connect(this, &QTableWidget::cellClicked, this, [this](int row, int) {
        if (QApplication::keyboardModifiers() == Qt::NoModifier) {
            emit looked(std::size_t(row));
        }
    });
    connect(this, &QTableWidget::cellActivated, this,
            [this](int row, int) { emit applied(std::size_t(row)); });
}

void PoseTable::setResult(const SearchResult& result, const SearchSettings& settings,
                          const std::vector<QImage>& pictures) {
    const std::vector<RankedPoses>& ranking = result.ranking;
    setRowCount(int(ranking.size()));
    for (std::size_t rank = 0; rank < ranking.size(); ++rank) {
        const RankedPoses& poses = ranking[rank];
        const QString help = posesText(poses) + QLatin1Char('\n') + measuresText(poses);
        auto* picture = cell({}, help);
        if (rank < pictures.size()) {
            picture->setIcon(QPixmap::fromImage(pictures[rank]));
        }
        QString objective = locale().toString(100 * poses.objective, 'f', 1);
        if (!poses.isConfirmed) {
            objective = tr("≈ %1", "about").arg(objective);
        }
        QString reasons =
            rank == 0 && result.current
                ? tr("Compared with your pose: %1")
                      .arg(
                          reasonText(differences(poses, *result.current, settings, result.equator)))
            : rank == 0 ? QString()
                        : reasonText(differences(poses, ranking.front(), settings, result.equator));
        if (const QString advice = adviceOn(poses); !advice.isEmpty()) {
            reasons = (advice + QLatin1Char('\n') + reasons).trimmed();
        }
        if (!poses.tankFaults.isEmpty() && !poses.isConfirmed) { // else the verdict says so
            reasons = (poses.tankFaults.join(QStringLiteral(". ")) + QLatin1Char('\n') + reasons)
                          .trimmed();
        }
        if (poses.limitsMissed > 0) {
            reasons = tr("Does not meet a limit. %1").arg(reasons);
        }
        const int row = int(rank);
        setItem(row, Picture, picture);
        setItem(row, Objective, cell(objective, help));
        setItem(row, Painted,
                cell(measureText(Measure::Coverage, poses.measures[Measure::Coverage]) +
                         QLatin1Char('\n') +
                         measureText(Measure::Stretch, poses.measures[Measure::Stretch]),
                     help));
        setItem(row, Reasons, cell(reasons, reasons + QStringLiteral("\n\n") + help));
    }
}

std::vector<std::size_t> PoseTable::chosen() const {
    std::vector<std::size_t> ranks;
    for (const QModelIndex& index : selectionModel()->selectedRows()) {
        ranks.push_back(std::size_t(index.row()));
    }
    return ranks;
}

void PoseTable::choose(std::size_t rank) {
    selectRow(int(rank));
    scrollToItem(item(int(rank), Picture));
}

} // namespace dipwright
