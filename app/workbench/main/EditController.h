// The user's edits of the open document as a whole: undo, second dip, replaced model or texture.
#pragma once

#include "workbench/dip/DipSession.h"
#include "workbench/jobs/Messages.h"
#include "workbench/view/BodyMenu.h"

class QWidget;

namespace dipwright {

struct ModelOrigin;
class ProjectTree;
class PropertyPanel;
class WindowActions;

// Returns the folder in which to look for another texture: that of the present texture, else that
// of the model's file. Empty if neither exists.
QString textureFolder(const ModelOrigin& origin);

class EditController : public QObject {
    Q_OBJECT

public:
    // Responds to the actions, the tree, the property panel and the menu of the view.
    EditController(const WindowActions& actions, ProjectTree& tree, const PropertyPanel& properties,
                   DipView& view, const DipScene& scene, const DipSession& session, JobRunner& jobs,
                   Messages& messages, QWidget& window);

    void replaceTexture(const QString& path);

private:
    void addSecondImmersion();
    void reloadModel();
    void askModel();
    void askTexture();

    ProjectTree& tree_;
    const DipSession& session_;
    JobRunner& jobs_;
    Messages& messages_;
    QWidget& window_;
    BodyMenu bodyMenu_;
};

} // namespace dipwright
