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
    QAction* WindowActions::*action; // null: kept elsewhere
    const char* name;                // in the preferences, too
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
        {&A::newWindow, "newWindow", "", tr("New &Window"), tr("Open another window"),
         key("Ctrl+Shift+N")},
        {&A::newProject, "new", "document-new", tr("&New Project…"),
         tr("Make a project of a textured model"), QKeySequence::New},
        {&A::open, "open", "document-open", tr("&Open…"), tr("Open a project"), QKeySequence::Open},
        {&A::save, "save", "document-save", tr("&Save"), tr("Save the project"),
         QKeySequence::Save},
        {&A::saveAs, "saveAs", "", tr("Save &As…"), tr("Save the project as another file"),
         key("Ctrl+Shift+S")},
        {&A::snapshots, "snapshots", "", tr("Snapsho&ts…"),
         tr("Keep the project's settings under a name, compare them, and go back")},
        {&A::exportResults, "exportResults", "export", tr("&Export Results…"),
         tr("Write sheets, stretch maps, proof, films and report to a folder"), key("Ctrl+E")},
        {&A::exportPdf, "exportPdf", "sheet", tr("Sheet as P&DF…"),
         tr("Save this immersion's sheet as PDF at true size")},
        {&A::exportPng, "exportPng", "texture", tr("Sheet as P&NG…"),
         tr("Save this immersion's film image as PNG")},
        {&A::exportCradles, "exportCradles", "export", tr("Crad&les…"),
         tr("Make what holds the body in each dip, as STL and 3MF to print in plastic")},
        {&A::print, "print", "print", tr("&Print…"), tr("Print sheets at true size"),
         QKeySequence::Print},
        {&A::printHistory, "printHistory", "", tr("Print &History…"),
         tr("See what was printed when, on what, and from which project"), key("Ctrl+Shift+H")},
        {&A::jobQueue, "jobQueue", "", tr("&Job Queue…"),
         tr("Run several projects one after the other, and go on working"), key("Ctrl+J")},
        {&A::packJobs, "packJobs", "", tr("Several Jobs on One &Film…"),
         tr("Lay the sheets of several projects, and copies, side by side on a film or roll")},
        {&A::calibrate, "calibratePrinter", "measure", tr("Calibrate P&rinter…"),
         tr("Print a page of rulers and put the printer's scale into its profile")},
        {&A::profiles, "profiles", "", tr("Pro&files…"),
         tr("What is known of printers, films and tanks")},
        {&A::close, "close", "", tr("&Close Window"), tr("Close this window"), QKeySequence::Close},
        {&A::quit, "quit", "", tr("&Quit"), tr("Close all windows"), key("Ctrl+Q"), Kind::Command,
         QAction::QuitRole},
    };
}

std::vector<WindowActions::Entry> WindowActions::editEntries() {
    using A = WindowActions;
    return {
        {&A::undo, "undo", "undo", tr("&Undo"), tr("Take back the last change"),
         QKeySequence::Undo},
        {&A::redo, "redo", "redo", tr("&Redo"), tr("Make the change again"), key("Ctrl+Shift+Z")},
        {&A::addImmersion, "addImmersion", "add", tr("Add &Second Immersion"),
         tr("Dip the body a second time, from another side")},
        {&A::removeImmersion, "removeImmersion", "remove", tr("Remove &Immersion"),
         tr("Remove the immersion shown")},
        {&A::swapImmersions, "swapImmersions", "", tr("S&wap Immersions"),
         tr("Make the second dip the first one")},
        {&A::reloadModel, "reloadModel", "reload", tr("Re&load Model"),
         tr("Read the model's file again and keep all settings"), QKeySequence::Refresh},
        {&A::replaceModel, "replaceModel", "replace", tr("Replace &Model…"),
         tr("Take another model")},
        {&A::replaceTexture, "replaceTexture", "texture", tr("Replace &Texture…"),
         tr("Put another picture on the model")},
        {&A::artwork, "artwork", "artwork", tr("&Artwork"),
         tr("Lay pictures, text and patterns on the body"), key("Ctrl+Shift+A")},
        {&A::preferences, "preferences", "preferences", tr("&Preferences…"),
         tr("Units, language, look, shortcuts and solvers"), key("Ctrl+,"), Kind::Command,
         QAction::PreferencesRole},
    };
}

