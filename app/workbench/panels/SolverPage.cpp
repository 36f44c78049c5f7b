#include "panels/SolverPage.h"

#include "look/Icons.h"

#include <QDir>
#include <QHeaderView>

namespace dipwright {

SolverPage::SolverPage(const SolverRegistry& registry, QWidget* parent) : QTreeWidget(parent) {
    setAccessibleName(tr("Solvers"));
    setHeaderLabels({tr("Solver"), tr("Version"), tr("Device")});
    setRootIsDecorated(false);
    setAlternatingRowColors(true);
    setWordWrap(true);
    for (const SolverInfo& solver : registry.solvers()) {
        auto* item = new QTreeWidgetItem(this, {solver.name, solver.version});
        item->setIcon(0,
                      icon(solver.available ? QStringLiteral("done") : QStringLiteral("warning")));
        item->setText(2, solver.available ? solver.device : solver.reason);
        for (int column = 0; column < columnCount(); ++column) {
            item->setToolTip(column, tr("%1 by %2\n%3")
                                         .arg(solver.id, solver.vendor,
                                              QDir::toNativeSeparators(solver.modulePath)));
        }
    }
    if (topLevelItemCount() == 0) {
        auto* item = new QTreeWidgetItem(this);
        item->setText(0, tr("None found"));
        item->setText(2, tr("Put solver plugins into %1")
                             .arg(SolverRegistry::standardFolders().join(QStringLiteral(", "))));
    }
    header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
}

} // namespace dipwright
