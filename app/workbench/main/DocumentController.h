// The user's actions on documents, with their questions: new, open, save, drop and close.
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
    // Asks whether to open `document` although `holder` already has it open.
    bool askToOpenLocked(const Document& document, const LockState& holder);
    bool save();   // false: the document was not saved
    bool saveAs(); // false: the document was not saved
    bool mayClose();
    void checkFile(); // tells the user if another program has deleted the document's file
    // Another program has changed the file. Returns whether the document was saved anyway.
    bool askToReplaceChanged(const QString& path);
    void fillRecentMenu(QMenu& menu);
    void showSnapshots();
    void packJobs();
    void showPrintHistory();                  // a project can be opened from it
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
    bool saysFileIsMissing_ = false; // a notice does
};

} // namespace dipwright