std::vector<WindowActions::Entry> WindowActions::dipEntries() {
    using A = WindowActions;
    return {
        {&A::run, "run", "run", tr("&Run"), tr("Simulate the dip and make the sheets"),
         key("Ctrl+R")},
        {&A::cancel, "cancel", "cancel", tr("&Cancel"), tr("Stop what is running"), key("Ctrl+.")},
        {&A::live,
         "live",
         "live",
         tr("Run &Live"),
         tr("Once there is a result, run again after each change"),
         {},
         Kind::ToggledOff},
        {&A::findPoses, "findPoses", "optimise", tr("&Find Poses…"),
         tr("Search how the body is best turned and moved, for one dip or two"), key("Ctrl+F")},
        {&A::certainty, "certainty", "", tr("C&heck Certainty…"),
         tr("Compute the sheets more finely and see how far they move, and where")},
        {&A::tolerances, "tolerances", "tolerance", tr("&Tolerances…"),
         tr("See how far colours land off their places for what is off, and which zones keep their "
            "limits")},
        {&A::play, "play", "play", tr("&Play or Pause"), tr("Play the dip"), key("Ctrl+Space")},
    };
}

std::vector<WindowActions::Entry> WindowActions::cameraEntries() {
    using A = WindowActions;
    return {
        {&A::fit, "fit", "fit", tr("&Fit"), tr("Show body and film whole"), key("Ctrl+0")},
        {&A::oblique, "oblique", "view-oblique", tr("&Oblique"), tr("Look from above at an angle"),
         key("Ctrl+1")},
        {&A::front, "front", "view-front", tr("F&ront"), tr("Look from the front"), key("Ctrl+2")},
        {&A::right, "right", "view-right", tr("Ri&ght"), tr("Look from the right"), key("Ctrl+3")},
        {&A::top, "top", "view-top", tr("&Top"), tr("Look from above"), key("Ctrl+4")},
        {&A::back, "back", "", tr("Bac&k"), tr("Look from behind"), key("Ctrl+5")},
        {&A::left, "left", "", tr("&Left"), tr("Look from the left"), key("Ctrl+6")},
        {&A::bottom, "bottom", "", tr("&Bottom"), tr("Look from below"), key("Ctrl+7")},
        {&A::resetLayout, "resetLayout", "", tr("&Standard Layout"),
         tr("Put all panels back where they were at first")},
        {&A::saveLayout, "saveLayout", "", tr("&Save Layout…"),
         tr("Keep where the panels are under a name")},
        {&A::parallel,
         "parallel",
         "parallel",
         tr("&Parallel Projection"),
         tr("Show equal lengths equally long, near or far"),
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
         tr("Rings and Arr&ows"),
         tr("Show the rings that turn the body and the arrows that move it"),
         {},
         Kind::ToggledOn},
        {&A::water,
         "water",
         "water",
         tr("&Water and Tank"),
         tr("Show the water and the edges of the tank"),
         {},
         Kind::ToggledOn},
        {&A::body, "body", "body", tr("Bo&dy"), tr("Show the body"), {}, Kind::ToggledOn},
        {&A::coverage,
         "coverage",
         "proof",
         tr("&Coverage on the Body"),
         tr("Show what the dips paint of the body"),
         {},
         Kind::ToggledOff},
        {&A::bodyPrint,
         "bodyPrint",
         "texture",
         tr("&Print on the Body"),
         tr("Show the body as it comes out of all dips, from every side"),
         {},
         Kind::ToggledOff},
        {&A::zones,
         "zones",
         "tolerance",
         tr("&Zones on the Body"),
         tr("Show the zones of the body and, once tolerances are told, where they keep their "
            "limits"),
         {},
         Kind::ToggledOff},
        {&A::filmOnBody,
         "filmOnBody",
         "film-on-body",
         tr("Film on the Body &Only"),
         tr("At the end of the dip, hide the film that paints nothing"),
         {},
         Kind::ToggledOff},
        {&A::section, "section", "section", tr("&Section"),
         tr("Cut body and film open by a plane that a slider or its frame moves"), key("Ctrl+K"),
         Kind::ToggledOff},
        {&A::seeThrough, "seeThrough", "see-through", tr("S&ee-Through Film"),
         tr("See the body through the film"), key("Ctrl+T"), Kind::ToggledOff},
        {&A::measure, "measure", "measure", tr("&Measure"),
         tr("Click two places on the body to measure the distance between them"), key("Ctrl+M"),
         Kind::ToggledOff},
    };
}

