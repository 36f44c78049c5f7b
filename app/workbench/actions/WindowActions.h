// The actions of a window, with their names, texts, icons and keys, and when they are enabled.
// Controllers connect the actions to their effects.
#pragma once

#include <QKeySequence>
#include <QMap>
#include <QObject>

class QAction;
class QActionGroup;
class QWidget;

namespace dipwright {

class Document;

// Determines which actions are enabled.
struct WindowState {
    Document* document = nullptr; // null: the start page is shown
    bool isBusy = false;          // any job runs
    bool isDipping = false;
    bool isRecorded = false; // there is a dip that can be played, or recorded and then played
    bool hasSheet = false;   // there is a result with a sheet for the dip that is shown
    bool isDraft = false;    // a draft is shown
};

class WindowActions : public QObject {
    Q_OBJECT

public:
    explicit WindowActions(QWidget& window); // adds the actions to `window`

    QAction *newWindow, *newProject, *open, *save, *saveAs, *snapshots, *exportResults, *exportPdf,
        *exportPng, *exportCradles, *makeOutputs, *print, *plates, *printHistory, *jobQueue, *tank,
        *packJobs, *calibrate, *profiles, *close, *quit;
    QAction *undo, *redo, *addImmersion, *removeImmersion, *swapImmersions, *reloadModel,
        *replaceModel, *replaceTexture, *artwork, *preferences;
    QAction *run, *cancel, *live, *sendToServer, *numericalError, *tolerances, *findPoses, *play;
    QAction *fit, *fitPart, *oblique, *front, *right, *top, *back, *left, *bottom, *resetLayout,
        *saveLayout, *parallel;
    QAction *rings, *water, *body, *coverage, *bodyPrint, *zones, *filmOnBody, *wearsFilm, *section,
        *seeThrough, *warnings, *cradle, *measure;
    QActionGroup* filmLook;              // each action's data is its FilmLook
    QActionGroup *bodyTurns, *bodyMoves; // each action's data is its BodyStep
    QAction *tour, *guide, *whatsThis, *about;

    void enable(const WindowState& state);
    // `chosen`: shortcuts that differ from the standard ones, by the action's name.
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
