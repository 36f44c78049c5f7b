// The tree of a project: model, film, dipping, dips, sheet, ink and tolerances. Each dip has the
// sign of its verdict, or of the missing or old result.
#pragma once

#include "workbench/document/Document.h"

#include <QTreeWidget>

namespace dipwright {

enum class ProjectPart { Project, Model, Film, Process, Immersion, Share, Sheet, Ink, Tolerance };

struct ProjectNode {
    ProjectPart part = ProjectPart::Project;
    std::size_t immersion = 0; // for ProjectPart::Immersion
    bool operator==(const ProjectNode&) const = default;
};

class ProjectTree : public QTreeWidget {
    Q_OBJECT

public:
    explicit ProjectTree(QWidget* parent = nullptr);

    void setDocument(Document* document); // may be null
    ProjectNode selectedNode() const;
    void select(const ProjectNode& node);

signals:
    void nodeSelected(const dipwright::ProjectNode& node);
    void addImmersionAsked();
    void removeImmersionAsked(std::size_t number);

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void rebuild();
    void refresh();

    Document* document_ = nullptr;
};

} // namespace dipwright
