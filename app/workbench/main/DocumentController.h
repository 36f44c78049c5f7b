// The user's actions on documents, with their questions: new, open, save, drop and close.
#pragma once

#include "workbench/document/DocumentSession.h"

#include <QStringList>

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
    void save();
    void saveAs();
    // Waits for the end of a save, and asks whether to save unsaved changes.
    bool mayClose();
    void checkFile(); // tells the user if another program has deleted the document's file
    void fillRecentMenu(QMenu& menu);
    void showSnapshots();
    void packJobs();
    void showPrintHistory();                  // a project can be opened from it
    void takeFiles(const QStringList& files); // dropped on the window

signals:
    void textureDropped(const QString& path); // on the open document

private:
    void askToReplaceChanged(const QString& path); // another program has changed the file
    void waitBrieflyForSave();
    // Waits until no save runs. Returns false if the user no longer wants to close the window.
    bool waitForSave();
    void takeFile(const QString& path);

    DocumentSession& session_;
    Messages& messages_;
    Workbench& workbench_;
    QWidget& window_;
    bool saysFileIsMissing_ = false; // a notice does
};

} // namespace dipwright
