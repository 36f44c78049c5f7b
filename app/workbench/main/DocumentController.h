// What the user does with documents, and is asked about them: new, open, save, replace, drop,
// close.
#pragma once

#include "session/DocumentSession.h"

#include <QUrl>

class QMenu;
class QWidget;

namespace dipwright {

class WindowActions;
class Workbench;

class DocumentController : public QObject {
    Q_OBJECT

public:
    DocumentController(const WindowActions& actions, DocumentSession& session, JobRunner& jobs,
                       Messages& messages, const Workbench& workbench, QWidget& window);

    void askNew(const QString& model = {});
    void askOpen();
    // Whether `document` is to be opened though `holder` has it open already.
    bool askToOpenLocked(const Document& document, const LockState& holder);
    bool save();   // false: not saved
    bool saveAs(); // false: not saved
    bool mayClose();
    void fillRecentMenu(QMenu& menu);
    void reloadModel();
    void askModel();
    void askTexture();
    void replaceTexture(const QString& path);
    void takeFiles(const QList<QUrl>& files); // dropped on the window

private:
    bool saveTo(const QString& path);
    void takeFile(const QUrl& file);

    DocumentSession& session_;
    JobRunner& jobs_;
    Messages& messages_;
    const Workbench& workbench_;
    QWidget& window_;
};

} // namespace dipwright
