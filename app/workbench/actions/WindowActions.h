// The actions of a window: names, texts, icons and keys of each, and when it can be used. Whoever
// does what they say connects them.
#pragma once

#include <QKeySequence>
#include <QMap>
#include <QObject>

class QAction;
class QActionGroup;
class QWidget;

namespace dipwright {

class Document;

// What decides which actions can be used.
struct WindowState {
    Document* document = nullptr; // null: the start page is shown
    bool isBusy = false;          // with any job
    bool isDipping = false;
    bool isRecorded = false; // there is a dip to play
};

class WindowActions : public QObject {
    Q_OBJECT

public:
    explicit WindowActions(QWidget& window); // adds them to it

    QAction *newWindow, *newProject, *open, *save, *saveAs, *snapshots, *exportResults, *exportPdf,
        *exportPng, *exportCradles, *print, *printHistory, *jobQueue, *packJobs, *calibrate,
        *profiles, *close, *quit;
    QAction *undo, *redo, *addImmersion, *removeImmersion, *swapImmersions, *reloadModel,
        *replaceModel, *replaceTexture, *artwork, *preferences;
    QAction *run, *cancel, *live, *certainty, *tolerances, *findPoses, *play;
    QAction *fit, *oblique, *front, *right, *top, *back, *left, *bottom, *resetLayout, *saveLayout,
        *parallel;
    QAction *rings, *water, *body, *coverage, *bodyPrint, *zones, *filmOnBody, *section,
        *seeThrough, *measure;
    QActionGroup* filmLook; // each has its FilmLook as data
    QActionGroup *bodyTurns,
        *bodyMoves; // each has its BodyStep (workbench/actions/BodyStep.h) as data
    QAction *tour, *guide, *whatsThis, *about;

    void enable(const WindowState& state);
    // By the action's name, where not the standard one.
    void setShortcuts(const QMap<QString, QKeySequence>& chosen);

private:
    struct Entry;
    static std::vector<Entry> fileEntries();
    static std::vector<Entry> editEntries();
    static std::vector<Entry> dipEntries();
    static std::vector<Entry> cameraEntries();
    static std::vector<Entry> displayEntries();
    static std::vector<Entry> helpEntries();
    QAction* add(const Entry& entry);
    void addFilmLooks();
    void addBodySteps();
    void nameUndo(Document* document);

    QWidget& window_;
};

} // namespace dipwright
