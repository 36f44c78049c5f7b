// Checks accessibility in all windows and dialogs and in both themes: every control has a name for
// screen readers and can be reached by keyboard, and every text has enough contrast.
#include "Contrast.h"
#include "Patience.h"
#include "TestFolders.h"
#include "WindowDriver.h"
#include "project/ProjectStore.h"
#include "workbench/compare/SnapshotsDialog.h"
#include "workbench/help/GuideWindow.h"
#include "workbench/preferences/PreferencesDialog.h"
#include "workbench/printing/CalibrationDialog.h"
#include "workbench/printing/PackDialog.h"
#include "workbench/printing/PrintDialog.h"
#include "workbench/printing/PrintHistoryDialog.h"
#include "workbench/profiles/ProfilesDialog.h"
#include "workbench/project/NewProjectDialog.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/queue/QueueDialog.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PictureView.h"
#include "workbench/widgets/Theme.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QProgressBar>
#include <QRadioButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTabWidget>
#include <QTextBlock>
#include <QTextEdit>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <cmath>

using namespace dipwright;

namespace {

// Returns whether the widget is a part of a larger widget, which is checked instead.
bool isPart(const QWidget* widget) {
    const QString name = widget->objectName();
    return name.startsWith(QLatin1String("qt_")) || name.startsWith(QLatin1String("Scroll")) ||
           qobject_cast<const QScrollBar*>(widget) || qobject_cast<const QHeaderView*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget->parentWidget()) ||
           qobject_cast<const QComboBox*>(widget->parentWidget()) ||
           qobject_cast<const QDockWidget*>(widget->parentWidget()) ||
           qobject_cast<const QMenuBar*>(widget->parentWidget()) ||
           widget->parentWidget()->inherits("QKeySequenceEdit") ||
           (widget->parentWidget()->parentWidget() &&
            qobject_cast<const QComboBox*>(widget->parentWidget()->parentWidget()));
}

bool isOperated(const QWidget* widget) {
    return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget) ||
           qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSlider*>(widget) ||
           qobject_cast<const QAbstractItemView*>(widget) ||
           qobject_cast<const QTextEdit*>(widget) || qobject_cast<const PictureView*>(widget) ||
           qobject_cast<const DipView*>(widget);
}

bool takesValues(const QWidget* widget) {
    return qobject_cast<const QComboBox*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget) ||
           qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QCheckBox*>(widget) ||
           qobject_cast<const QRadioButton*>(widget) ||
           qobject_cast<const QAbstractSlider*>(widget);
}

QString spokenName(QWidget* widget) {
    const QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(widget);
    return spoken ? spoken->text(QAccessible::Name) : QString();
}

// Returns whether the keyboard reaches the widget. A button of a main tool bar is in a menu, too.
// Other widgets need the focus.
bool isReachable(const QWidget* widget) {
    const auto* button = qobject_cast<const QToolButton*>(widget);
    if (button && qobject_cast<const QToolBar*>(button->parentWidget()) &&
        qobject_cast<const QMainWindow*>(button->parentWidget()->parentWidget())) {
        return true;
    }
    return widget->focusPolicy() & Qt::TabFocus;
}

QColor groundOf(const QWidget* widget) {
    while (!widget->isWindow() && !widget->autoFillBackground()) {
        if (qobject_cast<const QTabWidget*>(widget->parentWidget()->parentWidget())) {
            return widget->palette().color(QPalette::Light); // a page of tabs
        }
        widget = widget->parentWidget();
    }
    return widget->palette().color(widget->backgroundRole());
}

// Returns the faults of coloured text. Signs without letters and digits need less contrast.
QStringList textFaults(const QTextEdit& edit) {
    constexpr double ofText = 4.5, ofSigns = 3;
    const QColor ground = edit.palette().color(QPalette::Base);
    static const QRegularExpression wordSign(QStringLiteral("[\\p{L}\\d]"));
    QStringList faults;
    for (QTextBlock block = edit.document()->begin(); block.isValid(); block = block.next()) {
        for (auto at = block.begin(); !at.atEnd(); ++at) {
            const QTextFragment fragment = at.fragment();
            const QBrush brush = fragment.charFormat().foreground();
            const QString text = fragment.text().trimmed();
            const double least = text.contains(wordSign) ? ofText : ofSigns;
            if (!text.isEmpty() && brush.style() != Qt::NoBrush &&
                contrast(brush.color(), ground) < least) {
                faults += QStringLiteral("“%1” in “%2” has the colour %3 on %4, with a contrast "
                                         "of %5")
                              .arg(text, edit.objectName(), brush.color().name(), ground.name())
                              .arg(contrast(brush.color(), ground));
            }
        }
    }
    return faults;
}

} // namespace

class AccessTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        workbench_ = std::make_unique<Workbench>(folder_.filePath(QStringLiteral("recovery")));
        window_ = std::make_unique<MainWindow>(*workbench_);
        window_->show();
    }
    void cleanupTestCase() {
        window_.reset();
        workbench_.reset();
    }

    void accessibility_startPage_hasNoFaults() { check(*window_); }

    void accessibility_projectAndResults_haveNoFaults() {
        WindowDriver driver(*window_);
        QVERIFY(driver.create(sampleFolder("/models/turtle.obj"),
                              sampleFolder("/models/turtle.png"), 90, [](Project& project) {
                                  project.film.columns = 28;
                                  project.film.rows = 40;
                                  project.fieldResolution = 64;
                                  project.sheet.resolution = DotsPerInch(72);
                              }));
        driver.find<QDockWidget>("logDock")->show();
        auto* tree = driver.find<ProjectTree>("projectTree");
        for (const ProjectPart part :
             {ProjectPart::Project, ProjectPart::Model, ProjectPart::Film, ProjectPart::Process,
              ProjectPart::Sheet, ProjectPart::Ink, ProjectPart::Immersion, ProjectPart::Share,
              ProjectPart::Tolerance}) {
            tree->select({part, 0});
            check(*window_);
        }
        QVERIFY(driver.run());
        auto* results = driver.find<QTabWidget>("results");
        for (int tab = 0; tab < results->count(); ++tab) {
            results->setCurrentIndex(tab);
            check(*window_);
        }
        window_->document()->edit({}, {}, [](Project& project) { project.ink.limit = 1.5; });
        QVERIFY(driver.find<QLabel>("staleBanner")->isVisible());
        check(*window_);
    }

    void accessibility_docks_haveNoFaults() {
        for (auto* dock : window_->findChildren<QDockWidget*>()) {
            const bool wasVisible = dock->isVisible();
            dock->show();
            dock->raise();
            auto* tabs = qobject_cast<QTabWidget*>(dock->widget());
            for (int page = 0; page < (tabs ? tabs->count() : 1); ++page) {
                if (tabs) {
                    tabs->setCurrentIndex(page);
                }
                check(*window_);
            }
            dock->setVisible(wasVisible);
        }
    }

    void accessibility_dialogs_haveNoFaults() {
        NewProjectDialog create({}, workbench_->preferences());
        PreferencesDialog preferences(workbench_->preferences(), workbench_->registry(),
                                      window_->actions());
        PrintDialog print(window_->session().outcome(), 0, {});
        const ProfileLibrary library;
        ProfilesDialog profiles(library, LengthUnit::Millimetre);
        CalibrationDialog calibration(library);
        PrintHistoryDialog history(PrintHistory{}, LengthUnit::Millimetre);
        GuideWindow guide;
        SnapshotsDialog snapshots(*window_->document(), LengthUnit::Millimetre);
        PackDialog pack(workbench_->registry());
        JobQueue jobs(workbench_->registry());
        QueueDialog queue(jobs);
        for (QWidget* dialog :
             {static_cast<QWidget*>(&create), static_cast<QWidget*>(&preferences),
              static_cast<QWidget*>(&print), static_cast<QWidget*>(&profiles),
              static_cast<QWidget*>(&calibration), static_cast<QWidget*>(&history),
              static_cast<QWidget*>(&guide), static_cast<QWidget*>(&snapshots),
              static_cast<QWidget*>(&pack), static_cast<QWidget*>(&queue)}) {
            dialog->show();
            auto* tabs = dialog->findChild<QTabWidget*>();
            for (int page = 0; page < (tabs ? tabs->count() : 1); ++page) {
                if (tabs) {
                    tabs->setCurrentIndex(page);
                }
                check(*dialog);
            }
        }
        WindowDriver(*window_).trigger("tour");
        check(*window_);
        window_->findChild<QWidget*>(QStringLiteral("tour"))->close();
    }

    void accessibility_messages_haveNoFaults() {
        window_->document()->edit(QStringLiteral("Change"), {},
                                  [](Project& project) { project.ink.limit = 1.7; });
        checkMessage("closeQuestion", [this] { window_->close(); });
        const QString copy = workbench_->recovery() + QStringLiteral("/kept.dipw");
        QVERIFY(QDir().mkpath(workbench_->recovery()));
        saveProject(window_->document()->project(), copy);
        checkMessage("recoveryQuestion", [this] { workbench_->offerRecovery(); });
        const QString noPicture = folder_.filePath(QStringLiteral("letter.png"));
        QVERIFY(QFile::copy(copy, noPicture));
        checkMessage("failure", [&] { WindowDriver(*window_).drop(noPicture); });
    }

