#include "workbench/project/ProjectTree.h"

#include "workbench/project/PropertySpecs.h"
#include "workbench/widgets/Icons.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>

namespace dipwright {

namespace {

constexpr int partRole = Qt::UserRole;
constexpr int immersionRole = Qt::UserRole + 1;

ProjectNode nodeOf(const QTreeWidgetItem& item) {
    return {ProjectPart(item.data(0, partRole).toInt()), item.data(0, immersionRole).toULongLong()};
}

QTreeWidgetItem* addItem(QTreeWidgetItem* parent, const QString& text, const QString& iconName,
                         const ProjectNode& node) {
    auto* item = new QTreeWidgetItem(parent, {text});
    item->setIcon(0, icon(iconName));
    item->setData(0, partRole, int(node.part));
    item->setData(0, immersionRole, qulonglong(node.immersion));
    return item;
}

// Returns the sign of a verdict.
QString iconOf(Advice advice) {
    switch (advice) {
    case Advice::Print:
        return QStringLiteral("done");
    case Advice::CheckFirst:
        return QStringLiteral("warning");
    case Advice::DoNotPrint:
        return QStringLiteral("do-not-print");
    case Advice::NotJudged:
        break;
    }
    return QStringLiteral("none");
}

} // namespace

ProjectTree::ProjectTree(QWidget* parent) : QTreeWidget(parent) {
    setObjectName(QStringLiteral("projectTree"));
    setAccessibleName(tr("Project"));
    setHeaderHidden(true);
    setColumnCount(2);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
    header()->setSectionResizeMode(1, QHeaderView::Fixed);
    header()->resizeSection(1, 28);
    setIndentation(14);
    setFrameShape(QFrame::NoFrame);
    connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (item) {
            emit nodeSelected(nodeOf(*item));
        }
    });
}

void ProjectTree::setDocument(Document* document) {
    document_ = document;
    if (document) {
        connect(document, &Document::projectChanged, this, &ProjectTree::refresh);
        connect(document, &Document::resultChanged, this, &ProjectTree::refresh);
        connect(document, &Document::fileChanged, this, &ProjectTree::refresh);
    }
    rebuild();
}

void ProjectTree::rebuild() {
    const ProjectNode selected = selectedNode();
    {
        const QSignalBlocker quiet(this);
        clear();
        if (document_) {
            const Project& project = document_->project();
            const auto add = [&](QTreeWidgetItem* parent, const char* iconName,
                                 const ProjectNode& node) {
                return addItem(parent, partName(node, project), QLatin1String(iconName), node);
            };
            auto* root = add(invisibleRootItem(), "document-new", {ProjectPart::Project});
            add(root, "body", {ProjectPart::Model});
            add(root, "film", {ProjectPart::Film});
            add(root, "process", {ProjectPart::Process});
            for (std::size_t number = 0; number < project.immersions.size(); ++number) {
                add(root, "immersion", {ProjectPart::Immersion, number});
            }
            if (project.immersions.size() > 1) {
                add(root, "join", {ProjectPart::Share});
            }
            add(root, "sheet", {ProjectPart::Sheet});
            add(root, "ink", {ProjectPart::Ink});
            add(root, "tolerance", {ProjectPart::Tolerance});
            expandAll();
        }
    }
    refresh();
    select(selected);
}

void ProjectTree::refresh() {
    if (!document_) {
        return;
    }
    const Project& project = document_->project();
    std::size_t shown = 0;
    for (QTreeWidgetItemIterator item(this); *item; ++item) {
        shown += nodeOf(**item).part == ProjectPart::Immersion;
    }
    if (shown != project.immersions.size()) {
        rebuild();
        return;
    }
    for (QTreeWidgetItemIterator entry(this); *entry; ++entry) {
        QTreeWidgetItem& item = **entry;
        const ProjectNode node = nodeOf(item);
        if (node.part == ProjectPart::Project) {
            item.setText(0, project.name);
        } else if (node.part == ProjectPart::Immersion) {
            item.setText(0, project.immersions[node.immersion].name);
            const auto result = document_->result();
            if (document_->isFresh(JobStep::Sheet, node.immersion)) {
                const Advice advice = worst(result->immersions[node.immersion].verdict.advice,
                                            result->verdict.advice);
                item.setIcon(1, icon(iconOf(advice)));
                item.setToolTip(1, QStringLiteral("%1. %2").arg(adviceText(advice),
                                                                tr("The result is up to date.")));
            } else {
                item.setIcon(1, icon(result ? QStringLiteral("stale") : QStringLiteral("none")));
                item.setToolTip(1, result ? tr("Changed since the last run. Run again.")
                                          : tr("Not simulated yet."));
            }
        }
    }
}

ProjectNode ProjectTree::selectedNode() const {
    return currentItem() ? nodeOf(*currentItem()) : ProjectNode{ProjectPart::Immersion, 0};
}

void ProjectTree::select(const ProjectNode& node) {
    for (QTreeWidgetItemIterator item(this); *item; ++item) {
        const ProjectNode own = nodeOf(**item);
        if (own.part == node.part && (own == node || node.part != ProjectPart::Immersion)) {
            setCurrentItem(*item);
            return;
        }
    }
    if (node.part == ProjectPart::Immersion && node.immersion > 0) {
        select({ProjectPart::Immersion, 0});
    }
}

void ProjectTree::contextMenuEvent(QContextMenuEvent* event) {
    if (!document_) {
        return;
    }
    QMenu menu;
    const ProjectNode node = selectedNode();
    const std::size_t count = document_->project().immersions.size();
    QAction* add = menu.addAction(icon(QStringLiteral("add")), tr("Add second dip"));
    add->setEnabled(count < 2);
    connect(add, &QAction::triggered, this, &ProjectTree::addImmersionAsked);
    QAction* remove = menu.addAction(icon(QStringLiteral("remove")), tr("Remove this dip"));
    remove->setEnabled(count > 1 && node.part == ProjectPart::Immersion);
    connect(remove, &QAction::triggered, this,
            [this, node] { emit removeImmersionAsked(node.immersion); });
    menu.exec(event->globalPos());
}

} // namespace dipwright
