#include "InspectionWindow.h"

#include "project/ProjectStore.h"
#include "workbench/widgets/Languages.h"

#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QTabWidget>

namespace dipwright {

namespace {

// Sets the language before any text is made. Returns `folder`.
QString inLanguage(const QString& folder) {
    if (const QString code = qEnvironmentVariable("DIPWRIGHT_PICTURES_LANGUAGE"); !code.isEmpty()) {
        installLanguage(*qApp, code);
    }
    return folder;
}

} // namespace

InspectionWindow::InspectionWindow(const QString& folder)
    : folder_(folder), workbench_(inLanguage(folder)), window_(workbench_), driver_(window_) {
    window_.resize(1280, 800);
    window_.show();
}

bool InspectionWindow::open(const Project& project) {
    const QString file = QDir(folder_).filePath(QStringLiteral("part.dipw"));
    saveProject(project, file);
    if (!driver_.open(file)) {
        return false;
    }
    auto* dock = find<QDockWidget>("inspectionDock");
    dock->show();
    dock->raise();
    return true;
}

void InspectionWindow::show(QWidget* page) {
    find<QTabWidget>("inspection")->setCurrentWidget(page);
}

void InspectionWindow::drop(QWidget& page, const QStringList& files) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& file : files) {
        urls << QUrl::fromLocalFile(file);
    }
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&page, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&page, &event);
}

void InspectionWindow::photograph(const QString& name, int pictures,
                                  const std::function<void(int)>& show) {
    const QString folder = qEnvironmentVariable("DIPWRIGHT_PICTURES");
    if (folder.isEmpty()) {
        return;
    }
    for (const bool dark : {false, true}) {
        Preferences preferences = workbench_.preferences();
        preferences.theme = dark ? ThemeChoice::Dark : ThemeChoice::Light;
        workbench_.setPreferences(preferences);
        for (const QSize size : {QSize(1280, 800), QSize(2560, 1440)}) {
            window_.resize(size);
            for (int number = 0; number < pictures; ++number) {
                show(number);
                QTest::qWait(500);
                window_.view().picture();
                window_.grab().save(
                    QStringLiteral("%1/%2-%3-%4-%5.png")
                        .arg(folder, name, dark ? QStringLiteral("dark") : QStringLiteral("light"))
                        .arg(size.width())
                        .arg(number));
            }
        }
    }
}

} // namespace dipwright