private:
    // Calls `ask`, waits for the message of that name, checks it and closes it.
    void checkMessage(const char* name, const std::function<void()>& ask) {
        bool checked = false;
        QTimer timer;
        connect(&timer, &QTimer::timeout, this, [&] {
            for (QWidget* widget : QApplication::topLevelWidgets()) {
                if (widget->objectName() == QLatin1String(name) && widget->isVisible()) {
                    timer.stop();
                    check(*widget);
                    widget->close();
                    checked = true;
                    return; // check() lets widgets of the list be deleted
                }
            }
        });
        timer.start(10);
        ask();
        QTRY_VERIFY2_WITH_TIMEOUT(checked, name, patience());
    }
    void check(QWidget& window) {
        QTest::qWait(0); // layouts
        for (const ThemeChoice theme : {ThemeChoice::Light, ThemeChoice::Dark}) {
            Preferences preferences = workbench_->preferences();
            preferences.theme = theme;
            workbench_->setPreferences(preferences);
            QStringList wrong;
            for (QWidget* widget : window.findChildren<QWidget*>()) {
                if (widget->isVisible() && widget->isEnabled() && !isPart(widget)) {
                    wrong += faultsOf(*widget);
                }
            }
            wrong.removeDuplicates();
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
        }
    }

    static QStringList faultsOf(QWidget& widget) {
        const QString what =
            QStringLiteral("%1 “%2” in %3 “%4”")
                .arg(QLatin1String(widget.metaObject()->className()), widget.objectName(),
                     QLatin1String(widget.parentWidget()->metaObject()->className()),
                     widget.parentWidget()->objectName());
        QStringList faults;
        if (isOperated(&widget) && spokenName(&widget).isEmpty()) {
            faults += what + QStringLiteral(" has no name");
        }
        if (qobject_cast<QProgressBar*>(&widget) && spokenName(&widget).isEmpty()) {
            faults += what + QStringLiteral(" has no name");
        }
        if (const auto* edit = qobject_cast<QTextEdit*>(&widget)) {
            faults += textFaults(*edit);
        }
        if (takesValues(&widget) && widget.toolTip().isEmpty() && widget.whatsThis().isEmpty()) {
            faults +=
                what + QStringLiteral(" “%1” has no tool tip or help").arg(spokenName(&widget));
        }
        if (isOperated(&widget) && !isReachable(&widget)) {
            faults += what + QStringLiteral(" cannot be reached by keyboard");
        }
        if (qobject_cast<QAbstractSpinBox*>(&widget) && !qobject_cast<NumberBox*>(&widget)) {
            faults += what + QStringLiteral(" accepts no units and calculations");
        }
        if (const auto* label = qobject_cast<QLabel*>(&widget); label && !label->text().isEmpty()) {
            const double ratio =
                contrast(label->palette().color(label->foregroundRole()), groundOf(label));
            if (ratio < 4.5) {
                faults += QStringLiteral("%1 “%2” has a contrast of %3, expected at least 4.5")
                              .arg(what, label->text())
                              .arg(ratio);
            }
        }
        return faults;
    }

    QTemporaryDir folder_;
    std::unique_ptr<Workbench> workbench_;
    std::unique_ptr<MainWindow> window_;
};

int main(int argc, char** argv) {
    return runWindowTest<AccessTest>(argc, argv);
}
#include "AccessTest.moc"