void WindowActions::addFilmLooks() {
    filmLook = new QActionGroup(this);
    const auto addLook = [this](const char* name, const QString& text, FilmLook look, Kind kind) {
        QAction* action =
            add({nullptr, name, "", text, tr("What the film wears in the view"), {}, kind});
        action->setData(int(look));
        filmLook->addAction(action);
    };
    addLook("filmLines", tr("&Lines every 10 mm"), FilmLook::Lines, Kind::ToggledOn);
    addLook("filmSheet", tr("The &Sheet's Image"), FilmLook::Sheet, Kind::ToggledOff);
    addLook("filmStretch", tr("S&tretch"), FilmLook::Stretch, Kind::ToggledOff);
    addLook("filmShares", tr("&Who Paints What"), FilmLook::Shares, Kind::ToggledOff);
    addLook("filmChessboard", tr("&Chessboard of 17 mm"), FilmLook::Chessboard, Kind::ToggledOff);
    addLook("filmPicture", tr("A &Picture…"), FilmLook::Picture, Kind::ToggledOff);
}

// About an axis of the world as a ring of the view shows it, and along the film.
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
        addStep(bodyTurns, name, text, tr("Turn the body by 15°"), step, keys);
    };
    const auto addMove = [&](const char* name, const QString& text, BodyStep step,
                             const char* keys) {
        addStep(bodyMoves, name, text, tr("Move the body over the film"), step, keys);
    };
    addTurn("turnX", tr("Turn about &X by 15°"), {0, 1}, "Ctrl+Alt+X");
    addTurn("turnXBack", tr("Turn about X by −15°"), {0, -1}, "Ctrl+Alt+Shift+X");
    addTurn("turnY", tr("Turn about &Y by 15°"), {1, 1}, "Ctrl+Alt+Y");
    addTurn("turnYBack", tr("Turn about Y by −15°"), {1, -1}, "Ctrl+Alt+Shift+Y");
    addTurn("turnZ", tr("Turn about &Z by 15°"), {2, 1}, "Ctrl+Alt+Z");
    addTurn("turnZBack", tr("Turn about Z by −15°"), {2, -1}, "Ctrl+Alt+Shift+Z");
    addMove("moveRight", tr("Move to the &Right by 5 mm"), {0, 1}, "Alt+Right");
    addMove("moveLeft", tr("Move to the &Left by 5 mm"), {0, -1}, "Alt+Left");
    addMove("moveUp", tr("Move &Up the Sheet by 5 mm"), {2, -1}, "Alt+Up");
    addMove("moveDown", tr("Move &Down the Sheet by 5 mm"), {2, 1}, "Alt+Down");
    addMove("moveToMiddle", tr("Move to the Film's &Middle"), {0, 0}, "Alt+Home");
}

std::vector<WindowActions::Entry> WindowActions::helpEntries() {
    using A = WindowActions;
    return {
        {&A::tour, "tour", "help", tr("Quick &Tour"), tr("What is where, in six steps")},
        {&A::guide, "guide", "report", tr("User &Guide"),
         tr("How everything works, beginning with what has the focus"), QKeySequence::HelpContents},
        {&A::whatsThis, "whatsThis", "", tr("&What Is This?"),
         tr("Click something afterwards to be told what it is for"), QKeySequence::WhatsThis},
        {&A::about, "about", "", tr("&About Dipwright"), {}, {}, Kind::Command, QAction::AboutRole},
    };
}

void WindowActions::enable(const WindowState& state) {
    const bool any = state.document != nullptr;
    const std::size_t immersions = any ? state.document->project().immersions.size() : 0;
    for (QAction* action :
         {saveAs,  snapshots,  replaceModel, replaceTexture, fit,      oblique,   front,  right,
          top,     back,       left,         bottom,         parallel, rings,     water,  body,
          section, seeThrough, measure,      live,           zones,    findPoses, artwork}) {
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
    certainty->setEnabled(any && !state.isBusy);
    tolerances->setEnabled(any && !state.isBusy);
    cancel->setEnabled(state.isBusy);
    for (QAction* action : {print, exportResults, exportPdf, exportPng, exportCradles, coverage,
                            bodyPrint, filmOnBody}) {
        action->setEnabled(any && state.document->result());
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
