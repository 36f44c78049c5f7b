#include "workbench/actions/WindowActions.h"

#include "workbench/actions/BodyStep.h"
#include "workbench/appearance/ViewLooks.h"
#include "workbench/document/Document.h"
#include "workbench/widgets/Icons.h"

#include <QAction>
#include <QActionGroup>
#include <QWidget>

namespace dipwright {

namespace {

enum class Kind { Command, ToggledOff, ToggledOn };

QKeySequence key(const char* text) {
    return QKeySequence(QLatin1String(text));
}

} // namespace

struct WindowActions::Entry {
    QAction* WindowActions::*action; // null: the action belongs to an action group
    const char* name;                // also the key in the preferences
    const char* icon;                // empty: none
    QString text, help;
    QKeySequence keys = {};
    Kind kind = Kind::Command;
    QAction::MenuRole role = QAction::TextHeuristicRole;
};

WindowActions::WindowActions(QWidget& window) : window_(window) {
    for (const auto& entries :
         {fileEntries(), editEntries(), dipEntries(), cameraEntries(), displayEntries()}) {
        for (const Entry& entry : entries) {
            this->*entry.action = add(entry);
        }
    }
    addFilmLooks();
    addBodySteps();
    for (const Entry& entry : helpEntries()) {
        this->*entry.action = add(entry);
    }
}

QAction* WindowActions::add(const Entry& entry) {
    auto* action = new QAction(entry.text, &window_);
    action->setObjectName(QLatin1String(entry.name));
    if (*entry.icon) {
        action->setIcon(icon(QLatin1String(entry.icon)));
    }
    action->setShortcut(entry.keys);
    action->setProperty("defaultShortcut", QVariant::fromValue(entry.keys));
    action->setWhatsThis(entry.help);
    action->setCheckable(entry.kind != Kind::Command);
    action->setChecked(entry.kind == Kind::ToggledOn);
    action->setMenuRole(entry.role);
    window_.addAction(action);
    return action;
}

std::vector<WindowActions::Entry> WindowActions::fileEntries() {
    using A = WindowActions;
    return {
        {&A::newWindow, "newWindow", "", tr("New &window"), tr("Open another window"),
         key("Ctrl+Shift+N")},
        {&A::newProject, "new", "document-new", tr("&New project…"),
         tr("Create a project from a model"), QKeySequence::New},
        {&A::open, "open", "document-open", tr("&Open…"), tr("Open a project"), QKeySequence::Open},
        {&A::save, "save", "document-save", tr("&Save"), tr("Save the project"),
         QKeySequence::Save},
        {&A::saveAs, "saveAs", "", tr("Save &as…"), tr("Save the project as another file"),
         key("Ctrl+Shift+S")},
        {&A::snapshots, "snapshots", "", tr("Snapsho&ts…"),
         tr("Save the settings under a name, compare them and restore them")},
        {&A::exportResults, "exportResults", "export", tr("&Export results…"),
         tr("Write sheets, stretch maps, proof, films and report to a folder"), key("Ctrl+E")},
        {&A::exportPdf, "exportPdf", "sheet", tr("Export sheet as P&DF…"),
         tr("Save the sheet of this dip as PDF at true size")},
        {&A::exportPng, "exportPng", "texture", tr("Export film image as PN&G…"),
         tr("Save the film image of this dip as PNG")},
        {&A::exportCradles, "exportCradles", "export", tr("Export crad&les…"),
         tr("Save a cradle that holds the part in each dip, as STL and 3MF for 3D printing")},
        {&A::makeOutputs, "makeOutputs", "export", tr("Make &outputs…"),
         tr("Write a list of files that is kept with the project, such as everything that the "
            "print "
            "shop needs"),
         key("Ctrl+Shift+E")},
        {&A::print, "print", "print", tr("&Print…"), tr("Print the sheets at true size"),
         QKeySequence::Print},
        {&A::plates, "plates", "ink", tr("Plates…"),
         tr("Show the plates of the sheets, the ink under the cursor, and where there is too much "
            "ink"),
         key("Ctrl+Shift+P")},
        {&A::printHistory, "printHistory", "", tr("Print &history…"),
         tr("Show what was printed, when, on which printer and from which project"),
         key("Ctrl+Shift+H")},
        {&A::jobQueue, "jobQueue", "", tr("&Job queue…"),
         tr("Run several projects one after the other while you keep working"), key("Ctrl+J")},
        {&A::tank, "tank", "", tr("At the tan&k…"),
         tr("Show the steps at the tank in large letters, count their times down and store how "
            "long "
            "they took"),
         key("Ctrl+Shift+K")},
        {&A::packJobs, "packJobs", "", tr("Several jobs on one &film…"),
         tr("Place the sheets of several projects, and copies of them, side by side on a film or "
            "roll")},
        {&A::calibrate, "calibratePrinter", "measure", tr("Calibrate pr&inter…"),
         tr("Print a page with rulers and store the printer's scale in its profile")},
        {&A::profiles, "profiles", "", tr("Pro&files…"),
         tr("Show and edit the profiles of printers, films and tanks")},
        {&A::close, "close", "", tr("&Close window"), tr("Close this window"), QKeySequence::Close},
        {&A::quit, "quit", "", tr("&Quit"), tr("Close all windows"), key("Ctrl+Q"), Kind::Command,
         QAction::QuitRole},
    };
}

std::vector<WindowActions::Entry> WindowActions::editEntries() {
    using A = WindowActions;
    return {
        {&A::undo, "undo", "undo", tr("&Undo"), tr("Undo the last change"), QKeySequence::Undo},
        {&A::redo, "redo", "redo", tr("&Redo"), tr("Redo the change that was undone"),
         key("Ctrl+Shift+Z")},
        {&A::addImmersion, "addImmersion", "add", tr("Add &second dip"),
         tr("Dip the part a second time, from another side")},
        {&A::removeImmersion, "removeImmersion", "remove", tr("Remove &dip"),
         tr("Remove the dip that is shown")},
        {&A::swapImmersions, "swapImmersions", "", tr("S&wap dips"),
         tr("Exchange the order of the two dips")},
        {&A::reloadModel, "reloadModel", "reload", tr("Re&load model"),
         tr("Read the model file again and keep all settings"), QKeySequence::Refresh},
        {&A::replaceModel, "replaceModel", "replace", tr("Replace &model…"),
         tr("Use another model")},
        {&A::replaceTexture, "replaceTexture", "texture", tr("Replace &texture…"),
         tr("Use another image as the texture")},
        {&A::artwork, "artwork", "artwork", tr("&Artwork"),
         tr("Place pictures, text and patterns on the part"), key("Ctrl+Shift+A")},
        {&A::preferences, "preferences", "preferences", tr("&Preferences…"),
         tr("Set units, language, theme, shortcuts and solvers"), key("Ctrl+,"), Kind::Command,
         QAction::PreferencesRole},
    };
}

std::vector<WindowActions::Entry> WindowActions::dipEntries() {
    using A = WindowActions;
    return {
        {&A::run, "run", "run", tr("&Run"), tr("Simulate the dip and compute the sheets"),
         key("Ctrl+R")},
        {&A::cancel, "cancel", "cancel", tr("&Cancel"), tr("Cancel everything that is running"),
         key("Ctrl+.")},
        {&A::sendToServer, "sendToServer", "", tr("Send to ser&ver…"),
         tr("Simulate the dips on another computer, such as one with a GPU, and show the results "
            "here")},
        {&A::live,
         "live",
         "live",
         tr("Run &live"),
         tr("As soon as there is a first result, run again after each change"),
         {},
         Kind::ToggledOff},
        {&A::findPoses, "findPoses", "optimise", tr("&Find poses…"),
         tr("Search for the best rotation and position of the part, for one dip or two"),
         key("Ctrl+F")},
        {&A::numericalError, "certainty", "", tr("Check numerical &error…"),
         tr("Compute the sheets with finer steps and cells, and show where and how far the image "
            "changes")},
        {&A::tolerances, "tolerances", "tolerance", tr("&Tolerances…"),
         tr("Compute how far handling may move the image, and which zones keep their limits")},
        {&A::play, "play", "play", tr("&Play or pause"), tr("Play the dip, or pause it"),
         key("Ctrl+Space")},
    };
}

std::vector<WindowActions::Entry> WindowActions::cameraEntries() {
    using A = WindowActions;
    return {
        {&A::fit, "fit", "fit", tr("&Fit"), tr("Show all of the part and the film"), key("Ctrl+0")},
        {&A::fitPart, "fitPart", "fit-part", tr("&Zoom to part"),
         tr("Show the part as large as possible, without the film around it"), key("Ctrl+8")},
        {&A::oblique, "oblique", "view-oblique", tr("&Oblique"), tr("Look from above at an angle"),
         key("Ctrl+1")},
        {&A::front, "front", "view-front", tr("F&ront"), tr("Look from the front"), key("Ctrl+2")},
        {&A::right, "right", "view-right", tr("Ri&ght"), tr("Look from the right"), key("Ctrl+3")},
        {&A::top, "top", "view-top", tr("&Top"), tr("Look from above"), key("Ctrl+4")},
        {&A::back, "back", "", tr("Bac&k"), tr("Look from behind"), key("Ctrl+5")},
        {&A::left, "left", "", tr("&Left"), tr("Look from the left"), key("Ctrl+6")},
        {&A::bottom, "bottom", "", tr("&Bottom"), tr("Look from below"), key("Ctrl+7")},
        {&A::resetLayout, "resetLayout", "", tr("&Reset layout"),
         tr("Put all panels back into their original places")},
        {&A::saveLayout, "saveLayout", "", tr("&Save layout…"),
         tr("Save the arrangement of the panels under a name")},
        {&A::parallel,
         "parallel",
         "parallel",
         tr("&Parallel projection"),
         tr("Draw near and far places at the same scale, without perspective"),
         {},
         Kind::ToggledOff},
    };
}

std::vector<WindowActions::Entry> WindowActions::displayEntries() {
    using A = WindowActions;
    return {
        {&A::rings,
         "rings",
         "rotate",
         tr("Rings an&d arrows"),
         tr("Show the rings that turn the part and the arrows that move it"),
         {},
         Kind::ToggledOn},
        {&A::water,
         "water",
         "water",
         tr("&Water and tank"),
         tr("Show the water and the edges of the tank"),
         {},
         Kind::ToggledOn},
        {&A::body, "body", "body", tr("P&art"), tr("Show the part"), {}, Kind::ToggledOn},
        {&A::coverage,
         "coverage",
         "proof",
         tr("Co&verage on the part"),
         tr("Show the painted area of the part"),
         {},
         Kind::ToggledOff},
        {&A::bodyPrint,
         "bodyPrint",
         "texture",
         tr("F&inished part"),
         tr("Show the part as it comes out of all dips, from every side"),
         {},
         Kind::ToggledOff},
        {&A::zones,
         "zones",
         "tolerance",
         tr("&Zones on the part"),
         tr("Show the zones of the part. After Dip ▸ Tolerances, also show where the zones stay "
            "within their limits"),
         {},
         Kind::ToggledOff},
        {&A::filmOnBody,
         "filmOnBody",
         "film-on-body",
         tr("Film on the part o&nly"),
         tr("At the end of the dip, hide the film that paints nothing"),
         {},
         Kind::ToggledOff},
        {&A::wearsFilm,
         "wearsFilm",
         "",
         tr("Film on the part before the d&ip"),
         tr("While you place the part, show it with the film of the last results; if this is off, "
            "show the flat film"),
         {},
         Kind::ToggledOn},
        {&A::section, "section", "section", tr("&Section"),
         tr("Cut the part and the film open along a plane; move the plane with its slider or its "
            "frame"),
         key("Ctrl+K"), Kind::ToggledOff},
        {&A::seeThrough, "seeThrough", "see-through", tr("S&ee-through film"),
         tr("Show the part through the film"), key("Ctrl+T"), Kind::ToggledOff},
        {&A::warnings,
         "warnings",
         "warning",
         tr("Warnings on t&he part"),
         tr("Mark trapped air, torn film and places that are not reached. Click a mark to see it "
            "in "
            "the report"),
         {},
         Kind::ToggledOn},
        {&A::cradle,
         "cradle",
         "",
         tr("Cradle aro&und the part"),
         tr("Make the cradle of this dip and show it, before you export it"),
         {},
         Kind::ToggledOff},
        {&A::measure, "measure", "measure", tr("&Measure"),
         tr("Click two places on the part to measure the straight distance between them, and the "
            "distance along the surface"),
         key("Ctrl+M"), Kind::ToggledOff},
    };
}

void WindowActions::addFilmLooks() {
    filmLook = new QActionGroup(this);
    const auto addLook = [this](const char* name, const QString& text, FilmLook look, Kind kind) {
        QAction* action =
            add({nullptr, name, "", text, tr("What the film shows in the 3D view"), {}, kind});
        action->setData(int(look));
        filmLook->addAction(action);
    };
    addLook("filmLines", tr("&Lines every 10 mm"), FilmLook::Lines, Kind::ToggledOff);
    addLook("filmSheet", tr("Film &image"), FilmLook::Sheet, Kind::ToggledOn);
    addLook("filmStretch", tr("S&tretch"), FilmLook::Stretch, Kind::ToggledOff);
    addLook("filmShares", tr("&Shares of the dips"), FilmLook::Shares, Kind::ToggledOff);
    addLook("filmChessboard", tr("&Chessboard, 17 mm squares"), FilmLook::Chessboard,
            Kind::ToggledOff);
    addLook("filmPicture", tr("&Picture from file…"), FilmLook::Picture, Kind::ToggledOff);
}

// Adds turns about the axes of the view's rings, and moves along the film.
void WindowActions::addBodySteps() {
    bodyTurns = new QActionGroup(this);
    bodyMoves = new QActionGroup(this);
    const auto addStep = [this](QActionGroup* group, const char* name, const QString& text,
                                const QString& help, BodyStep step, const char* keys) {
        QAction* action = add({nullptr, name, "", text, help, key(keys)});
        action->setData(QVariant::fromValue(step));
        group->addAction(action);
    };
    const auto addTurn = [&](const char* name, const QString& text, BodyStep step,
                             const char* keys) {
        addStep(bodyTurns, name, text, tr("Turn the part by 15°"), step, keys);
    };
    const auto addMove = [&](const char* name, const QString& text, BodyStep step,
                             const char* keys) {
        addStep(bodyMoves, name, text, tr("Move the part over the film"), step, keys);
    };
    addTurn("turnX", tr("Turn about &X by 15°"), {0, 1}, "Ctrl+Alt+X");
    addTurn("turnXBack", tr("Turn about X by −15°"), {0, -1}, "Ctrl+Alt+Shift+X");
    addTurn("turnY", tr("Turn about &Y by 15°"), {1, 1}, "Ctrl+Alt+Y");
    addTurn("turnYBack", tr("Turn about Y by −15°"), {1, -1}, "Ctrl+Alt+Shift+Y");
    addTurn("turnZ", tr("Turn about &Z by 15°"), {2, 1}, "Ctrl+Alt+Z");
    addTurn("turnZBack", tr("Turn about Z by −15°"), {2, -1}, "Ctrl+Alt+Shift+Z");
    addMove("moveRight", tr("Move &right by 5 mm"), {0, 1}, "Alt+Right");
    addMove("moveLeft", tr("Move &left by 5 mm"), {0, -1}, "Alt+Left");
    addMove("moveUp", tr("Move &up the sheet by 5 mm"), {2, -1}, "Alt+Up");
    addMove("moveDown", tr("Move &down the sheet by 5 mm"), {2, 1}, "Alt+Down");
    addMove("moveToMiddle", tr("Move to the &middle of the film"), {0, 0}, "Alt+Home");
}

std::vector<WindowActions::Entry> WindowActions::helpEntries() {
    using A = WindowActions;
    return {
        {&A::tour, "tour", "help", tr("Quick &tour"),
         tr("Explain the areas of the window in six steps")},
        {&A::guide, "guide", "report", tr("User &guide"),
         tr("Open the user guide at the section about the selected field"),
         QKeySequence::HelpContents},
        {&A::whatsThis, "whatsThis", "", tr("&What is this?"),
         tr("Click an element of the window to see what it does"), QKeySequence::WhatsThis},
        {&A::about, "about", "", tr("&About Dipwright"), {}, {}, Kind::Command, QAction::AboutRole},
    };
}

void WindowActions::enable(const WindowState& state) {
    const bool any = state.document != nullptr;
    const std::size_t immersions = any ? state.document->project().immersions.size() : 0;
    for (QAction* action :
         {saveAs, snapshots, replaceModel, replaceTexture, fit,        fitPart, oblique,
          front,  right,     top,          back,           left,       bottom,  parallel,
          rings,  water,     body,         section,        seeThrough, measure, live,
          zones,  findPoses, artwork,      warnings}) {
        action->setEnabled(any);
    }
    for (QActionGroup* group : {filmLook, bodyTurns, bodyMoves}) {
        group->setEnabled(any);
    }
    save->setEnabled(any && state.document->isModified());
    reloadModel->setEnabled(any && !state.document->project().modelOrigin.source.isEmpty());
    addImmersion->setEnabled(any && immersions < 2);
    removeImmersion->setEnabled(immersions > 1);
    swapImmersions->setEnabled(immersions > 1);
    run->setEnabled(any && !state.isDipping);
    sendToServer->setEnabled(any && !state.isBusy);
    numericalError->setEnabled(any && !state.isBusy);
    tolerances->setEnabled(any && !state.isBusy);
    cancel->setEnabled(state.isBusy);
    for (QAction* action : {coverage, bodyPrint, filmOnBody}) {
        action->setEnabled(state.hasSheet);
    }
    // What is exported or printed is what is on show.
    for (QAction* action : {exportResults, exportPdf, exportPng, exportCradles, cradle, makeOutputs,
                            print, tank, plates}) {
        action->setEnabled(state.hasSheet && !state.isDraft);
    }
    play->setEnabled(state.isRecorded);
    nameUndo(state.document);
}

void WindowActions::nameUndo(Document* document) {
    const QUndoStack* steps = document ? &document->undoStack() : nullptr;
    undo->setEnabled(steps && steps->canUndo());
    redo->setEnabled(steps && steps->canRedo());
    undo->setText(undo->isEnabled() ? tr("&Undo “%1”").arg(steps->undoText()) : tr("&Undo"));
    redo->setText(redo->isEnabled() ? tr("&Redo “%1”").arg(steps->redoText()) : tr("&Redo"));
}

void WindowActions::setShortcuts(const QMap<QString, QKeySequence>& chosen) {
    for (QAction* action : window_.actions()) {
        const auto standard = action->property("defaultShortcut").value<QKeySequence>();
        action->setShortcut(chosen.value(action->objectName(), standard));
        const QString help = action->whatsThis();
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        if (!help.isEmpty()) {
            action->setToolTip(keys.isEmpty() ? help : tr("%1 (%2)").arg(help, keys));
        }
    }
}

} // namespace dipwright
