#include "workbench/preferences/SolverPage.h"

#include "workbench/jobs/SolverListing.h"
#include "workbench/widgets/Icons.h"
#include "workbench/widgets/ShippedNames.h"

#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace dipwright {

namespace {

// Fits the row heights to the wrapped text of the last column, which QTreeWidget does not do.
void fitRows(QTreeWidget& list) {
    constexpr int margin = 6;
    for (int row = 0; row < list.topLevelItemCount(); ++row) {
        QTreeWidgetItem& item = *list.topLevelItem(row);
        const QRect room(0, 0, list.columnWidth(2) - 2 * margin, 1000);
        const QRect text = list.fontMetrics().boundingRect(room, Qt::TextWordWrap, item.text(2));
        item.setSizeHint(2, {0, text.height() + margin});
    }
}

} // namespace

SolverPage::SolverPage(const SolverRegistry& registry, QWidget* parent)
    : QWidget(parent), list_(new QTreeWidget) {
    QTreeWidget* const list = list_;
    list->setAccessibleName(tr("Solvers"));
    list->setHeaderLabels({tr("Solver"), tr("Version"), tr("Device")});
    list->setRootIsDecorated(false);
    list->setAlternatingRowColors(true);
    list->setWordWrap(true);
    list->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    connect(list->header(), &QHeaderView::sectionResized, list, [list] { fitRows(*list); });
    auto* hint = new QLabel(tr("Choose the solver of a project under Dipping. “Best available” "
                               "uses the best solver that can run on this computer."));
    hint->setWordWrap(true);
    hint->setForegroundRole(QPalette::PlaceholderText);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(list);
    layout->addWidget(hint);
    new SolverListing(
        registry, [this](const std::vector<SolverInfo>& solvers) { show(solvers); }, this);
}

void SolverPage::show(const std::vector<SolverInfo>& solvers) {
    list_->clear();
    for (const SolverInfo& solver : solvers) {
        auto* item = new QTreeWidgetItem(list_, {shownName(solver.name), solver.version});
        const bool isKnown = solver.available || !solver.reason.isEmpty();
        if (isKnown) {
            item->setIcon(
                0, icon(solver.available ? QStringLiteral("done") : QStringLiteral("warning")));
        }
        item->setText(2, !isKnown           ? tr("Checking whether this solver can run here …")
                         : solver.available ? solver.device
                                            : shownName(solver.reason));
        for (int column = 0; column < list_->columnCount(); ++column) {
            item->setToolTip(column, tr("%1 by %2\n%3")
                                         .arg(solver.id, solver.vendor,
                                              QDir::toNativeSeparators(solver.modulePath)));
        }
    }
    if (solvers.empty()) {
        auto* item = new QTreeWidgetItem(list_);
        item->setText(0, tr("No solver found"));
        item->setText(2, tr("Put solver plugins into %1")
                             .arg(SolverRegistry::standardFolders().join(QStringLiteral(", "))));
    }
    fitRows(*list_);
}

} // namespace dipwright
