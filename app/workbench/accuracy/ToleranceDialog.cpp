#include "workbench/accuracy/ToleranceDialog.h"

#include "base/NumberText.h"
#include "results/Results.h"
#include "workbench/widgets/PicturePanel.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

namespace dipwright {

namespace {

constexpr int mapEdge = 1200;                // pixels
constexpr double mapPixelsPerMillimetre = 6; // sets the map's size on the screen
constexpr int mostRows = 8;                  // visible without scrolling

QString offBy(double millimetres, LengthUnit unit) {
    return QStringLiteral("±") + shownLength(millimetres, unit);
}

QLabel* sentences(const QStringList& lines) {
    auto* label = new QLabel(withUnitsKept(lines.join(QLatin1Char('\n'))));
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

// Only millimetres are converted to `unit`. Angles and shares are the same in all units.
QString toleranceText(const Contribution& contribution, LengthUnit unit) {
    const QString sign = contributorUnit(contribution.contributor);
    if (sign == QLatin1String("mm")) {
        return offBy(contribution.tolerance, unit);
    }
    const QString space = sign == QStringLiteral("°") ? QString() : QStringLiteral(" ");
    return QStringLiteral("±%1%2%3").arg(QLocale().toString(contribution.tolerance), space, sign);
}

QStringList cells(const Contribution& contribution, LengthUnit unit) {
    return {toleranceText(contribution, unit),
            ToleranceDialog::tr("%1 %").arg(numberText(100 * contribution.share, 1)),
            offBy(contribution.spread.median, unit),
            offBy(contribution.spread.percentile95, unit),
            offBy(contribution.spread.maximum, unit),
            QStringLiteral("−%1, +%2")
                .arg(shownArea(contribution.lost, unit), shownArea(contribution.gained, unit))};
}

QTableWidget* table(const DipTolerances& tolerances, LengthUnit unit) {
    const QStringList columns{ToleranceDialog::tr("Tolerance"), ToleranceDialog::tr("Contribution"),
                              ToleranceDialog::tr("Median"),    ToleranceDialog::tr("95 %"),
                              ToleranceDialog::tr("Maximum"),   ToleranceDialog::tr("Area")};
    const std::vector<Contribution>& contributions = tolerances.contributions;
    auto* table = new QTableWidget(int(contributions.size()), int(columns.size()));
    table->setObjectName(QStringLiteral("contributions"));
    table->setAccessibleName(ToleranceDialog::tr("Effect of each contributor"));
    table->setHorizontalHeaderLabels(columns);
    const QStringList help{
        ToleranceDialog::tr("How far this quantity may deviate, up or down"),
        ToleranceDialog::tr(
            "How much this contributor adds to the total displacement of the image"),
        ToleranceDialog::tr("With this contributor alone, half of the painted area lands within "
                            "this distance of its intended place"),
        ToleranceDialog::tr("With this contributor alone, 95 % of the painted area lands within "
                            "this distance of its intended place"),
        ToleranceDialog::tr("With this contributor alone, the largest displacement on the part"),
        ToleranceDialog::tr("With this contributor alone, the area at the edge of the paint that "
                            "is no longer painted (−) or painted in addition (+)")};
    for (int column = 0; column < columns.size(); ++column) {
        table->horizontalHeaderItem(column)->setToolTip(help[column]);
    }
    QStringList names;
    for (int row = 0; row < table->rowCount(); ++row) {
        const Contribution& contribution = contributions[std::size_t(row)];
        names.append(contributorText(contribution.contributor));
        const QStringList texts = cells(contribution, unit);
        for (int column = 0; column < texts.size(); ++column) {
            auto* item = new QTableWidgetItem(texts[column]);
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table->setItem(row, column, item);
        }
    }
    table->setVerticalHeaderLabels(names);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionMode(QAbstractItemView::ContiguousSelection);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->horizontalHeader()->setSectionResizeMode(int(columns.size()) - 1,
                                                    QHeaderView::ResizeToContents);
    table->setMinimumHeight(table->horizontalHeader()->sizeHint().height() +
                            std::min(mostRows, table->rowCount()) *
                                table->verticalHeader()->defaultSectionSize());
    return table;
}

QStringList dipSentences(const DipTolerances& tolerances, LengthUnit unit) {
    const auto length = [unit](double millimetres) { return shownLength(millimetres, unit); };
    QStringList lines{
        ToleranceDialog::tr("All contributors together: 95 % of the painted area is within %1 of "
                            "its intended place, and half of the area within %2.")
            .arg(offBy(tolerances.spread.percentile95, unit),
                 offBy(tolerances.spread.median, unit))};
    if (tolerances.sampled) {
        lines.append(sampledText(*tolerances.sampled, length));
    }
    for (const WorstPlace& worst : tolerances.worst) {
        lines.append(ToleranceDialog::tr(
                         "Displacement of %1 at the place %2 on the model; largest contributor: %3")
                         .arg(offBy(worst.spread, unit), shownPlace(worst.place, unit),
                              contributorText(worst.contributor)));
    }
    return lines;
}

QWidget* page(const ImmersionResult& immersion, const DipTolerances& tolerances, double limit,
              LengthUnit unit) {
    auto* figures = new QWidget;
    auto* column = new QVBoxLayout(figures);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(table(tolerances, unit), 1);
    column->addWidget(sentences(dipSentences(tolerances, unit)));
    auto* picture = new PicturePanel(ToleranceDialog::tr("Tolerance of the sheet"), {});
    const QImage map = toleranceMap(*immersion.laid, tolerances.filmPoints, limit, mapEdge, unit);
    picture->setPicture(map, QSizeF(map.size()) / mapPixelsPerMillimetre);
    auto* views = new QTabWidget;
    views->setDocumentMode(true);
    views->addTab(figures, ToleranceDialog::tr("Figures"));
    views->addTab(picture, ToleranceDialog::tr("Map"));
    return views;
}

} // namespace

ToleranceDialog::ToleranceDialog(const JobResult& job, const JobTolerances& tolerances,
                                 bool outdated, LengthUnit unit, QWidget* parent)
    : QDialog(parent) {
    setObjectName(QStringLiteral("toleranceDialog"));
    setWindowTitle(tr("Tolerances"));
    auto* layout = new QVBoxLayout(this);
    if (outdated) {
        layout->addWidget(
            sentences({tr("The project has changed since these figures were computed.")}));
    }
    QStringList verdicts;
    for (const ZoneVerdict& zone : tolerances.zones) {
        verdicts.append(
            zoneText(zone, [unit](double millimetres) { return shownLength(millimetres, unit); }));
    }
    QLabel* verdict = sentences(verdicts);
    verdict->setObjectName(QStringLiteral("zoneVerdicts"));
    layout->addWidget(verdict);
    auto* tabs = new QTabWidget;
    tabs->setDocumentMode(true);
    const double limit = job.project.tolerance.limits.back().value();
    for (std::size_t number = 0; number < tolerances.dips.size(); ++number) {
        const ImmersionResult& immersion = job.immersions[number];
        tabs->addTab(page(immersion, tolerances.dips[number], limit, unit),
                     immersion.immersion.name);
    }
    layout->addWidget(tabs, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    resize(900, 700);
}

} // namespace dipwright
