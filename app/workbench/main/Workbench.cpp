#include "workbench/main/Workbench.h"

#include "workbench/document/Recovery.h"
#include "workbench/help/GuideWindow.h"
#include "workbench/main/MainWindow.h"
#include "workbench/queue/QueueDialog.h"
#include "workbench/widgets/Theme.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include <functional>

namespace dipwright {

namespace {

Theme themeOf(ThemeChoice choice) {
    switch (choice) {
    case ThemeChoice::Light:
        return Theme::Light;
    case ThemeChoice::Dark:
        return Theme::Dark;
    case ThemeChoice::System:
        break;
    }
    return Theme::System;
}

// Returns a visible window that `fits`; null if there is none.
MainWindow* findWindow(const std::function<bool(MainWindow&)>& fits) {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        auto* window = qobject_cast<MainWindow*>(widget);
        if (window && window->isVisible() && fits(*window)) {
            return window;
        }
    }
    return nullptr;
}

} // namespace

Workbench::Workbench(const QString& recovery, QObject* parent)
    : QObject(parent), plainTexts_(*qApp), wheelGuard_(*qApp), recovery_(recovery),
      preferences_(loadPreferences()), queue_(registry_), tank_([this](const QString& path) {
          MainWindow* window = windowOf(path);
          return window ? window->document() : nullptr;
      }) {
    qApp->installEventFilter(this);
    queue_.setKeepsDips(preferences_.keepsResults);
    applyTheme(*qApp, themeOf(preferences_.theme));
}

Workbench::~Workbench() {
    delete queueWindow_;
}

void Workbench::setPreferences(const Preferences& preferences) {
    if (preferences == preferences_) {
        return;
    }
    preferences_ = preferences;
    queue_.setKeepsDips(preferences.keepsResults);
    savePreferences(preferences);
    applyTheme(*qApp, themeOf(preferences.theme));
    emit preferencesChanged();
}

MainWindow* Workbench::openWindow() {
    auto* window = new MainWindow(*this);
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->show();
    return window;
}

MainWindow* Workbench::emptyWindow() {
    MainWindow* empty = findWindow([](MainWindow& window) { return window.isEmpty(); });
    return empty ? empty : openWindow();
}

MainWindow* Workbench::windowOf(const QString& path) const {
    return findWindow(
        [&](MainWindow& window) { return window.document() && window.documents().has(path); });
}

bool Workbench::bringForward(const QString& path) {
    MainWindow* window = windowOf(path);
    if (window) {
        window->setWindowState(window->windowState() & ~Qt::WindowMinimized);
        window->raise();
        window->activateWindow();
    }
    return window;
}

void Workbench::showQueue(const QString& project) {
    if (!queueWindow_) {
        queueWindow_ = new QueueDialog(queue_);
        queueWindow_->setAttribute(Qt::WA_DeleteOnClose);
        queueWindow_->setAttribute(Qt::WA_QuitOnClose); // it may outlive the main windows
        connect(queueWindow_, &QueueDialog::projectAsked, this, [this](const QString& path) {
            if (!bringForward(path)) {
                emptyWindow()->documents().openProject(path);
            }
        });
        connect(queueWindow_, &QueueDialog::tankAsked, this,
                [this](const std::vector<TankJob>& jobs) { showTank(jobs, nullptr); });
    }
    queueWindow_->propose(project);
    queueWindow_->show();
    queueWindow_->raise();
    queueWindow_->activateWindow();
}

bool Workbench::eventFilter(QObject* watched, QEvent* event) {
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (event->type() == QEvent::KeyPress && widget &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::HelpContents) &&
        !qobject_cast<MainWindow*>(widget->window())) {
        showGuide(widget, *widget->window());
        return true;
    }
    return QObject::eventFilter(watched, event);
}

void Workbench::offerRecovery() {
    for (const RecoveredDocument& recovered : findRecoveredDocuments(recovery_)) {
        QMessageBox question(
            QMessageBox::Question, tr("Restore project"),
            tr("Dipwright was not closed properly. “%1” has unsaved changes from %2.")
                .arg(recovered.name, QLocale().toString(recovered.saved, QLocale::ShortFormat)));
        question.setInformativeText(recovered.original.isEmpty()
                                        ? tr("The project was never saved to a file.")
                                        : tr("The file %1 still holds the last saved version.")
                                              .arg(QDir::toNativeSeparators(recovered.original)));
        question.setObjectName(QStringLiteral("recoveryQuestion"));
        QPushButton* restore = question.addButton(tr("Restore"), QMessageBox::AcceptRole);
        QPushButton* discard =
            question.addButton(tr("Discard changes"), QMessageBox::DestructiveRole);
        question.addButton(tr("Decide later"), QMessageBox::RejectRole);
        question.setDefaultButton(restore);
        question.exec();
        if (question.clickedButton() == restore) {
            MainWindow* window = findWindow(
                [&](MainWindow& found) { return found.documents().has(recovered.original); });
            (window ? window : emptyWindow())->documents().restore(recovered);
        } else if (question.clickedButton() == discard) {
            discardRecovered(recovered);
        }
    }
}

} // namespace dipwright
