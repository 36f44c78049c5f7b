#include "workbench/main/EditController.h"

#include "workbench/actions/WindowActions.h"
#include "workbench/document/ImmersionEdits.h"
#include "workbench/document/ModelImport.h"
#include "workbench/project/NewProjectDialog.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/project/PropertyPanel.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>

namespace dipwright {

QString textureFolder(const ModelOrigin& origin) {
    for (const QString& file : {origin.texture, origin.source}) {
        const QFileInfo folder(QFileInfo(file).absolutePath());
        if (!file.isEmpty() && folder.isDir()) {
            return folder.absoluteFilePath();
        }
    }
    return {};
}

EditController::EditController(const WindowActions& actions, ProjectTree& tree,
                               const PropertyPanel& properties, DipView& view,
                               const DipScene& scene, const DipSession& session, JobRunner& jobs,
                               Messages& messages, QWidget& window)
    : tree_(tree), session_(session), jobs_(jobs), messages_(messages), window_(window),
      bodyMenu_(view, scene, session, *actions.bodyTurns, *actions.bodyMoves) {
    connect(&bodyMenu_, &BodyMenu::refused, &messages,
            [&messages](const QString& sentence) { messages.say(sentence); });
    const auto on = [this](const QAction* action, auto what) {
        connect(action, &QAction::triggered, this, what);
    };
    const auto remove = [this](std::size_t number) {
        removeImmersion(*session_.document(), number);
    };
    on(actions.undo, [this] { session_.document()->undoStack().undo(); });
    on(actions.redo, [this] { session_.document()->undoStack().redo(); });
    on(actions.addImmersion, &EditController::addSecondImmersion);
    on(actions.swapImmersions, [this] { swapImmersions(*session_.document()); });
    on(actions.removeImmersion, [this, remove] { remove(session_.immersion()); });
    on(actions.reloadModel, &EditController::reloadModel);
    on(actions.replaceModel, &EditController::askModel);
    on(actions.replaceTexture, &EditController::askTexture);
    connect(&tree, &ProjectTree::addImmersionAsked, this, &EditController::addSecondImmersion);
    connect(&tree, &ProjectTree::removeImmersionAsked, this, remove);
    connect(&properties, &PropertyPanel::reloadModelAsked, this, &EditController::reloadModel);
    connect(&properties, &PropertyPanel::tessellationAsked, this, [this](Millimetres tolerance) {
        retessellate(*session_.document(), tolerance, jobs_, messages_);
    });
    connect(&properties, &PropertyPanel::replaceModelAsked, this, &EditController::askModel);
    connect(&properties, &PropertyPanel::replaceTextureAsked, this, &EditController::askTexture);
}

void EditController::addSecondImmersion() {
    addImmersion(*session_.document());
    tree_.select({ProjectPart::Immersion, 1});
}

void EditController::reloadModel() {
    dipwright::reloadModel(*session_.document(), jobs_, messages_);
}

void EditController::askModel() {
    const QString path =
        QFileDialog::getOpenFileName(&window_, tr("Replace model"), {}, modelFileFilter());
    if (!path.isEmpty()) {
        replaceModel(*session_.document(), path, jobs_, messages_);
    }
}

void EditController::askTexture() {
    const QString path = QFileDialog::getOpenFileName(
        &window_, tr("Replace texture"), textureFolder(session_.document()->project().modelOrigin),
        pictureFileFilter());
    if (!path.isEmpty()) {
        replaceTexture(path);
    }
}

void EditController::replaceTexture(const QString& path) {
    dipwright::replaceTexture(*session_.document(), path, jobs_, messages_);
}

} // namespace dipwright
