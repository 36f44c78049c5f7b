// What the user does with documents, and is asked about them: new, open, save, drop, close.
#pragma once

#include "workbench/document/DocumentSession.h"

#include <QUrl>

class QMenu;
class QWidget;

namespace dipwright {

class WindowActions;
class Workbench;

class DocumentController : public QObject {
    Q_OBJECT

public:
    DocumentController(const WindowActions& actions, DocumentSession& session, Messages& messages,
                       Workbench& workbench, QWidget& window);

    void askNew(const QString& model = {});
    void askOpen();
    // Whether `document` is to be opened though `holder` has it open already.
    bool askToOpenLocked(const Document& document, const LockState& holder);
    bool save();   // false: not saved
    bool saveAs(); // false: not saved
    bool mayClose();
    // Another program has written the file since: whether the document is saved all the same.
    bool askToReplaceChanged(const QString& path);
    void fillRecentMenu(QMenu& menu);
    void showSnapshots();
    void packJobs();
    void showPrintHistory();                  // from which a project can be opened
    void takeFiles(const QList<QUrl>& files); // dropped on the window

signals:
    void textureDropped(const QString& path); // on the open document

private:
    bool saveTo(const QString& path);
    void takeFile(const QUrl& file);

    DocumentSession& session_;
    Messages& messages_;
    Workbench& workbench_;
    QWidget& window_;
};

} // namespace dipwright
