#include "workbench/poses/PoseTable.h"

#include "base/NumberText.h"
#include "dip/BodyPath.h"

#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QHeaderView>
#include <QPainter>
#include <QRegularExpression>
#include <QStyledItemDelegate>
#include <QTextCursor>
#include <QTextDocument>

#include <algorithm>
#include <cmath>
#include <span>

namespace dipwright {

namespace {

constexpr QSize pictureSize(56, 56);
constexpr std::size_t shownDifferences = 3; // in the cell; the tool tip has all
constexpr int htmlRole = Qt::UserRole;
// Colours of the signs; both are readable on light and dark windows.
const QString betterColour = QStringLiteral("#008a9a"), worseColour = QStringLiteral("#d2304f");
const QRegularExpression beforeUnit(QStringLiteral("(?<=\\d) "));
enum Column { Picture, Measures, Reasons, Columns };

QString posesText(const RankedPoses& poses) {
    QStringList lines;
    for (const Immersion& immersion : poses.immersions) {
        QStringList angles;
        for (const Degrees& angle : immersion.rotation) {
            angles.append(numberText(angle.value(), 1));
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

// Whether the job would repeat a dip with smaller cells, so that the verdict is only expected.
bool isExpected(const RankedPoses& poses) {
    return std::any_of(poses.verdicts.begin(), poses.verdicts.end(), [](const Verdict& verdict) {
        return std::any_of(verdict.reasons.begin(), verdict.reasons.end(),
                           [](const VerdictReason& reason) {
                               return reason.kind == VerdictReason::Kind::Refined;
                           });
    });
}

// Returns the verdict on confirmed poses and, if they cannot simply be printed, its worst reason.
QString adviceOn(const RankedPoses& poses) {
    if (poses.verdicts.empty()) {
        return {};
    }
    const Advice worst = poses.advice();
    const QString advice = adviceText(worst);
    const QString text = isExpected(poses) ? PoseTable::tr("%1 (expected)").arg(advice) : advice;
    std::vector<Verdict> verdicts = poses.verdicts;
    verdicts.push_back(poses.together);
    for (const Verdict& verdict : verdicts) {
        if (verdict.advice == worst && worst != Advice::Print && !verdict.reasons.empty()) {
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

// Returns two lines, what is better and what is worse, each with a sign, a colour and a word. The
// tool tip of the cell lists the differences that are left out.
QString differencesHtml(const std::vector<MeasureDifference>& differences) {
    if (differences.empty()) {
        return reasonText({}).toHtmlEscaped();
    }
    QStringList better, worse;
    for (const MeasureDifference& difference :
         std::span(differences).first(std::min(differences.size(), shownDifferences))) {
        (difference.isBetter ? better : worse)
            << changeText(difference).replace(beforeUnit, QStringLiteral("&nbsp;"));
    }
    QStringList lines;
    const auto add = [&](const QStringList& changes, const QString& colour, QChar sign,
                         const QString& words) {
        if (!changes.empty()) {
            lines << QStringLiteral("<span style='color:%1'>%2</span> ").arg(colour, sign) +
                         words.toHtmlEscaped().arg(changes.join(QStringLiteral(", ")));
        }
    };
    add(better, betterColour, u'▲', PoseTable::tr("Better: %1"));
    add(worse, worseColour, u'▼', PoseTable::tr("Worse: %1"));
    if (differences.size() > shownDifferences) {
        lines << PoseTable::tr("and %n more", nullptr, int(differences.size() - shownDifferences))
                     .toHtmlEscaped();
    }
    return lines.join(QStringLiteral("<br>"));
}

// Draws a cell's rich text, wrapped to the column.
class ReasonsDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyleOptionViewItem shown = option;
        initStyleOption(&shown, index);
        shown.text.clear();
        const QStyle* style = shown.widget ? shown.widget->style() : QApplication::style();
        style->drawControl(QStyle::CE_ItemViewItem, &shown, painter, shown.widget);
        const bool isSelected = shown.state.testFlag(QStyle::State_Selected);
        QTextDocument document;
        fill(document, index, option.font, shown.rect.width());
        QAbstractTextDocumentLayout::PaintContext context;
        context.palette.setColor(
            QPalette::Text,
            shown.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text));
        if (isSelected) { // the signs and words say what the colours say
            QTextCursor all(&document);
            all.select(QTextCursor::Document);
            QTextCharFormat plain;
            plain.setForeground(context.palette.color(QPalette::Text));
            all.mergeCharFormat(plain);
        }
        painter->save();
        painter->translate(shown.rect.topLeft());
        painter->setClipRect(QRect(QPoint(), shown.rect.size()));
        document.documentLayout()->draw(painter, context);
        painter->restore();
    }
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const auto* table = static_cast<const QTableView*>(parent());
        QTextDocument document;
        fill(document, index, option.font, table->columnWidth(index.column()));
        return {table->columnWidth(index.column()), int(std::ceil(document.size().height()))};
    }

private:
    static void fill(QTextDocument& document, const QModelIndex& index, const QFont& font,
                     int width) {
        document.setDefaultFont(font);
        document.setDocumentMargin(3);
        document.setHtml(index.data(htmlRole).toString());
        document.setTextWidth(width);
    }
};

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
        {tr("Pose"), tr("Objective,\ncoverage,\nstretch"), tr("Verdict,\ndifferences")});
    horizontalHeader()->setSectionResizeMode(Reasons, QHeaderView::Stretch);
    horizontalHeader()->setSectionResizeMode(Picture, QHeaderView::Fixed);
    setColumnWidth(Picture, pictureSize.width() + 8);
    horizontalHeader()->setSectionResizeMode(Measures, QHeaderView::ResizeToContents);
    verticalHeader()->setMinimumSectionSize(pictureSize.height() + 4);
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    setItemDelegateForColumn(Reasons, new ReasonsDelegate(this));
    connect(
        horizontalHeader(), &QHeaderView::sectionResized, this,
        [this](int column) {
            if (column == Reasons) {
                resizeRowsToContents();
            }
        },
        Qt::QueuedConnection); // the scroll bar may still change the width
    setIconSize(pictureSize);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setWordWrap(true);
    setCornerButtonEnabled(false);
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
    const std::vector<std::vector<Immersion>> chosen = chosenPoses();
    setRowCount(int(ranking.size()));
    poses_.clear();
    for (std::size_t rank = 0; rank < ranking.size(); ++rank) {
        const RankedPoses& poses = ranking[rank];
        poses_.push_back(poses.immersions);
        const QString help = posesText(poses) + QLatin1Char('\n') + measuresText(poses);
        auto* picture = cell({}, help);
        if (rank < pictures.size()) {
            picture->setIcon(QPixmap::fromImage(pictures[rank]));
        }
        QString objective = locale().toString(100 * poses.objective, 'f', 1);
        if (!poses.isConfirmed) {
            objective = tr("≈ %1", "about").arg(objective);
        }
        QString reasons, html; // the same in plain and rich text
        const auto compare = [&](const RankedPoses& others, const QString& words) {
            const auto found = differences(poses, others, settings, result.equator);
            reasons = words.arg(reasonText(found));
            html = words.toHtmlEscaped().arg(
                (words == QLatin1String("%1") ? QString() : QStringLiteral("<br>")) +
                differencesHtml(found));
        };
        const auto begin = [&](const QString& words, QChar separator) {
            reasons = (words + separator + reasons).trimmed();
            html = words.toHtmlEscaped() + QStringLiteral("<br>") + html;
        };
        if (rank == 0 && result.current && !poses.areOwn) {
            compare(*result.current, tr("Compared with your pose: %1"));
        } else if (rank > 0) {
            compare(ranking.front(), QStringLiteral("%1"));
        }
        if (const QString advice = adviceOn(poses); !advice.isEmpty()) {
            begin(advice, QLatin1Char('\n'));
        }
        if (!poses.tankFaults.isEmpty() && !poses.isConfirmed) { // else the verdict says so
            begin(poses.tankFaults.join(QStringLiteral(". ")), QLatin1Char('\n'));
        }
        if (poses.limitsMissed > 0) {
            begin(tr("Does not meet a limit."), QLatin1Char(' '));
        }
        if (poses.areOwn) {
            begin(tr("Your pose."), QLatin1Char('\n'));
        }
        const int row = int(rank);
        setItem(row, Picture, picture);
        setItem(row, Measures,
                cell(QStringList{objective,
                                 measureText(Measure::Coverage, poses.measures[Measure::Coverage]),
                                 measureText(Measure::Stretch, poses.measures[Measure::Stretch])}
                         .join(QLatin1Char('\n')),
                     help));
        auto* why = cell(reasons, reasons + QStringLiteral("\n\n") + help);
        why->setData(htmlRole, html);
        setItem(row, Reasons, why);
    }
    choosePoses(chosen);
}

std::vector<std::vector<Immersion>> PoseTable::chosenPoses() const {
    std::vector<std::vector<Immersion>> chosen;
    for (const std::size_t rank : this->chosen()) {
        chosen.push_back(poses_[rank]);
    }
    return chosen;
}

void PoseTable::choosePoses(const std::vector<std::vector<Immersion>>& chosen) {
    QItemSelectionModel* selection = selectionModel();
    selection->clear();
    for (const std::vector<Immersion>& pose : chosen) {
        const auto found = std::find(poses_.begin(), poses_.end(), pose);
        if (found != poses_.end()) {
            const QModelIndex row = model()->index(int(found - poses_.begin()), Picture);
            selection->select(row, QItemSelectionModel::Select | QItemSelectionModel::Rows);
            selection->setCurrentIndex(row, QItemSelectionModel::NoUpdate); // for the arrow keys
        }
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
